# SPDX-License-Identifier: LGPL-2.1-or-later
#
# `cpack` makes two Debian packages, for the Debian that it runs on: seiche and
# seiche-dev. The Dockerfile and contrib/package call it.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The Seiche authors <seiche@example.invalid>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME seiche)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS
  "openmpi-bin, python3, python3-numpy, python3-matplotlib, python3-h5py")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Dam breaks, sloshing, waves against obstacles, in two and three dimensions:
 the program seiche, its scenes, and scripts for plots, pictures and studies.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME seiche-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "g++, cmake, libdeal.ii-dev, \
libsuitesparse-dev, libassimp-dev, libhypre-dev, libcli11-dev, nlohmann-json3-dev, libfmt-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Headers, libraries and find_package(seiche) for programs of one's own.")
include(CPack)
