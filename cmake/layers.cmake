# What a layer is to the build: a folder, a library made of it, and the tests that sit beside it.
#
#   circumspect_layer(NAME FOLDER [UNTIMED] [LIGHT] [IN room...] [DEPENDS layer...]
#                     [LINKS library...] [TEST_DEPENDS layer...])
#     library  circumspect_NAME   FOLDER/*.cpp without the tests (header-only if there are none),
#                                 and those of the rooms in it that are named
#     test     NAME_test          FOLDER/*_test.cpp
#     test     NAME_cgal_test     FOLDER/*_cgal_test.cpp, the only tests that see CGAL
#
# UNTIMED: nobody waits for what it does. CIRCUMSPECT_QUICK_BUILD optimizes it less, which takes the
# compiler three fifths of the time. Where tests are built it does so with all layers that use the
# precompiled headers: compiling them takes longer than what the tests do.
#
# LIGHT: what the tests have it do is soon done. Where Clang compiles the tests it compiles these
# layers, too, and does not optimize, which takes two fifths of GCC's time.
#
# The name of a test file says when it runs:
#     *_slow_test.cpp, *_slow_property.cpp   label `slow`: not under the sanitizers
#     *_soak_test.cpp, *_soak_property.cpp   label `soak`: only by `make soak`
# The sanitizers' build does not compile either.

# How a quick build optimizes what nobody waits for.
set(circumspect_untimed $<IF:$<BOOL:${CIRCUMSPECT_SMALL}>,-Os,-O1>)

# Does Clang compile the tests, and may the layers that do light work go with them?
set(circumspect_tests_by_clang OFF)
if(CIRCUMSPECT_BUILD_TESTS AND CIRCUMSPECT_TEST_LAUNCHER AND CIRCUMSPECT_MOLD AND CMAKE_BUILD_TYPE STREQUAL "RelWithDebInfo")
  set(circumspect_tests_by_clang ON)
endif()

