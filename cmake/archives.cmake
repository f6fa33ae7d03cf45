# The libraries that users link, an installed copy or this tree inside their own:
#   circumspect::check    judges arrays: <circumspect/judgement.hpp>, <circumspect/check.hpp>
#   circumspect::harness  that, and what draws inputs: all of <circumspect/...> for C++
#   circumspect::c        <circumspect/circumspect.h>, a shared library with C symbols alone; with
#                         BUILD_SHARED_LIBS=OFF an archive, whose other symbols are hidden
# The first two are one archive of layers each. What they ask of their users are the headers, C++20
# and the libraries behind them; the flags with which the layers are compiled are nobody else's.

include(GNUInstallDirs)

# The layers that a library links, itself included.
function(circumspect_layers_behind library result)
  set(seen ${${result}})
  if(NOT library IN_LIST seen)
    list(APPEND seen ${library})
    get_target_property(linked ${library} INTERFACE_LINK_LIBRARIES)
    foreach(one IN LISTS linked)
      if(TARGET ${one} AND one MATCHES "^circumspect_" AND NOT one STREQUAL "circumspect_settings")
        circumspect_layers_behind(${one} seen)
      endif()
    endforeach()
  endif()
  set(${result} ${seen} PARENT_SCOPE)
endfunction()

# What every archive of layers is linked with; the same for pkg-config is in install.cmake. An
# installed copy names GMP and MPFR by the targets that circumspectConfig.cmake makes, so that they
# are found wherever they are.
set(behind_archives $<LINK_ONLY:Threads::Threads>)
foreach(library gmp mpfr)
  list(APPEND behind_archives $<BUILD_INTERFACE:$<LINK_ONLY:circumspect::${library}>>)
endforeach()
foreach(library gmpxx gmp mpfr)
  list(APPEND behind_archives $<INSTALL_INTERFACE:$<LINK_ONLY:circumspect::${library}>>)
endforeach()
if(NOT CIRCUMSPECT_STATIC)
  list(PREPEND behind_archives $<LINK_ONLY:fmt::fmt>)
endif()
if(circumspect_links_tbb)
  list(PREPEND behind_archives $<LINK_ONLY:TBB::tbb>)
endif()

# circumspect_add_archive(TARGET NAME OUTPUT_NAME LAYERS layer... LINKS library...)
# makes the archive of these layers, which users know as circumspect::NAME.
function(circumspect_add_archive target name output_name)
  cmake_parse_arguments(ARG "" "" "LAYERS;LINKS" ${ARGN})
  set(objects)
  foreach(layer IN LISTS ARG_LAYERS)
    get_target_property(type ${layer} TYPE)
    if(type STREQUAL "STATIC_LIBRARY")
      list(APPEND objects $<TARGET_OBJECTS:${layer}>)
    endif()
  endforeach()
  add_library(${target} STATIC ${objects})
  add_library(circumspect::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME ${output_name} EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_link_libraries(${target} INTERFACE ${ARG_LINKS})
  target_include_directories(${target} INTERFACE
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
endfunction()

set(check_layers)
circumspect_layers_behind(circumspect_arrays check_layers)

circumspect_add_archive(circumspect_check_archive check circumspect-check
  LAYERS ${check_layers}
  LINKS ${behind_archives})
target_compile_features(circumspect_check_archive INTERFACE cxx_std_20)
set(harness_layers)
circumspect_layers_behind(circumspect_harness harness_layers)
list(REMOVE_ITEM harness_layers ${check_layers})
# What judges must not call what builds: no layer of the book is linked, by however many steps.
foreach(layer IN LISTS check_layers harness_layers)
  get_target_property(folder ${layer} CIRCUMSPECT_FOLDER)
  if(folder MATCHES "^reference(/|$)")
    message(FATAL_ERROR "expected judges and harness without the book, found that they link ${layer} (${folder}): "
                        "see DEPENDS of their layers in CMakeLists.txt")
  endif()
endforeach()
circumspect_add_archive(circumspect_archive harness circumspect-harness
  LAYERS ${harness_layers}
  LINKS circumspect_check_archive)

# circumspect_show_only(TARGET MAP) hides all symbols of a shared library but those that the file
# MAP names.
function(circumspect_show_only target map)
  if(APPLE)  # whose linker reads no such files, and takes one pattern as ours have it
    file(READ "${map}" text)
    string(REGEX REPLACE ".*global: ([^;]*);.*" "\\1" shown "${text}")
    target_link_options(${target} PRIVATE "LINKER:-exported_symbol,_${shown}")
    return()
  endif()
  target_link_options(${target} PRIVATE "LINKER:--version-script=${map}")
  set_target_properties(${target} PROPERTIES LINK_DEPENDS "${map}")
endfunction()

if(NOT DEFINED BUILD_SHARED_LIBS OR BUILD_SHARED_LIBS)
  add_library(circumspect_c_library SHARED $<TARGET_OBJECTS:circumspect_c>)
  add_library(circumspect::c ALIAS circumspect_c_library)
  target_link_libraries(circumspect_c_library PRIVATE circumspect_c)
  target_include_directories(circumspect_c_library INTERFACE
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  set_target_properties(circumspect_c_library PROPERTIES OUTPUT_NAME circumspect EXPORT_NAME c LINKER_LANGUAGE CXX
                                                         VERSION ${PROJECT_VERSION} SOVERSION 0)
  if(NOT APPLE AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize=")  # the sanitizers' own are in the program
    target_link_options(circumspect_c_library PRIVATE LINKER:--no-undefined)
  endif()
  circumspect_show_only(circumspect_c_library "${PROJECT_SOURCE_DIR}/c/circumspect.map")
else()
  set(c_layers)
  circumspect_layers_behind(circumspect_c c_layers)
  circumspect_add_archive(circumspect_c_library c circumspect
    LAYERS ${c_layers}
    LINKS ${behind_archives})
endif()
# Whoever builds one of them installs all.
add_dependencies(circumspect_archive circumspect_check_archive circumspect_c_library)
