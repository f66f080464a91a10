# SPDX-License-Identifier: LGPL-2.1-or-later
#
# libdeal.ii of Debian draws in 200 libraries, most of them for geometries from
# CAD, which no scene needs; to relocate them takes the loader longer than all
# the rest of a start (doc/performance.md). Programs are linked to load empty
# libraries of the same names instead, with the few symbols that libdeal.ii
# asks for.
set(SEICHE_LEAVE_OUT "gmsh|TK[A-Za-z0-9]+" CACHE STRING
  "Libraries of deal.II to leave out at start, a regular expression; empty: none")

# Each has names of its own that it asks for.
if(CMAKE_BUILD_TYPE STREQUAL Debug)
  list(GET DEAL_II_LIBRARIES_DEBUG 0 deal_ii_library)
else()
  list(GET DEAL_II_LIBRARIES_RELEASE 0 deal_ii_library)
endif()
if(SEICHE_LEAVE_OUT)
  execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${deal_ii_library} OUTPUT_VARIABLE needed)
  execute_process(COMMAND ldd ${deal_ii_library} OUTPUT_VARIABLE loaded)
  string(REGEX MATCHALL "NEEDED +lib(${SEICHE_LEAVE_OUT})\\.so\\.[0-9.]+" needed "${needed}")
  if(NOT needed)
    message(WARNING "SEICHE_LEAVE_OUT = ${SEICHE_LEAVE_OUT} is no library that "
      "${deal_ii_library} needs.")
  endif()
endif()
# Those of an earlier choice would still be found.
if(NOT "${SEICHE_LEAVE_OUT}" STREQUAL "${SEICHE_LEFT_OUT}")
  file(REMOVE_RECURSE ${PROJECT_BINARY_DIR}/left_out)
  set(SEICHE_LEFT_OUT "${SEICHE_LEAVE_OUT}" CACHE INTERNAL "")
endif()
set(stand_ins)
foreach(line ${needed})
  string(REGEX MATCH "lib(.+)\\.so\\.(.+)$" file ${line})
  set(name ${CMAKE_MATCH_1})
  set(version ${CMAKE_MATCH_2})
  string(REGEX MATCH "=> ([^ \n]*/${file}) " found "${loaded}")
  if(NOT found)
    message(FATAL_ERROR "${file}, which ${deal_ii_library} needs, is not found: install "
      "it, or configure with -D SEICHE_LEAVE_OUT=\"\".")
  endif()
  set(source ${PROJECT_BINARY_DIR}/left_out/${name}.c)
  add_custom_command(OUTPUT ${source}
    COMMAND sh ${PROJECT_SOURCE_DIR}/cmake/stand_in.sh ${CMAKE_MATCH_1} ${deal_ii_library}
      > ${source}
    DEPENDS cmake/stand_in.sh ${deal_ii_library} ${CMAKE_MATCH_1} VERBATIM)
  add_library(left_out_${name} SHARED ${source})
  set_target_properties(left_out_${name} PROPERTIES OUTPUT_NAME ${name}
    SOVERSION ${version} LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/left_out)
  target_compile_options(left_out_${name} PRIVATE -w -fno-lto)
  list(APPEND stand_ins left_out_${name})
endforeach()

# seiche_leave_out(target): the empty libraries serve @p target, where it is
# built and where it is installed. Only an old RPATH holds for what libraries
# draw in themselves.
function(seiche_leave_out target)
  if(NOT stand_ins)
    return()
  endif()
  add_dependencies(${target} ${stand_ins})
  target_link_options(${target} PRIVATE -Wl,--disable-new-dtags
    -Wl,--allow-shlib-undefined)
  set_target_properties(${target} PROPERTIES
    BUILD_RPATH ${PROJECT_BINARY_DIR}/left_out
    INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR}/seiche)
endfunction()
