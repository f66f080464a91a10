// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_surface_file_h
#define seiche_scene_surface_file_h

#include <seiche/shapes/triangle_surface.h>

#include <string>

namespace seiche
{
  class InputFile;

  /// The surface of a body from the file that the entry @p path names (STL,
  /// OBJ, PLY, OFF; assimp), relative to the parameter file. Vertices at the
  /// same place are one. InputError if it cannot be read or bounds no body.
  TriangleSurface
  read_surface(const InputFile   &input,
               const std::string &path,
               const std::string &file);
} // namespace seiche

#endif
