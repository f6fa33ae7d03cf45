# What `cmake --install` installs beside the command, all under the component `harness`: the public headers
# <circumspect/...>, one archive of all the layers that stand behind them, a CMake package and a
# pkg-config file. The headers need nothing but the standard library.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

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

set(layers)
circumspect_layers_behind(circumspect_harness layers)
set(objects)
foreach(layer IN LISTS layers)
  get_target_property(type ${layer} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    list(APPEND objects $<TARGET_OBJECTS:${layer}>)
  endif()
endforeach()

add_library(circumspect_archive STATIC ${objects})
set_target_properties(circumspect_archive PROPERTIES
  OUTPUT_NAME circumspect EXPORT_NAME harness LINKER_LANGUAGE CXX)
target_compile_features(circumspect_archive INTERFACE cxx_std_20)
target_link_libraries(circumspect_archive INTERFACE
  rapidcheck fmt::fmt TBB::tbb gmpxx gmp mpfr Threads::Threads)
target_include_directories(circumspect_archive INTERFACE
  "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/circumspect")
install(TARGETS circumspect_archive EXPORT circumspect_targets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT harness)
install(EXPORT circumspect_targets NAMESPACE circumspect:: FILE circumspectTargets.cmake
        DESTINATION "${package_folder}" COMPONENT harness)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/oracle/include/circumspect"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT harness FILES_MATCHING PATTERN "*.hpp")
configure_file("${CMAKE_CURRENT_LIST_DIR}/circumspectConfig.cmake.in"
               "${PROJECT_BINARY_DIR}/package/circumspectConfig.cmake" @ONLY)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/package/circumspectConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/package/circumspectConfig.cmake"
              "${PROJECT_BINARY_DIR}/package/circumspectConfigVersion.cmake"
        DESTINATION "${package_folder}" COMPONENT harness)
file(RELATIVE_PATH to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" to_prefix "${to_prefix}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/circumspect.pc.in"
               "${PROJECT_BINARY_DIR}/package/circumspect.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/package/circumspect.pc"
        DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT harness)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT harness)

# The examples, as projects of their own, against an installed copy.
if(CIRCUMSPECT_BUILD_TESTS AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
  add_test(NAME examples/outside_test
           COMMAND "${PROJECT_SOURCE_DIR}/examples/outside_test.sh" "${PROJECT_BINARY_DIR}")
  set_tests_properties(examples/outside_test PROPERTIES LABELS unit TIMEOUT 300 COST 60)
endif()
