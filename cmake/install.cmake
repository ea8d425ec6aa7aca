# Installs the library, its headers, its CMake package, its pkg-config file and the command.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/orispline)
install(TARGETS orispline_headers EXPORT orisplineTargets FILE_SET HEADERS COMPONENT headers FILE_SET inner COMPONENT headers)
install(TARGETS orispline EXPORT orisplineTargets)
if(BUILD_SHARED_LIBS)
  set(libraries orispline)
else()
  list(TRANSFORM orispline_components PREPEND orispline_ OUTPUT_VARIABLE libraries)
  install(TARGETS ${libraries} EXPORT orisplineTargets)
  list(REVERSE libraries) # for linkers, who want callers first
endif()
install(EXPORT orisplineTargets NAMESPACE orispline:: DESTINATION ${package_dir})
if(ORISPLINE_SHARED)
  install(TARGETS orispline_shared EXPORT orisplineSharedTargets)
  install(EXPORT orisplineSharedTargets NAMESPACE orispline:: DESTINATION ${package_dir})
  set(shared_file ${CMAKE_INSTALL_LIBDIR}/${CMAKE_SHARED_LIBRARY_PREFIX}orispline${CMAKE_SHARED_LIBRARY_SUFFIX})
endif()

configure_package_config_file(
  cmake/orisplineConfig.cmake.in ${PROJECT_BINARY_DIR}/orisplineConfig.cmake INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/orisplineConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/orisplineConfig.cmake ${PROJECT_BINARY_DIR}/orisplineConfigVersion.cmake
        DESTINATION ${package_dir})

# pkg_config_file(NAME LIBRARIES...); the prefix is found from the place of the file, so that the installed tree can be moved.
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
function(pkg_config_file pc_name)
  list(TRANSFORM ARGN PREPEND -l)
  string(JOIN " " link_options ${ARGN} ${CMAKE_THREAD_LIBS_INIT})
  configure_file(cmake/orispline.pc.in ${PROJECT_BINARY_DIR}/${pc_name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc_name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
pkg_config_file(orispline ${libraries})
if(ORISPLINE_SHARED)
  pkg_config_file(orispline_shared orispline)
endif()

install(FILES LICENSE NOTICE THIRD_PARTY DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TARGET orispline-cli)
  install(TARGETS orispline-cli COMPONENT command)
endif()
if(TARGET orispline-cli AND NOT CMAKE_CROSSCOMPILING)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT command)
  set(completions ${PROJECT_BINARY_DIR}/completions)
  install(FILES ${completions}/orispline DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT command)
  install(FILES ${completions}/_orispline DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT command)
  install(FILES ${completions}/orispline.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT command)
endif()
