# Language, warnings and floating-point rules for every target.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    # Trees in other folders (a worktree, the students' kit) find what this one compiled: paths are
    # made relative, and no debug information holds the folder.
    set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
  endif()
endif()
find_program(MOLD mold)
if(MOLD)
  add_link_options(-fuse-ld=mold)
endif()

option(LUCH_WERROR "Warnings are errors" ON)
set(LUCH_SANITIZE "" CACHE STRING "-fsanitize= list, for example address,undefined")

# Contraction alone made the watertight triangle test leak; fast math is ruled out for good.
add_compile_options(-Wall -Wextra -Wshadow -ffp-contract=off -fno-math-errno)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  add_compile_options(-Wno-restrict)  # warns of the standard library's own strings (GCC bug 105329)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  add_compile_options(-Wno-bitwise-instead-of-logical)  # meant so: lanes have no branches
endif()
if(LUCH_WERROR)
  add_compile_options(-Werror)
endif()
if(LUCH_SANITIZE)
  add_compile_options(-fsanitize=${LUCH_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${LUCH_SANITIZE})
endif()
include_directories(${CMAKE_SOURCE_DIR})
