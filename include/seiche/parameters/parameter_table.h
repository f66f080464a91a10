// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_parameter_table_h
#define seiche_parameters_parameter_table_h

#include <seiche/parameters/declarations.h>

#include <string>
#include <vector>

namespace seiche
{
  /// Manual of all entries as markdown, one table a subsection, from the
  /// declarations of a 2D and a 3D scene. doc/parameters.md is this text.
  std::string
  parameter_table(const std::vector<Declaration> &in_2d,
                  const std::vector<Declaration> &in_3d);
} // namespace seiche

#endif
