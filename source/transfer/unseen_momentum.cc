// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/point_batch.h>
#include <seiche/transfer/unseen_momentum.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim, int degree>
    void
    add_cells(const PointCloud<dim> &points,
              const Occupancy<dim>  &occupancy,
              const GradientUse      gradient,
              const bool             is_consistent,
              GridState<dim>        &state)
    {
      constexpr unsigned int n_nodes = Basis<dim, degree>::n_nodes;
      const PointArrays<dim, const PointCloud<dim>> arrays(points);
      PointBatch<dim, degree, double>               point;
      const bool with_acceleration = state.acceleration_n.size() > 0 &&
                                     points.has(PointColumn::acceleration);
      for (const unsigned int cell : occupancy.cells.occupied())
        {
          if (occupancy.degree(cell) != degree)
            continue;
          const auto nodes = occupancy.template unknowns<degree>(cell);
          if (nodes.zeros == nullptr)
            continue;
          const PointVelocity<dim> velocity(
            arrays, gradient, points, occupancy, cell);
          for (const std::size_t p : points.points_in(cell))
            {
              const Point<dim> x = points.position(p);
              const Point<dim> unit =
                points.locator.cells.geometry(cell).to_unit(x);
              // what points take back is weighted with N, not with the hats
              if (is_consistent)
                point.reinit_values(unit);
              else
                point.reinit_weights(unit);
              double unseen[dim][n_nodes] = {};
              nodes.for_each_zero(
                [&](const unsigned int c, const unsigned int a) {
                  unseen[c][a] = arrays.mass[p] *
                                 (is_consistent ? point.N[a] : point.weight(a));
                });
              for (auto &component : unseen)
                nodes.condense(component);
              for (unsigned int i = 0; i < n_nodes; ++i)
                {
                  const Tensor<1, dim> arm =
                    points.locator.image(occupancy.nodes.position(nodes[i]),
                                         cell) -
                    x;
                  for (unsigned int c = 0; c < dim; ++c)
                    {
                      const unsigned int entry = dim * nodes[i] + c;
                      state.unseen_mass.local_element(entry) += unseen[c][i];
                      state.unseen_velocity.local_element(entry) +=
                        unseen[c][i] * velocity.value_beside(p, c, arm);
                      if (with_acceleration)
                        state.acceleration_n.local_element(entry) -=
                          unseen[c][i] * arrays.acceleration[c][p];
                    }
                }
            }
        }
    }
  } // namespace

  template <int dim>
  void
  sum_unseen(const PointCloud<dim> &points,
             const Occupancy<dim>  &occupancy,
             const GradientUse      gradient,
             const bool             is_consistent,
             const bool             linear_cells_only,
             GridState<dim>        &state)
  {
    occupancy.for_each_degree([&](const auto degree) {
      if (degree == 1 || !linear_cells_only)
        add_cells<dim, degree>(
          points, occupancy, gradient, is_consistent, state);
    });
  }

#define INSTANTIATE(dim)                            \
  template void sum_unseen(const PointCloud<dim> &, \
                           const Occupancy<dim> &,  \
                           const GradientUse,       \
                           const bool,              \
                           const bool,              \
                           GridState<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
