# SPDX-License-Identifier: LGPL-2.1-or-later

# seiche_embed(result folder files...): append the files to the source text
# @p result as rows of the table of embedded_files.cc.in. A file that changes
# configures anew.
function(seiche_embed result folder)
  set(rows "${${result}}")
  foreach(file ${ARGN})
    file(READ ${file} text)
    get_filename_component(name ${file} NAME_WE)
    string(APPEND rows "{\"${folder}\", \"${name}\", R\"=====(${text})=====\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  set(${result} "${rows}" PARENT_SCOPE)
endfunction()
