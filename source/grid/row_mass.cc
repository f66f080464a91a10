// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/row_mass.h>
#include <seiche/space/shape_integrals.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  RowMass<dim>::RowMass(const Occupancy<dim> &grid_occupancy, const bool needed)
    : occupancy(grid_occupancy)
    , is_needed(needed)
  {}

  template <int dim>
  void
  RowMass<dim>::reinit()
  {
    const unsigned int degree = occupancy.fe.degree;
    if (degree == 1 || !is_needed)
      return;
    const auto &line = line_integrals(degree), &hats = hat_integrals(degree);
    typename Occupancy<dim>::Vector of_shapes(occupancy.nodes.partitioner()),
      of_hats(of_shapes);
    for (const unsigned int cell : occupancy.cells.occupied())
      if (touches_wall(occupancy, cell))
        {
          add_volume_integrals(occupancy, cell, line, of_shapes);
          add_volume_integrals(occupancy, cell, hats, of_hats);
        }
    of_shapes.compress(VectorOperation::add);
    of_hats.compress(VectorOperation::add);
    factor.assign(occupancy.nodes.n_own(), 1.);
    // masters of hanging nodes may have sums without a meaning
    for (unsigned int node = 0; node < factor.size(); ++node)
      if (of_hats.local_element(node) > 0. &&
          of_shapes.local_element(node) > 0.)
        factor[node] =
          of_shapes.local_element(node) / of_hats.local_element(node);
  }

  template class RowMass<2>;
  template class RowMass<3>;
} // namespace seiche