function(circumspect_layer name folder)
  cmake_parse_arguments(ARG "UNTIMED;LIGHT" "" "IN;DEPENDS;LINKS;TEST_DEPENDS" ${ARGN})
  set(directory "${PROJECT_SOURCE_DIR}/${folder}")
  set(rooms ${ARG_IN})
  list(TRANSFORM rooms REPLACE ".+" "${directory}/\\0/*.cpp")
  file(GLOB sources CONFIGURE_DEPENDS "${directory}/*.cpp" ${rooms})
  file(GLOB tests CONFIGURE_DEPENDS "${directory}/*_test.cpp")
  file(GLOB cgal_tests CONFIGURE_DEPENDS "${directory}/*_cgal_test.cpp")
  if(tests)
    list(REMOVE_ITEM sources ${tests})
  endif()
  if(cgal_tests)
    list(REMOVE_ITEM tests ${cgal_tests})
  endif()

  set(built_elsewhere OFF)
  if(sources AND CIRCUMSPECT_VALUES_FROM AND folder MATCHES "${values_folders}")
    set(built_elsewhere ON)
    add_library(circumspect_${name} STATIC IMPORTED GLOBAL)
    set_target_properties(circumspect_${name} PROPERTIES
      IMPORTED_LOCATION "${CIRCUMSPECT_VALUES_FROM}/libcircumspect_${name}.a")
    set(visibility INTERFACE)
  elseif(sources)
    add_library(circumspect_${name} STATIC ${sources})
    circumspect_compile_together(circumspect_${name} 16)
    circumspect_compile_for_sharing(circumspect_${name})
    circumspect_count_apart(circumspect_${name})
    set(visibility PUBLIC)
  else()
    add_library(circumspect_${name} INTERFACE)
    set(visibility INTERFACE)
  endif()
  list(TRANSFORM ARG_DEPENDS PREPEND circumspect_)
  list(TRANSFORM ARG_TEST_DEPENDS PREPEND circumspect_)
  set(archives "")
  foreach(layer IN LISTS ARG_DEPENDS)
    get_target_property(below ${layer} CIRCUMSPECT_ARCHIVES)
    list(APPEND archives ${below})
  endforeach()
  if(sources AND NOT built_elsewhere)
    list(APPEND archives circumspect_${name})
  endif()
  list(REMOVE_DUPLICATES archives)
  set_target_properties(circumspect_${name} PROPERTIES CIRCUMSPECT_ARCHIVES "${archives}" CIRCUMSPECT_FOLDER "${folder}")
  target_link_libraries(circumspect_${name} ${visibility}
                        circumspect_settings ${ARG_DEPENDS} ${ARG_LINKS})

  if(built_elsewhere)
    # Its flags are that build's.
  elseif(folder MATCHES "^properties/")
    circumspect_compile_quickly(circumspect_${name})
  elseif(sources AND CIRCUMSPECT_BUILD_FUZZERS)
    # libFuzzer is to see which code its inputs reach; the tests need not be looked at.
    target_compile_options(circumspect_${name} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  # The lowest layers see less than the others, and are compiled as they stand.
  if(sources AND ARG_DEPENDS AND NOT built_elsewhere)
    if(folder MATCHES "^properties/")
      circumspect_precompile(circumspect_${name} properties)
    elseif(ARG_LIGHT AND circumspect_tests_by_clang)
      circumspect_precompile(circumspect_${name} light_layers)
    elseif((ARG_UNTIMED OR CIRCUMSPECT_BUILD_TESTS) AND CMAKE_BUILD_TYPE STREQUAL "RelWithDebInfo")
      circumspect_precompile(circumspect_${name} untimed_layers)
    else()
      circumspect_precompile(circumspect_${name} layers)
    endif()
  endif()

  set(test_links circumspect_${name} ${ARG_TEST_DEPENDS})
  circumspect_test(${name}_test LABEL unit SOURCES ${tests} LINKS ${test_links})
  circumspect_test(${name}_cgal_test LABEL unit SOURCES ${cgal_tests}
                   LINKS ${test_links} CGAL::CGAL)
endfunction()

# The headers of others take the compiler long. Under CIRCUMSPECT_QUICK_BUILD targets whose flags
# agree share them precompiled: KIND is `layers`, `untimed_layers`, `light_layers`, `properties`
# (with RapidCheck), or `tests` (with doctest). GCC takes the level of optimization from the
# precompiled header, whatever is asked of the file. A file must still include what it uses:
# without the option, as in a plain preset, each is compiled as it stands.
#
# Of the project, what nearly every file includes is among them where tests are built, so that a
# change elsewhere makes none anew: it takes a third of the time of what Clang compiles.
set(circumspect_headers_of_all "${PROJECT_SOURCE_DIR}/oracle/model/domain.hpp"
    "${PROJECT_SOURCE_DIR}/oracle/model/verdict.hpp" "${PROJECT_SOURCE_DIR}/oracle/model/mesh.hpp")
function(circumspect_precompile target kind)
  if(NOT CIRCUMSPECT_QUICK_BUILD)
    return()
  endif()
  set(headers <algorithm> <array> <cassert> <cmath> <compare> <cstddef> <cstdint> <functional>
      <iterator> <limits> <map> <memory> <numeric> <optional> <ostream> <set> <span> <sstream>
      <stdexcept> <string> <string_view> <tuple> <utility> <variant> <vector>
      <gmpxx.h> <tl/expected.hpp>)
  set(shared circumspect_precompiled_${kind})
  if(NOT TARGET ${shared})
    set(source "${PROJECT_BINARY_DIR}/${shared}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "")
    add_library(${shared} OBJECT "${source}")
    target_link_libraries(${shared} PRIVATE circumspect_settings circumspect::gmp
                          circumspect::expected CGAL::CGAL Threads::Threads)
    if(kind MATCHES "layers" AND CIRCUMSPECT_BUILD_FUZZERS)
      target_compile_options(${shared} PRIVATE -fsanitize=fuzzer-no-link)
    endif()
    circumspect_compile_as(${shared} ${kind})
    if(kind STREQUAL "properties")
      circumspect_compile_quickly(${shared})
      target_link_libraries(${shared} PRIVATE rapidcheck)
      list(APPEND headers <rapidcheck.h>)
    elseif(kind STREQUAL "tests")
      circumspect_compile_quickly(${shared})
      circumspect_compile_test(${shared})
      target_link_libraries(${shared} PRIVATE rapidcheck doctest::doctest)
      list(APPEND headers <rapidcheck.h> <doctest/doctest.h>)
    endif()
    if(CIRCUMSPECT_BUILD_TESTS)
      list(APPEND headers ${circumspect_headers_of_all})
      if(NOT kind MATCHES "^(untimed_)?layers$")  # GCC wants definitions to agree
        target_link_libraries(${shared} PRIVATE fmt::fmt nlohmann_json::nlohmann_json)
        list(APPEND headers <fmt/format.h> <nlohmann/json.hpp>)
      endif()
    endif()
    if(NOT kind STREQUAL "tests")
      circumspect_compile_for_sharing(${shared})
    endif()
    target_precompile_headers(${shared} PRIVATE ${headers})
  endif()
  # GCC refuses the precompiled headers of fmt where its definitions are missing.
  if(CIRCUMSPECT_BUILD_TESTS AND NOT kind MATCHES "^(untimed_)?layers$")
    target_compile_definitions(${target} PRIVATE $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  endif()
  target_precompile_headers(${target} REUSE_FROM ${shared})
  circumspect_compile_as(${target} ${kind})
  # Flags have to agree: what is shared is position-independent as a library is, not as a program
  # is.
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "EXECUTABLE" AND NOT kind STREQUAL "tests")
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_compile_options(${target} PRIVATE -fPIC)
  endif()
endfunction()

# How much a kind of targets is optimized, where that is not as the preset says.
function(circumspect_compile_as target kind)
  if(kind STREQUAL "light_layers" OR (kind STREQUAL "properties" AND circumspect_tests_by_clang))
    target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O0>)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${CIRCUMSPECT_TEST_LAUNCHER}"
                                               CIRCUMSPECT_LIGHT ON)
  elseif(kind STREQUAL "untimed_layers" OR kind STREQUAL "properties")
    target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:${circumspect_untimed}>)
  endif()
