// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_height_map_file_h
#define seiche_scene_height_map_file_h

#include <seiche/shapes/height_map.h>

#include <string>

namespace seiche
{
  class InputFile;

  /// The heights of a file, relative to the parameter file: CSV (a CsvFile with
  /// x and height, in 3D x, y and height on a rectangular lattice, rows in any
  /// order) or, in 3D, an ESRI grid (name ends with .asc). InputError of the
  /// entry @p path if the file is none, if heights are missing, or if the map
  /// does not reach over @p domain. Local.
  template <int dim>
  HeightMap<dim>
  read_height_map(const InputFile                &input,
                  const std::string              &path,
                  const std::string              &file,
                  const dealii::BoundingBox<dim> &domain);
} // namespace seiche

#endif
