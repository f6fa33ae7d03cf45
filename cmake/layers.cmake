# What a layer is to the build: a folder, a library made of it, and the tests that sit beside it.
#
#   circumspect_layer(NAME FOLDER [DEPENDS layer...] [LINKS library...] [TEST_DEPENDS layer...])
#     library  circumspect_NAME   FOLDER/*.cpp without the tests (header-only if there are none)
#     test     NAME_test          FOLDER/*_test.cpp
#     test     NAME_cgal_test     FOLDER/*_cgal_test.cpp, the only tests that see CGAL
#
# The name of a test file says when it runs:
#     *_slow_test.cpp, *_slow_property.cpp   label `slow`: not under the sanitizers
#     *_soak_test.cpp, *_soak_property.cpp   label `soak`: only by `make soak`

function(circumspect_layer name folder)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LINKS;TEST_DEPENDS" ${ARGN})
  set(directory "${PROJECT_SOURCE_DIR}/${folder}")
  file(GLOB sources CONFIGURE_DEPENDS "${directory}/*.cpp")
  file(GLOB tests CONFIGURE_DEPENDS "${directory}/*_test.cpp")
  file(GLOB cgal_tests CONFIGURE_DEPENDS "${directory}/*_cgal_test.cpp")
  if(tests)
    list(REMOVE_ITEM sources ${tests})
  endif()
  if(cgal_tests)
    list(REMOVE_ITEM tests ${cgal_tests})
  endif()

  if(sources)
    add_library(circumspect_${name} STATIC ${sources})
    set(visibility PUBLIC)
  else()
    add_library(circumspect_${name} INTERFACE)
    set(visibility INTERFACE)
  endif()
  list(TRANSFORM ARG_DEPENDS PREPEND circumspect_)
  list(TRANSFORM ARG_TEST_DEPENDS PREPEND circumspect_)
  target_link_libraries(circumspect_${name} ${visibility}
                        circumspect_settings ${ARG_DEPENDS} ${ARG_LINKS})

  if(folder MATCHES "^properties/")
    circumspect_compile_quickly(circumspect_${name})
  endif()

  set(test_links circumspect_${name} ${ARG_TEST_DEPENDS})
  circumspect_test(${name}_test LABEL unit SOURCES ${tests} LINKS ${test_links})
  circumspect_test(${name}_cgal_test LABEL unit SOURCES ${cgal_tests}
                   LINKS ${test_links} CGAL::CGAL)
endfunction()

# Code full of other people's templates takes the compiler most of its time to optimize, and the
# sanitizers learn nothing from it: what they are to look at are the layers, which stay optimized.
function(circumspect_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Debug>:-O0>)
endfunction()

# circumspect_test(TARGET LABEL label SOURCES file... LINKS target... [DEFINES definition...])
# makes one executable, and registers each source file as one test; does nothing without sources.
function(circumspect_test target)
  cmake_parse_arguments(ARG "" "LABEL" "SOURCES;LINKS;DEFINES" ${ARGN})
  if(NOT CIRCUMSPECT_BUILD_TESTS OR NOT ARG_SOURCES)
    return()
  endif()
  if(NOT TARGET circumspect_test_main)
    add_library(circumspect_test_main OBJECT "${PROJECT_SOURCE_DIR}/properties/test_main.cpp")
    target_link_libraries(circumspect_test_main
                          PUBLIC circumspect_settings doctest::doctest rapidcheck)
  endif()
  add_executable(${target} ${ARG_SOURCES})
  circumspect_compile_quickly(${target})
  target_link_libraries(${target} PRIVATE ${ARG_LINKS} circumspect_test_main)
  target_compile_definitions(${target} PRIVATE
    CIRCUMSPECT_CORPUS_DIR="${PROJECT_SOURCE_DIR}/corpus" ${ARG_DEFINES})
  set_target_properties(${target} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/tests")

  foreach(source IN LISTS ARG_SOURCES)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE path)
    cmake_path(GET source FILENAME file)
    string(REGEX REPLACE "\\.cpp$" "" test "${path}")
    set(labels ${ARG_LABEL})
    set(timeout 300)
    if(file MATCHES "_slow_")
      list(APPEND labels slow)
    elseif(file MATCHES "_soak_")
      set(labels soak)
      set(timeout 7200)
    endif()
    add_test(NAME ${test} COMMAND ${target} "--source-file=*/${path}")
    # A file in which no test case ran has tested nothing, and says so.
    set_tests_properties(${test} PROPERTIES
      LABELS "${labels}" TIMEOUT ${timeout} FAIL_REGULAR_EXPRESSION "test cases: +0 ")
  endforeach()
endfunction()
