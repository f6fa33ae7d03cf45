# What `cmake --install` installs beside the command, all under the component `harness`: the public
# headers <circumspect/...>, the archives, a CMake package and pkg-config files. The headers need
# nothing but the standard library.

include(CMakePackageConfigHelpers)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/circumspect")
set(target_of_check circumspect_check_archive)
set(target_of_harness circumspect_archive)
set(target_of_c circumspect_c_library)
foreach(library check c harness)
  install(TARGETS ${target_of_${library}} EXPORT circumspect_${library}
          ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT harness
          LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT harness)
  install(EXPORT circumspect_${library} NAMESPACE circumspect:: FILE circumspect-${library}.cmake
          DESTINATION "${package_folder}" COMPONENT harness)
endforeach()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/circumspect"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT harness FILES_MATCHING PATTERN "*.h*")
configure_file("${PROJECT_SOURCE_DIR}/cmake/circumspectConfig.cmake.in"
               "${PROJECT_BINARY_DIR}/package/circumspectConfig.cmake" @ONLY)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/package/circumspectConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/package/circumspectConfig.cmake"
              "${PROJECT_BINARY_DIR}/package/circumspectConfigVersion.cmake"
        DESTINATION "${package_folder}" COMPONENT harness)
file(RELATIVE_PATH to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" to_prefix "${to_prefix}")
foreach(file circumspect-check.pc circumspect.pc circumspect-c.pc)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/${file}.in" "${PROJECT_BINARY_DIR}/package/${file}" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/package/${file}"
          DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT harness)
endforeach()
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT harness)
