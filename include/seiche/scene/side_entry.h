// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_side_entry_h
#define seiche_scene_side_entry_h

#include <seiche/scene/grid_parameters.h>

#include <cctype>
#include <string>

namespace seiche
{
  /// Entry of a side in subsection "Walls": its name with a capital letter.
  template <int dim>
  std::string
  side_entry(const unsigned int id)
  {
    std::string name = side_name<dim>(id);
    name[0]          = std::toupper(name[0]);
    return name;
  }
} // namespace seiche

#endif