endfunction()

# The C library and the Python module are made of the layers' objects. Hidden symbols keep calls as
# direct as in a program.
function(circumspect_compile_for_sharing target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                                             VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# Under CIRCUMSPECT_QUICK_BUILD the sources of a layer are compiled sixteen at a time, those of a
# test program thirty-two: they instantiate much the same templates. Two files of one target that
# have a name each for themselves, in namespaces without a name, may then meet in one translation
# unit: name one of the two more exactly.
function(circumspect_compile_together target at_a_time)
  if(NOT CIRCUMSPECT_QUICK_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${at_a_time})
endfunction()

# mold links in a fifth of the time. What is shipped is linked by the usual linker.
function(circumspect_link_quickly target)
  if(CIRCUMSPECT_QUICK_BUILD AND CIRCUMSPECT_MOLD)
    target_link_options(${target} PRIVATE -fuse-ld=mold)
  endif()
endfunction()

# Test and layer both have their copies of std::vector's functions and the like. mold takes those of
# whichever file it is given first. Layers come before the test, and those that are optimized first,
# so that they run the code that they were compiled to: the copies of a test, which is not
# optimized, would slow them down by a third.
function(circumspect_prefer_archives target)
  if(NOT CIRCUMSPECT_QUICK_BUILD OR NOT CIRCUMSPECT_MOLD OR NOT CMAKE_BUILD_TYPE STREQUAL "RelWithDebInfo")
    return()
  endif()
  set(archives "")
  set(light "")
  foreach(library IN LISTS ARGN)
    if(TARGET ${library})
      get_target_property(of_library ${library} CIRCUMSPECT_ARCHIVES)
      if(of_library)
        list(APPEND archives ${of_library})
      endif()
    endif()
  endforeach()
  list(REMOVE_DUPLICATES archives)
  foreach(archive IN LISTS archives)
    get_target_property(is_light ${archive} CIRCUMSPECT_LIGHT)
    if(is_light)
      list(REMOVE_ITEM archives ${archive})
      list(APPEND light ${archive})
    endif()
  endforeach()
  foreach(archive IN LISTS archives light)
    target_link_options(${target} PRIVATE $<TARGET_FILE:${archive}>)
  endforeach()
endfunction()

# Code full of other people's templates takes the compiler most of its time to optimize, and the
# sanitizers learn nothing from it: what they are to look at are the layers, which stay optimized.
function(circumspect_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Debug>:-O0>)
endfunction()

# What a test does itself takes no time to speak of, so the release does not spend it on optimizing,
# nor on a handler of exceptions around each assertion: one that is thrown there ends its test case.
function(circumspect_compile_test target)
  if(NOT CIRCUMSPECT_QUICK_BUILD)
    return()
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O0>)
  if(CIRCUMSPECT_TEST_LAUNCHER)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${CIRCUMSPECT_TEST_LAUNCHER}")
  endif()
  target_compile_definitions(${target} PRIVATE DOCTEST_CONFIG_SUPER_FAST_ASSERTS
                                               DOCTEST_CONFIG_NO_TRY_CATCH_IN_ASSERTS)
