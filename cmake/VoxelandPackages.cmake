# SPDX-License-Identifier: BSD-3-Clause
# Debian packages, written to build-deb/packages, by: cmake --preset deb && cmake --build --preset deb
# A package is an install component of the other CMake files.
set(VOXELAND_MAINTAINER "Voxeland for MRPT authors <voxeland@example.org>" CACHE STRING
  "Name and address of the packages' maintainer")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT "${VOXELAND_MAINTAINER}")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")

# What Debian wants to find in each package.
set(copyright "${CMAKE_SOURCE_DIR}/share/packages/deb/copyright")
set(changelog "${CMAKE_BINARY_DIR}/changelog")
string(TIMESTAMP VOXELAND_BUILD_TIME "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(share/packages/deb/changelog.in "${changelog}" @ONLY)
execute_process(COMMAND gzip -9nf "${changelog}" COMMAND_ERROR_IS_FATAL ANY)

# voxeland_package(COMPONENT NAME SECTION DESCRIPTION [component...]): the package of a component,
# which depends on those of other components.
macro(voxeland_package component name section description)
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${description}")
  set(CPACK_COMPONENT_${upper}_DEPENDS ${ARGN})
  install(FILES "${copyright}" "${changelog}.gz" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${name}"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

voxeland_package(libraries libvoxeland libs
"semantic voxel maps with uncertainty for MRPT, libraries
Voxeland makes a map of objects from RGB-D frames and the predictions of an
instance segmentation network, and says how sure it is of every voxel and
every object. The map is an mrpt::maps::CMetricMap.")
# Which package has them, and that they be found at once.
get_property(libraries GLOBAL PROPERTY VOXELAND_LIBRARIES)
foreach(library IN LISTS libraries)
  string(APPEND shlibs "lib${library} ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
    " libvoxeland (= ${PROJECT_VERSION})\n")
endforeach()
file(WRITE "${CMAKE_BINARY_DIR}/shlibs" "${shlibs}")
file(WRITE "${CMAKE_BINARY_DIR}/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_CONTROL_EXTRA
  "${CMAKE_BINARY_DIR}/shlibs" "${CMAKE_BINARY_DIR}/triggers")
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_RECOMMENDS voxeland-plugins)

voxeland_package(plugins voxeland-plugins science
"semantic voxel maps with uncertainty for MRPT, plugins
The stages of Voxeland's mapping that can be exchanged: what turns frames into
opinions, what decides which object an opinion is about, and who is asked about
objects of uncertain category." libraries)

voxeland_package(dev libvoxeland-dev libdevel
"semantic voxel maps with uncertainty for MRPT, development files
Headers, CMake package and examples to write programs and plugins that use
Voxeland." libraries)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS libmrpt-maps-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "cmake, libmrpt-nav-dev")

voxeland_package(apps voxeland-apps science
"semantic voxel maps with uncertainty for MRPT, programs
Programs to import RGB-D datasets, simulate apartments, make maps from rawlogs,
ask about uncertain objects, query and export maps, write reports of them, and
compare them with ground truth." libraries plugins)
set(CPACK_DEBIAN_APPS_PACKAGE_RECOMMENDS "libjs-three, python3")
set(CPACK_DEBIAN_APPS_PACKAGE_SUGGESTS mrpt-apps)

include(CPack)
