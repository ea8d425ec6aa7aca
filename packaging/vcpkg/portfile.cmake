# SPDX-License-Identifier: Apache-2.0
# Not run: no vcpkg was to be had. A test holds the port to the version and the dependencies; tools/recipes.py fills in the archive.
vcpkg_download_distfile(archive URLS "@ARCHIVE@" FILENAME "orispline-${VERSION}.tar.gz" SHA512 "@SHA512@")
vcpkg_extract_source_archive(source_path ARCHIVE "${archive}")
vcpkg_check_features(
  OUT_FEATURE_OPTIONS features FEATURES io ORISPLINE_IO optimise ORISPLINE_OPTIMISE cli ORISPLINE_CLI)

# The library for C is a shared one on every triplet, which static triplets do not allow.
vcpkg_cmake_configure(SOURCE_PATH "${source_path}" OPTIONS ${features} -DORISPLINE_C=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/orispline)
vcpkg_fixup_pkgconfig()
if("cli" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES orispline AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${source_path}/LICENSE" "${source_path}/NOTICE" "${source_path}/THIRD_PARTY")