endfunction()

# A program that reads options and leaves the work to the layers. `make test` has it compiled as
# the tests are, in half the time; where it is not linked by mold, which would take the copies of
# std::vector's functions from it, and where there are no tests, as in what is shipped, GCC
# optimizes it a little.
function(circumspect_compile_front target)
  if(circumspect_tests_by_clang)
    target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O0>)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${CIRCUMSPECT_TEST_LAUNCHER}")
    circumspect_link_quickly(${target})
    circumspect_prefer_archives(${target} ${ARGN})
  elseif(CIRCUMSPECT_QUICK_BUILD)
    target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:${circumspect_untimed}>)
  endif()
endfunction()

# `make test` has the sanitizers look where bytes, arrays and processes are handled. They see the
# fast judge and its threads through those who call it: the tests of C's and C++'s arrays. The rest
# handles values: numbers, points and containers of them. `make soak-sanitize` runs all tests, the
# fast judge's own, the campaigns' and the harness's among them.
option(CIRCUMSPECT_SANITIZE_ALL "Build all tests, not only those of bytes, arrays, processes" OFF)
set(sanitized_folders "(oracle/(formats|judge/arrays)|c|fuzz/(process|targets))")
# `make test` runs these under the sanitizers alone. `make check`, `make soak` and `make mutants`
# run them in the release.
option(CIRCUMSPECT_LEAVE_TO_SANITIZERS "Leave out the tests that the sanitizers of make test run" OFF)
set(values_folders "^(oracle/judge$|(kernel|reference|construct|inputs|properties|oracle/(domain|model|certificate|report|picture)|oracle/judge/(cause|complex|conditions|convex_hull|definition|domain|fast/predicates|periodic|points|quality|surface|voronoi|within))(/|$))")
set(sanitized_in_part OFF)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=" AND NOT CIRCUMSPECT_SANITIZE_ALL)
  set(sanitized_in_part ON)
endif()
# Nor does it compile what handles values alone once more: it links the archives of the release.
set(CIRCUMSPECT_VALUES_FROM "" CACHE PATH
    "A folder with another build's archives of the folders that handle values alone: linked instead of compiled")
if(CIRCUMSPECT_VALUES_FROM AND NOT sanitized_in_part)
  message(FATAL_ERROR "CIRCUMSPECT_VALUES_FROM is for the sanitizers of `make test`: without -fsanitize=, or with "
    "CIRCUMSPECT_SANITIZE_ALL, every layer is compiled. Configure with -DCIRCUMSPECT_VALUES_FROM= (empty).")
