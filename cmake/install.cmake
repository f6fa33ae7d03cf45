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
# What stands behind the archives: packages of CMake, of pkg-config and of Debian.
set(packages_behind Threads)
set(modules_behind gmpxx mpfr)
set(debian_packages_behind libgmp-dev libmpfr-dev)
if(NOT CIRCUMSPECT_STATIC)
  list(APPEND packages_behind fmt)
  list(APPEND modules_behind fmt)
  list(APPEND debian_packages_behind libfmt-dev)
endif()
if(circumspect_links_tbb)
  list(APPEND packages_behind TBB)
  list(APPEND modules_behind tbb)
  list(APPEND debian_packages_behind libtbb-dev)
endif()
foreach(list packages_behind modules_behind debian_packages_behind)
  list(JOIN ${list} " " ${list})
endforeach()
# A C program that links an archive names the runtime library of C++ itself.
set(cxx_runtime ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(FILTER cxx_runtime INCLUDE REGEX "^(stdc\\+\\+|c\\+\\+|c\\+\\+abi)$")
list(TRANSFORM cxx_runtime PREPEND "-l")
list(JOIN cxx_runtime " " cxx_runtime)
set(c_is_shared ON)
set(private_of_c "")
get_target_property(type_of_c circumspect_c_library TYPE)
if(type_of_c STREQUAL "STATIC_LIBRARY")
  set(c_is_shared OFF)
  set(private_of_c "Requires.private: ${modules_behind}\nLibs.private: ${cxx_runtime} -lm -pthread\n")
endif()
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
