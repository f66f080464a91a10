// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_shape_integrals_h
#define seiche_space_shape_integrals_h

#include <seiche/space/occupancy.h>

#include <vector>

namespace seiche
{
  /// Integrals of the shape functions of a line of unit length.
  const std::vector<double> &
  line_integrals(const unsigned int degree);

  /// The same of the hats between the nodes.
  const std::vector<double> &
  hat_integrals(const unsigned int degree);

  /**
   * Add a cell's integrals of the products of @p line over its volume, or over
   * a @p face (numbers::invalid_unsigned_int: none), to the nodes that are
   * unknowns: V and A of doc/theory.md (8.2), the integrals of (8.0b).
   */
  template <int dim>
  void
  add_integrals(const Occupancy<dim>            &occupancy,
                const unsigned int               cell,
                const std::vector<double>       &line,
                const unsigned int               face,
                typename Occupancy<dim>::Vector &result);

  /// True if a node of the cell lies on a wall.
  template <int dim>
  bool
  touches_wall(const Occupancy<dim> &occupancy, const unsigned int cell);
} // namespace seiche

#endif
