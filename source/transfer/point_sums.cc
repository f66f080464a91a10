// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_range.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/point_sums.h>
#include <seiche/transfer/point_velocity.h>
#include <seiche/transfer/unseen_momentum.h>

namespace seiche
{
  namespace
  {
    /// Sums over the points of one cell, by node: the loops over nodes are
    /// the ones that vectorise.
    template <int dim, int degree>
    struct CellSums
    {
      static constexpr unsigned int n_nodes = Basis<dim, degree>::n_nodes;

      double mass[n_nodes]              = {}; // [kg]
      double pressure[n_nodes]          = {}; // [kg Pa]
      double momentum[dim][n_nodes]     = {}; // [kg m/s]
      double acceleration[dim][n_nodes] = {}; // [kg m/s^2]
    };



    /**
     * Momentum of node I: sum_p m_p N_I(x_p) (v_p + C_p (x_I - x_p)), Jiang,
     * Schroeder, Teran (2017), eq. (17), with C the gradient itself (TPIC).
     * On a box x_I = lower + s_I h, so that v_p + C_p (lower - x_p) is shared
     * by all nodes. N are the positive hats, which for FE_Q(1) are the shape
     * functions.
     */
    template <int dim, int degree, bool affine, bool with_acceleration>
    CellSums<dim, degree>
    sum_cell(const PointArrays<dim, const PointCloud<dim>> &arrays,
             const PointVelocity<dim>                      &velocity,
             const PointCloud<dim>                         &points,
             const unsigned int                             cell)
    {
      using Shape                       = Basis<dim, degree>;
      constexpr unsigned int   n_nodes  = Shape::n_nodes;
      const CellGeometry<dim> &geometry = points.locator.cells.geometry(cell);
      PointBatch<dim, degree, double> point; // its loops are over nodes
      CellSums<dim, degree>           sums;
      for_each_range(points, cell, [&](const PointRange &range) {
        const auto units = geometry.to_unit(range.position(arrays.position));
        for (unsigned int l = 0; l < range.size; ++l)
          {
            const std::size_t  p = range.first + l;
            dealii::Point<dim> unit;
            for (unsigned int d = 0; d < dim; ++d)
              unit[d] = units[d][l];
            point.reinit_weights(unit);
            double N[n_nodes];
            for (unsigned int i = 0; i < n_nodes; ++i)
              {
                N[i] = point.weight(i) * arrays.mass[p];
                sums.mass[i] += N[i];
                sums.pressure[i] += N[i] * arrays.pressure[p];
              }
            for (unsigned int c = 0; c < dim; ++c)
              {
                double base       = velocity.value(p, c);
                double slope[dim] = {};
                if (affine)
                  for (unsigned int d = 0; d < dim; ++d)
                    {
                      slope[d] =
                        velocity.derivative(p, c, d) * geometry.edges[d];
                      base -= slope[d] * unit[d];
                      slope[d] /= degree; // from node to node
                    }
                for (unsigned int i = 0; i < n_nodes; ++i)
                  {
                    double value = base;
                    if (affine)
                      for (unsigned int d = 0; d < dim; ++d)
                        value += Shape::line_index(i, d) * slope[d];
                    sums.momentum[c][i] += N[i] * value;
                    if (with_acceleration)
                      sums.acceleration[c][i] +=
                        N[i] * arrays.acceleration[c][p];
                  }
              }
          }
      });
      return sums;
    }



