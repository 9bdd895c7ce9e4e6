# luch_layer(name SOURCES … LINK …): a layer of the framework, the static library luch_<name>.
function(luch_layer name)
  cmake_parse_arguments(layer "" "" "SOURCES;LINK;PRIVATE" ${ARGN})
  add_library(luch_${name} STATIC ${layer_SOURCES})
  target_link_libraries(luch_${name} PUBLIC ${layer_LINK} PRIVATE ${layer_PRIVATE})
endfunction()

# luch_test(name source…): a GoogleTest program; each of its tests is a test of ctest.
function(luch_test name)
  cmake_parse_arguments(test "" "" "LINK" ${ARGN})
  add_executable(test_${name} ${test_UNPARSED_ARGUMENTS})
  target_link_libraries(test_${name} PRIVATE ${test_LINK} GTest::gmock_main)
  target_compile_definitions(test_${name} PRIVATE LUCH_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  gtest_discover_tests(test_${name} DISCOVERY_TIMEOUT 60 WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
                       PROPERTIES TIMEOUT 300)
endfunction()

# Every folder of techniques/ and homework/ with a CMakeLists.txt is a module; nothing else names it.
function(add_modules parent)
  file(GLOB lists CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${parent}/*/CMakeLists.txt)
  foreach(list IN LISTS lists)
    get_filename_component(dir ${list} DIRECTORY)
    add_subdirectory(${dir})
  endforeach()
endfunction()

function(luch_module kind name)
  cmake_parse_arguments(module "" "" "TESTS" ${ARGN})
  set(target ${kind}_${name})
  add_library(${target} STATIC ${module_UNPARSED_ARGUMENTS})
  target_link_libraries(${target} PUBLIC luch_baseline $<TARGET_NAME_IF_EXISTS:luch_raster>)
  set_property(GLOBAL APPEND PROPERTY LUCH_MODULES ${kind}::${name})
  if(module_TESTS AND BUILD_TESTING)
    luch_test(${target} ${module_TESTS} LINK ${target} luch_testing)
  endif()
endfunction()

# add_technique(name source… TESTS source…): the one call of a technique's CMakeLists.txt.
function(add_technique name)
  luch_module(techniques ${name} ${ARGN})
endfunction()

# add_homework(name source… CHECK source… TESTS source…): the one call of a homework's
# CMakeLists.txt. CHECK: its tasks and their tests, which go into a program of their own, check_name,
# so that little is linked after a step was changed; `luch check` builds and runs it.
function(add_homework name)
  cmake_parse_arguments(homework "" "" "CHECK;TESTS" ${ARGN})
  luch_module(homework ${name} ${homework_UNPARSED_ARGUMENTS} TESTS ${homework_TESTS})
  # A hole does nothing with what it is given.
  target_compile_options(homework_${name} PRIVATE -Wno-unused-parameter)
  target_link_libraries(homework_${name} PUBLIC $<TARGET_NAME_IF_EXISTS:techniques_${name}>)
  if(homework_CHECK)
    add_library(homework_${name}_check STATIC ${homework_CHECK})
    target_link_libraries(homework_${name}_check PUBLIC homework_${name} luch_grading fmt::fmt)
    configure_file(${CMAKE_SOURCE_DIR}/framework/cmake/check_main.cpp.in check_main.cpp @ONLY)
    add_executable(check_${name} ${CMAKE_CURRENT_BINARY_DIR}/check_main.cpp)
    target_link_libraries(check_${name} PRIVATE homework_${name}_check luch_check_program)
    set_target_properties(check_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY
                                                   ${CMAKE_CURRENT_BINARY_DIR})
  endif()
endfunction()

# The list of all techniques, made from the folders present.
function(generate_catalogue)
  get_property(modules GLOBAL PROPERTY LUCH_MODULES)
  # The framework's own, both in luch_baseline.
  list(APPEND modules baseline path)
  list(SORT modules)
  set(declarations "")
  set(rows "")
  set(libraries "")
  foreach(module IN LISTS modules)
    string(APPEND declarations "namespace luch::${module} { TechniqueInfo describe(); }\n")
    string(APPEND rows "        luch::${module}::describe(),\n")
    string(REPLACE "::" "_" library ${module})
    list(APPEND libraries ${library})
  endforeach()
  list(TRANSFORM libraries REPLACE "^(baseline|path)$" "luch_baseline")
  list(REMOVE_DUPLICATES libraries)
  configure_file(${CMAKE_SOURCE_DIR}/framework/cmake/catalogue.cpp.in
                 ${CMAKE_BINARY_DIR}/catalogue.cpp @ONLY)
  # The search goes with the list: in luch_technique it would leave programs without one unlinked.
  add_library(luch_catalogue STATIC ${CMAKE_BINARY_DIR}/catalogue.cpp
              ${CMAKE_SOURCE_DIR}/framework/technique/catalogue.cpp)
  target_link_libraries(luch_catalogue PUBLIC luch_technique PRIVATE ${libraries})
endfunction()

# luch_embed(target header NAME=path…): text files built into a target. The header declares, in
# luch::embedded, a function std::string_view NAME() for each.
function(luch_embed target header)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${target}_embedded.cpp)
  set(files "")
  set(paths "")
  foreach(file IN LISTS ARGN)
    string(REGEX MATCH "^([a-z_]+)=(.*)$" ignored ${file})
    list(APPEND paths ${CMAKE_CURRENT_SOURCE_DIR}/${CMAKE_MATCH_2})
    list(APPEND files ${CMAKE_MATCH_1}=${CMAKE_CURRENT_SOURCE_DIR}/${CMAKE_MATCH_2})
  endforeach()
  list(JOIN files "," files)
  set(script ${CMAKE_SOURCE_DIR}/framework/cmake/embed.cmake)
  add_custom_command(
    OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DHEADER=${header} "-DFILES=${files}" -P ${script}
    DEPENDS ${script} ${paths}
    VERBATIM)
  target_sources(${target} PRIVATE ${out})
endfunction()
