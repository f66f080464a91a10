// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_range.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/extrapolation.h>
#include <seiche/transfer/mass_matrix.h>
#include <seiche/transfer/point_velocity.h>
#include <seiche/transfer/transfer.h>
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
          const PointVelocity<dim>    velocity(arrays, gradient, points, cell);
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



    /// Masses of the nodes, and sums in place of the fields that are means
    /// weighted by them. Collective.
    template <int dim>
    void
    sum_cells(const PointCloud<dim> &points,
              const Occupancy<dim>  &occupancy,
              const GradientUse      gradient,
              const bool             linear_cells_only,
              GridState<dim>        &state)
    {
      const bool with_acceleration = state.acceleration_n.size() > 0 &&
                                     points.has(PointColumn::acceleration);
      using Vector               = typename GridState<dim>::Vector;
      std::vector<Vector *> sums = {&state.mass,
                                    &state.pressure_guess,
                                    &state.velocity_n};
      if (state.acceleration_n.size() > 0)
        sums.push_back(&state.acceleration_n);
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
      for (Vector *vector : sums)
        vector->compress(dealii::VectorOperation::add);
    }



    /// Sums to means. Own nodes.
    template <int dim>
    void
    divide_by_mass(const Occupancy<dim> &occupancy,
                   const bool            with_acceleration,
                   GridState<dim>       &state)
    {
      const double *mass         = state.mass.begin();
      double       *pressure     = state.pressure_guess.begin();
      double       *velocity     = state.velocity_n.begin();
      double       *acceleration = state.acceleration_n.begin();
      const double *unseen =
        state.unseen_mass.size() > 0 ? state.unseen_mass.begin() : nullptr;
      constexpr double nothing = 1e-12; // of the mass: round-off
      for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
        {
          const double inverse = mass[node] > 0. ? 1. / mass[node] : 0.;
          pressure[node] *= inverse;
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double seen =
                mass[node] - (unseen != nullptr ? unseen[dim * node + c] : 0.);
              velocity[dim * node + c] *=
                seen > nothing * mass[node] ? 1. / seen : 0.;
              if (with_acceleration)
                acceleration[dim * node + c] *= inverse;
            }
        }
    }
  } // namespace



  template <int dim>
  void
  Transfer<dim>::points_to_grid(const PointCloud<dim> &points,
                                GridState<dim>        &state) const
  {
    const bool with_acceleration =
      state.acceleration_n.size() > 0 && points.has(PointColumn::acceleration);
    sum_cells(points,
              occupancy,
              method.gradient,
              /*linear_cells_only=*/false,
              state);
    const bool is_consistent = parameters.is_consistent(occupancy.fe.degree);
    const bool any_unseen    = occupancy.constraints.exist_zeros();
    if (any_unseen)
      take_out_unseen(points, occupancy, method.gradient, is_consistent, state);
    divide_by_mass(occupancy, with_acceleration, state);
    state.mass.update_ghost_values();
    state.pressure_guess.update_ghost_values();
    state.velocity_n.update_ghost_values();
    if (state.acceleration_n.size() > 0)
      state.acceleration_n.update_ghost_values();
    if (is_consistent)
      find_closest(points, state);
    if (any_unseen)
      find_unseen_velocity(is_consistent, state);
    if (method.update == VelocityUpdate::fmpm ||
        method.update == VelocityUpdate::xpic)
      expand_series(points, state);
    if (fill.has_surface())
      extrapolate_fields(points, occupancy, state);
    if (with_acceleration)
      {
        occupancy.constraints.for_each_fixed([&](const auto &direction) {
          direction.set(state.acceleration_n, 0.);
        });
        state.acceleration_n.update_ghost_values();
      }
  }



  template <int dim>
  void
  Transfer<dim>::find_closest(const PointCloud<dim> &points,
                              GridState<dim>        &state) const
  {
    const bool     lumps = parameters.lumps_linear_cells();
    GridState<dim> lumped; // of linear cells
    lumped.reinit(occupancy, false, state.acceleration_n.size() > 0);
    if (lumps)
      sum_cells(points,
                occupancy,
                method.gradient,
                /*linear_cells_only=*/true,
                lumped);
    const MassMatrix<dim> mass(points,
                               fill,
                               materials,
                               /*ghost_penalty=*/true,
                               lumps ? &lumped.mass : nullptr);
    const auto            solve = [&](const PointColumn                      column,
                           const typename GridState<dim>::Vector &sum,
                           typename GridState<dim>::Vector       &result) {
      typename GridState<dim>::Vector momentum;
      mass.right_hand_side(column, momentum);
      momentum += sum;
      mass.solve(result, momentum);
      result.update_ghost_values();
    };
    solve(PointColumn::velocity, lumped.velocity_n, state.velocity_n);
    if (state.acceleration_n.size() > 0)
      solve(PointColumn::acceleration,
            lumped.acceleration_n,
            state.acceleration_n);
  }



  template <int dim>
  void
  Transfer<dim>::expand_series(const PointCloud<dim> &points,
                               GridState<dim>        &state) const
  {
    using Vector = typename GridState<dim>::Vector;
    const MassMatrix<dim> mass(
      points, fill, materials, /*ghost_penalty=*/false, /*lumped=*/nullptr);
    Vector momentum, velocity(state.velocity_n);
    mass.right_hand_side(PointColumn::velocity, momentum);
    mass.expand(velocity, momentum, state.mass, parameters.order - 1);
    velocity.update_ghost_values();
    (method.update == VelocityUpdate::fmpm ? state.velocity_n :
                                             state.velocity_series) = velocity;
  }



  template void
  Transfer<2>::points_to_grid(const PointCloud<2> &, GridState<2> &) const;
  template void
  Transfer<3>::points_to_grid(const PointCloud<3> &, GridState<3> &) const;
} // namespace seiche
