# SPDX-License-Identifier: LGPL-2.1-or-later
#
# What `cmake --install` puts where. Two components: `program` (program, scripts,
# scenes, documents) and `development` (headers, libraries, find_package).
include(CMakePackageConfigHelpers)

set(SEICHE_PYTHON_DIR lib/python CACHE STRING
  "Below the prefix: where `import seiche_output` is found (packages: that of Debian)")
set(seiche_share ${CMAKE_INSTALL_DATADIR}/seiche)

# install_link(target link): a link to `target`, both below the prefix.
function(install_link target link)
  get_filename_component(folder ${link} DIRECTORY)
  file(RELATIVE_PATH way /${folder} /${target})
  install(CODE "
    set(link \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${link}\")
    get_filename_component(folder \"\${link}\" DIRECTORY)
    file(MAKE_DIRECTORY \"\${folder}\")
    file(CREATE_LINK ${way} \"\${link}\" SYMBOLIC)
    message(STATUS \"Installing: \${link} -> ${way}\")" COMPONENT program)
endfunction()

install(TARGETS seiche RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
if(stand_ins)
  install(TARGETS ${stand_ins} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/seiche
    COMPONENT program NAMELINK_SKIP)
endif()
install(DIRECTORY prm DESTINATION ${seiche_share} COMPONENT program)
install(FILES README.md CHANGELOG.md CITATION.cff doc/references.bib
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright
  COMPONENT program)

# The scripts stay together, for they import modules beside them: Python looks
# where a link leads to.
set(scripts seiche-plot:plot_run seiche-study:study seiche-pictures:pictures
  seiche-mpirun:mpirun)
file(GLOB modules contrib/seiche_*.py)
list(FILTER modules EXCLUDE REGEX "seiche_paper")
install(FILES ${modules} DESTINATION ${seiche_share}/scripts COMPONENT program)
foreach(script ${scripts})
  string(REPLACE ":" ";" names ${script})
  list(GET names 0 name)
  list(GET names 1 file)
  install(PROGRAMS contrib/${file} DESTINATION ${seiche_share}/scripts COMPONENT program)
  install_link(${seiche_share}/scripts/${file} ${CMAKE_INSTALL_BINDIR}/${name})
endforeach()
foreach(module seiche_output seiche_walls) # the first imports the second
  install_link(${seiche_share}/scripts/${module}.py ${SEICHE_PYTHON_DIR}/${module}.py)
endforeach()

# The manual page is what --help says.
find_program(HELP2MAN_EXECUTABLE help2man)
mark_as_advanced(HELP2MAN_EXECUTABLE)
if(HELP2MAN_EXECUTABLE)
  add_custom_command(OUTPUT seiche.1
    COMMAND ${CMAKE_COMMAND} -E env OMP_NUM_THREADS=1 ${HELP2MAN_EXECUTABLE}
      --no-info --name "${PROJECT_DESCRIPTION}" --output seiche.1
      $<TARGET_FILE:seiche>
    DEPENDS seiche VERBATIM)
  add_custom_target(manual_page ALL DEPENDS seiche.1)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/seiche.1
    DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
else()
  message(STATUS "No manual page: it needs help2man")
endif()

set(config ${CMAKE_INSTALL_LIBDIR}/cmake/seiche)
foreach(layer ${seiche_layers})
  install(TARGETS seiche_${layer} EXPORT seicheTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()
install(TARGETS seiche_interface EXPORT seicheTargets)
install(DIRECTORY include/seiche ${CMAKE_CURRENT_BINARY_DIR}/include/seiche
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.h")
install(EXPORT seicheTargets NAMESPACE seiche:: DESTINATION ${config}
  COMPONENT development)
configure_package_config_file(cmake/seicheConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/seicheConfig.cmake INSTALL_DESTINATION ${config}
  NO_SET_AND_CHECK_MACRO)
# below 1.0 each second number may change the face
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/seicheConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/seicheConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/seicheConfigVersion.cmake
  DESTINATION ${config} COMPONENT development)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
