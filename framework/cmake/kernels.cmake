# luch_widest_vectors(target): its kernels of level v4 are loops over memory, for which vectors of 64
# bytes pay; the compiler by itself takes those of 32.
function(luch_widest_vectors target)
  if(TARGET ${target}_v4)
    target_compile_options(${target}_v4 PRIVATE -mprefer-vector-width=512)
  endif()
endfunction()

# luch_kernels(target source…): compiles kernel files into `target` once for every level of x86-64
# and once in plain C++. Each defines one entry, named after LUCH_LEVEL (plain, v2, v3, v4), which
# the program chooses from at run time. Always optimised: what is not inlined would become a weak
# symbol, and the linker might keep a copy that older machines cannot run.
function(luch_kernels target)
  set(levels plain)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND levels v2 v3 v4)
    target_compile_definitions(${target} PRIVATE LUCH_X86_64_LEVELS)
  endif()
  foreach(level IN LISTS levels)
    set(kernel ${target}_${level})
    add_library(${kernel} OBJECT ${ARGN})
    target_compile_definitions(${kernel} PRIVATE LUCH_LEVEL=${level} NDEBUG)
    # Sanitizers would take minutes for each level to compile. -Wno-…: GCC 12 warns of its own AVX-512
    # headers (GCC bug 105593).
    target_compile_options(${kernel} PRIVATE -O3 -fno-exceptions -fno-sanitize=all)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${kernel} PRIVATE -Wno-uninitialized -Wno-maybe-uninitialized)
    endif()
    if(level STREQUAL "plain")
      target_compile_definitions(${kernel} PRIVATE LUCH_PLAIN_LANES)
    else()
      target_compile_options(${kernel} PRIVATE -march=x86-64-${level} -mtune=skylake-avx512)
    endif()
    get_target_property(includes ${target} LINK_LIBRARIES)
    target_link_libraries(${kernel} PRIVATE ${includes})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${kernel}>)
    set_property(GLOBAL APPEND PROPERTY LUCH_KERNELS ${kernel})
  endforeach()
endfunction()
