// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_shape_integrals_h
#define seiche_space_shape_integrals_h

#include <seiche/space/occupancy.h>

#include <algorithm>
#include <vector>

namespace seiche
{
  /// Integrals of the shape functions of a line of unit length.
  const std::vector<double> &
  line_integrals(const unsigned int degree);

  /// The same of the hats between the nodes.
  const std::vector<double> &
  hat_integrals(const unsigned int degree);

  /// Add the products of factor(direction, place on the line) of a cell's nodes
  /// to those that are unknowns.
  template <int dim, typename Factor>
  void
  add_products(const Occupancy<dim>            &occupancy,
               const unsigned int               cell,
               const Factor                    &factor,
               typename Occupancy<dim>::Vector &result)
  {
    double products[HangingNodes<dim>::max_nodes];
    for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
      {
        products[a] = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          products[a] *= factor(d, line_index<dim>(occupancy.fe.degree, a, d));
      }
    occupancy.condense(cell, products);
    for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
      result.local_element(occupancy.nodes.of_cell(cell)[a]) += products[a];
  }

  /// Add the integrals of the products of @p line over a cell: V of
  /// doc/theory.md (8.2), the integrals of (8.0b).
  template <int dim>
  void
  add_volume_integrals(const Occupancy<dim>            &occupancy,
                       const unsigned int               cell,
                       const std::vector<double>       &line,
                       typename Occupancy<dim>::Vector &result)
  {
    const auto extent = occupancy.locator.cells.geometry(cell).edges;
    const auto factor = [&](const unsigned int d, const unsigned int place) {
      return extent[d] * line[place];
    };
    add_products(occupancy, cell, factor, result);
  }

  /// The same over a face: A of (8.2).
  template <int dim>
  void
  add_area_integrals(const Occupancy<dim>            &occupancy,
                     const unsigned int               cell,
                     const BoxFace                    face,
                     const std::vector<double>       &line,
                     typename Occupancy<dim>::Vector &result)
  {
    const auto         extent = occupancy.locator.cells.geometry(cell).edges;
    const unsigned int plane  = face.is_upper() ? occupancy.fe.degree : 0;
    const auto factor = [&](const unsigned int d, const unsigned int place) {
      return d != face.direction() ? extent[d] * line[place] :
                                     double(place == plane);
    };
    add_products(occupancy, cell, factor, result);
  }

  /// True if a node of the cell lies on a wall.
  template <int dim>
  bool
  touches_wall(const Occupancy<dim> &occupancy, const unsigned int cell)
  {
    const unsigned int *nodes = occupancy.nodes.of_cell(cell);
    return std::any_of(nodes,
                       nodes + occupancy.nodes_per_cell(),
                       [&](const unsigned int node) {
                         return occupancy.constraints.wall_components(node) !=
                                0;
                       });
  }
} // namespace seiche

#endif