    /// The same for a cell with hanging nodes, at its masters: x_I is the
    /// place of the master, and N_I its share of the point.
    template <int dim, int degree, bool with_acceleration>
    CellSums<dim, degree>
    sum_hanging_cell(const PointArrays<dim, const PointCloud<dim>> &arrays,
                     const PointVelocity<dim>                      &velocity,
                     const PointCloud<dim>                         &points,
                     const Occupancy<dim>                          &occupancy,
                     const unsigned int                             cell)
    {
      constexpr unsigned int n_nodes = Basis<dim, degree>::n_nodes;
      const auto             nodes = occupancy.template unknowns<degree>(cell);
      PointBatch<dim, degree, double> point;
      CellSums<dim, degree>           sums;
      for (const std::size_t p : points.points_in(cell))
        {
          const dealii::Point<dim> x = points.position(p);
          double                   N[n_nodes];
          point.reinit_weights(points.locator.cells.geometry(cell).to_unit(x));
          for (unsigned int i = 0; i < n_nodes; ++i)
            N[i] = point.weight(i);
          nodes.condense(N);
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              N[i] *= arrays.mass[p];
              sums.mass[i] += N[i];
              sums.pressure[i] += N[i] * arrays.pressure[p];
              const dealii::Tensor<1, dim> arm =
                points.locator.image(occupancy.nodes.position(nodes[i]), cell) -
                x;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  sums.momentum[c][i] +=
                    N[i] * velocity.value_beside(p, c, arm);
                  if (with_acceleration)
                    sums.acceleration[c][i] += N[i] * arrays.acceleration[c][p];
                }
            }
        }
      return sums;
    }



    template <int dim, int degree, bool with_acceleration>
    void
    add_cells(const PointCloud<dim> &points,
              const Occupancy<dim>  &occupancy,
              const GradientUse      gradient,
              GridState<dim>        &state)
    {
      constexpr unsigned int n_nodes = Basis<dim, degree>::n_nodes;
      const PointArrays<dim, const PointCloud<dim>> arrays(points);
      // entries of ghost nodes follow those of own nodes
      double *mass         = state.mass.begin();
      double *pressure     = state.pressure_guess.begin();
      double *momentum     = state.velocity_n.begin();
      double *acceleration = state.acceleration_n.begin();
      for (const unsigned int cell : occupancy.cells.occupied())
        {
          if (occupancy.degree(cell) != degree)
            continue;
          const auto nodes = occupancy.template unknowns<degree>(cell);
          const PointVelocity<dim> velocity(
            arrays, gradient, points, occupancy, cell);
          const auto                  sum = velocity.is_affine() ?
                                              sum_cell<dim, degree, true, with_acceleration> :
                                              sum_cell<dim, degree, false, with_acceleration>;
          const CellSums<dim, degree> sums =
            nodes.matrix != nullptr ?
              sum_hanging_cell<dim, degree, with_acceleration>(
                arrays, velocity, points, occupancy, cell) :
              sum(arrays, velocity, points, cell);
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              mass[nodes[i]] += sums.mass[i];
              pressure[nodes[i]] += sums.pressure[i];
              for (unsigned int c = 0; c < dim; ++c)
                {
                  momentum[dim * nodes[i] + c] += sums.momentum[c][i];
                  if (with_acceleration)
                    acceleration[dim * nodes[i] + c] += sums.acceleration[c][i];
                }
            }
        }
    }
  } // namespace

  template <int dim>
  void
  sum_to_nodes(const PointCloud<dim> &points,
               const Occupancy<dim>  &occupancy,
               const GradientUse      gradient,
               const bool             is_consistent,
               const bool             linear_cells_only,
               GridState<dim>        &state)
  {
    const bool with_acceleration =
      state.acceleration_n.size() > 0 && points.has(PointColumn::acceleration);
    using Vector               = typename GridState<dim>::Vector;
    std::vector<Vector *> sums = {&state.mass,
                                  &state.pressure_guess,
                                  &state.velocity_n};
    if (state.acceleration_n.size() > 0)
      sums.push_back(&state.acceleration_n);
    const bool any_unseen = occupancy.zero_components.exist();
    if (any_unseen)
      sums.insert(sums.end(), {&state.unseen_mass, &state.unseen_velocity});
    for (Vector *vector : sums)
      {
        *vector = 0.; // own entries
        vector->zero_out_ghost_values();
      }
    occupancy.for_each_degree([&](const auto degree) {
      const auto add = with_acceleration ? add_cells<dim, degree, true> :
                                           add_cells<dim, degree, false>;
      if (degree == 1 || !linear_cells_only)
        add(points, occupancy, gradient, state);
    });
    if (any_unseen)
      sum_unseen(
        points, occupancy, gradient, is_consistent, linear_cells_only, state);
    for (Vector *vector : sums)
      vector->compress(dealii::VectorOperation::add);
    if (any_unseen)
      state.velocity_n.add(-1., state.unseen_velocity);
  }

#define INSTANTIATE(dim)                              \
  template void sum_to_nodes(const PointCloud<dim> &, \
                             const Occupancy<dim> &,  \
                             const GradientUse,       \
                             const bool,              \
                             const bool,              \
                             GridState<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
