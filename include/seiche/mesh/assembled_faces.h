// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_assembled_faces_h
#define seiche_mesh_assembled_faces_h

#include <seiche/mesh/cell_locator.h>

namespace seiche
{
  /// Call f(lower, upper, direction) for each face between two cells that
  /// @p takes_part, on the rank that assembles it: the lower of the two
  /// owners, and that of the finer cell at a level jump. @p cells: own cells
  /// that take part. Local.
  template <int dim, typename Predicate, typename Function>
  void
  for_each_assembled_face(const CellLocator<dim>          &locator,
                          const std::vector<unsigned int> &cells,
                          const Predicate                 &takes_part,
                          const Function                  &f)
  {
    for (const unsigned int cell : cells)
      for (unsigned int direction = 0; direction < dim; ++direction)
        for (const bool other_is_upper : {true, false})
          {
            const unsigned int other =
              locator.cells.neighbor(cell, BoxFace(direction, other_is_upper));
            if (other == locator.invalid || !takes_part(other))
              continue;
            const bool jump =
              locator.cells.level(other) < locator.cells.level(cell);
            if (other_is_upper && (jump || locator.cells.owner(cell) <=
                                             locator.cells.owner(other)))
              f(cell, other, direction);
            else if (!other_is_upper && (jump || locator.cells.owner(cell) <
                                                   locator.cells.owner(other)))
              f(other, cell, direction);
          }
  }
} // namespace seiche

#endif
