// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/shape_integrals.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  const std::vector<double> &
  line_integrals(const unsigned int degree)
  {
    static const std::vector<double> linear    = {1. / 2., 1. / 2.},
                                     quadratic = {1. / 6., 4. / 6., 1. / 6.};
    AssertIndexRange(degree, 3);
    return degree == 1 ? linear : quadratic;
  }

  const std::vector<double> &
  hat_integrals(const unsigned int degree)
  {
    static const std::vector<double> one = {1. / 2., 1. / 2.},
                                     two = {1. / 4., 1. / 2., 1. / 4.};
    AssertIndexRange(degree, 3);
    return degree == 1 ? one : two;
  }

  template <int dim>
  void
  add_integrals(const Occupancy<dim>            &occupancy,
                const unsigned int               cell,
                const std::vector<double>       &line,
                const unsigned int               face,
                typename Occupancy<dim>::Vector &result)
  {
    constexpr unsigned int all    = numbers::invalid_unsigned_int;
    const Tensor<1, dim>   extent = occupancy.locator.geometry(cell).edges;
    double                 integrals[HangingNodes<dim>::max_nodes];
    for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
      {
        integrals[a] = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int place =
              line_index<dim>(occupancy.fe.degree, a, d);
            if (face == all || d != face / 2)
              integrals[a] *= extent[d] * line[place];
            else if (place != (face % 2) * occupancy.fe.degree)
              integrals[a] = 0.;
          }
      }
    occupancy.condense(cell, integrals);
    for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
      result.local_element(occupancy.cell_nodes(cell)[a]) += integrals[a];
  }

  template <int dim>
  bool
  touches_wall(const Occupancy<dim> &occupancy, const unsigned int cell)
  {
    const unsigned int *nodes = occupancy.cell_nodes(cell);
    return std::any_of(nodes,
                       nodes + occupancy.nodes_per_cell(),
                       [&](const unsigned int node) {
                         return occupancy.constraints.wall_components(node) !=
                                0;
                       });
  }

#define INSTANTIATE(dim)                                          \
  template void add_integrals(const Occupancy<dim> &,             \
                              const unsigned int,                 \
                              const std::vector<double> &,        \
                              const unsigned int,                 \
                              typename Occupancy<dim>::Vector &); \
  template bool touches_wall(const Occupancy<dim> &, const unsigned int);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
