vcpkg_download_distfile(archive
  URLS "https://github.com/circumspect/circumspect/releases/download/v${VERSION}/circumspect-${VERSION}-source.tar.gz"
  FILENAME "circumspect-${VERSION}-source.tar.gz"
  SHA512 @SHA512@)
vcpkg_extract_source_archive(sources ARCHIVE "${archive}")
vcpkg_cmake_configure(SOURCE_PATH "${sources}"
  OPTIONS -DCIRCUMSPECT_QUICK_BUILD=ON -DCIRCUMSPECT_BUILD_TESTS=OFF -DCIRCUMSPECT_BUILD_COMMAND=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME circumspect CONFIG_PATH lib/cmake/circumspect)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${sources}/LICENSE")