endif()
# All that the tests need and nothing else.
add_custom_target(circumspect_tests)
# Those that `make coverage` runs.
add_custom_target(circumspect_covered_tests)

# For coverage, Clang counts what is internal to a file under the last part of the file's name,
# which all unities share.
function(circumspect_count_apart target)
  if(CMAKE_CXX_FLAGS MATCHES "-fcoverage-mapping")
    target_compile_options(${target} PRIVATE "SHELL:-Xclang -main-file-name -Xclang ${target}")
  endif()
endfunction()

# circumspect_test(TARGET LABEL label SOURCES file... LINKS target... [DEFINES definition...])
# makes one executable, and registers each source file as one test; does nothing without sources.
function(circumspect_test target)
  cmake_parse_arguments(ARG "" "LABEL" "SOURCES;LINKS;DEFINES" ${ARGN})
  # What the sanitizers are not to run they need not compile.
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
    list(FILTER ARG_SOURCES EXCLUDE REGEX "_(slow|soak)_[a-z]+\\.cpp$")
    if(sanitized_in_part)
      list(FILTER ARG_SOURCES INCLUDE REGEX "^${PROJECT_SOURCE_DIR}/${sanitized_folders}/[^/]+$")
    endif()
  elseif(CIRCUMSPECT_LEAVE_TO_SANITIZERS)
    list(FILTER ARG_SOURCES EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/${sanitized_folders}/[^/]*_test\\.cpp$")
  endif()
  if(NOT CIRCUMSPECT_BUILD_TESTS OR NOT ARG_SOURCES)
    return()
  endif()
  if(NOT TARGET circumspect_test_main)
    add_library(circumspect_test_main OBJECT "${PROJECT_SOURCE_DIR}/properties/test_main.cpp")
    target_link_libraries(circumspect_test_main
                          PUBLIC circumspect_settings doctest::doctest rapidcheck)
    circumspect_compile_quickly(circumspect_test_main)
    circumspect_compile_test(circumspect_test_main)
  endif()
  add_executable(${target} ${ARG_SOURCES})
  add_dependencies(circumspect_tests ${target})
  if(ARG_SOURCES MATCHES "${PROJECT_SOURCE_DIR}/(kernel|oracle|corpus|command|properties|proofs)/")
    add_dependencies(circumspect_covered_tests ${target})
  endif()
  circumspect_compile_quickly(${target})
  circumspect_compile_test(${target})
  if(sanitized_in_part AND ARG_SOURCES MATCHES "${PROJECT_SOURCE_DIR}/oracle/formats/")
    # Unlike those of arrays, these tests compile no headers for users: what they call is looked at.
    target_compile_options(${target} PRIVATE -fno-sanitize=undefined)
  endif()
  circumspect_precompile(${target} tests)
  circumspect_compile_together(${target} 32)
  circumspect_count_apart(${target})
  target_link_libraries(${target} PRIVATE ${ARG_LINKS} circumspect_test_main)
  circumspect_link_quickly(${target})
  circumspect_prefer_archives(${target} ${ARG_LINKS})
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
    # The longest start first, lest one of them runs alone at the end.
    set(cost 0)
    if(ARG_LABEL STREQUAL "property")
      set(cost 10)
    endif()
    if(file MATCHES "_slow_")
      list(APPEND labels slow)
      set(cost 100)
    elseif(file MATCHES "_soak_")
      set(labels soak)
      set(timeout 7200)
    endif()
    add_test(NAME ${test} COMMAND ${target} "--source-file=*/${path}")
    # A file in which no test case ran has tested nothing, and says so.
    set_tests_properties(${test} PROPERTIES
      LABELS "${labels}" TIMEOUT ${timeout} COST ${cost} FAIL_REGULAR_EXPRESSION "test cases: +0 ")
  endforeach()
endfunction()
