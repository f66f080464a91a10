// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/point_arrays.h>
#include <seiche/transfer/transfer.h>
#include <seiche/utilities/shape_functions.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    /// Sums over the points of one cell, by node: the loops over nodes are
    /// the ones that vectorise.
    template <int dim>
    struct CellSums
    {
      static constexpr unsigned int n_nodes = LinearShape<dim>::n_nodes;

      double mass[n_nodes]              = {}; // [kg]
      double pressure[n_nodes]          = {}; // [kg Pa]
      double momentum[dim][n_nodes]     = {}; // [kg m/s]
      double acceleration[dim][n_nodes] = {}; // [kg m/s^2]
    };



    /**
     * Momentum of node I: sum_p m_p N_I(x_p) (v_p + C_p (x_I - x_p)), Jiang,
     * Schroeder, Teran (2017), eq. (17), with C the gradient itself (TPIC).
     * On a box x_I = lower + s_I h, so that v_p + C_p (lower - x_p) is shared
     * by all nodes.
     */
    template <int dim, bool affine, bool with_acceleration>
    CellSums<dim>
    sum_cell(const PointArrays<dim, const PointCloud<dim>> &arrays,
             const std::size_t                              begin,
             const std::size_t                              end,
             const dealii::Point<dim>                      &lower,
             const dealii::Tensor<1, dim>                  &extent,
             const double                                   gradient_share)
    {
      constexpr unsigned int n_nodes = LinearShape<dim>::n_nodes;
      CellSums<dim>          sums;
      double                 inverse_extent[dim];
      for (unsigned int d = 0; d < dim; ++d)
        inverse_extent[d] = 1. / extent[d];
      for (std::size_t p = begin; p < end; ++p)
        {
          dealii::Point<dim> unit;
          for (unsigned int d = 0; d < dim; ++d)
            unit[d] = (arrays.position[d][p] - lower[d]) * inverse_extent[d];
          double N[n_nodes];
          LinearShape<dim>::values(unit, N);
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              N[i] *= arrays.mass[p];
              sums.mass[i] += N[i];
              sums.pressure[i] += N[i] * arrays.pressure[p];
            }
          for (unsigned int c = 0; c < dim; ++c)
            {
              double base       = arrays.velocity[c][p];
              double slope[dim] = {};
              if (affine)
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    slope[d] = gradient_share *
                               arrays.gradient[c * dim + d][p] * extent[d];
                    base -= slope[d] * unit[d];
                  }
              for (unsigned int i = 0; i < n_nodes; ++i)
                {
                  double value = base;
                  if (affine)
                    for (unsigned int d = 0; d < dim; ++d)
                      value += LinearShape<dim>::corner(i, d) * slope[d];
                  sums.momentum[c][i] += N[i] * value;
                  if (with_acceleration)
                    sums.acceleration[c][i] += N[i] * arrays.acceleration[c][p];
                }
            }
        }
      return sums;
    }



    /// The same for a cell with hanging nodes, at its masters: x_I is the
    /// place of the master, and N_I its share of the point.
    template <int dim>
    CellSums<dim>
    sum_hanging_cell(const PointArrays<dim, const PointCloud<dim>> &arrays,
                     const PointCloud<dim>                         &points,
                     const Occupancy<dim>                          &occupancy,
                     const unsigned int                             cell,
                     const double gradient_share,
                     const bool   with_acceleration)
    {
      constexpr unsigned int n_nodes = LinearShape<dim>::n_nodes;
      const unsigned int    *nodes   = occupancy.cell_nodes(cell);
      CellSums<dim>          sums;
      for (std::size_t p = points.first_point(cell);
           p < points.first_point(cell + 1);
           ++p)
        {
          const dealii::Point<dim> x = points.position(p);
          double                   N[n_nodes];
          LinearShape<dim>::values(points.locator.to_unit(cell, x), N);
          occupancy.condense(cell, N);
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              N[i] *= arrays.mass[p];
              sums.mass[i] += N[i];
              sums.pressure[i] += N[i] * arrays.pressure[p];
              const dealii::Tensor<1, dim> arm =
                occupancy.node_position(nodes[i]) - x;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  double value = arrays.velocity[c][p];
                  if (gradient_share > 0.)
                    for (unsigned int d = 0; d < dim; ++d)
                      value += gradient_share *
                               arrays.gradient[c * dim + d][p] * arm[d];
                  sums.momentum[c][i] += N[i] * value;
                  if (with_acceleration)
                    sums.acceleration[c][i] += N[i] * arrays.acceleration[c][p];
                }
            }
        }
      return sums;
    }



    /// Share of the velocity gradient that the points of a cell pass on. Few
    /// points define no gradient (one in dim dimensions takes dim + 1): C would
    /// feed on itself through nodes of little mass, to which it extrapolates,
    /// and spray explode.
    template <int dim>
    double
    gradient_share(const unsigned int n_points)
    {
      return std::min(1., (static_cast<double>(n_points) - 1.) / (dim + 1.));
    }



    template <int dim, bool affine, bool with_acceleration>
    void
    sum_all_cells(const PointCloud<dim> &points,
                  const Occupancy<dim>  &occupancy,
                  GridState<dim>        &state)
    {
      constexpr unsigned int n_nodes = LinearShape<dim>::n_nodes;
      const PointArrays<dim, const PointCloud<dim>> arrays(points);
      const CellLocator<dim>                       &locator = points.locator;
      // entries of ghost nodes follow those of own nodes
      double *mass         = state.mass.begin();
      double *pressure     = state.pressure_guess.begin();
      double *momentum     = state.velocity_n.begin();
      double *acceleration = state.acceleration_n.begin();
      for (const unsigned int cell : occupancy.occupied_cells())
        {
          const double share =
            affine ? gradient_share<dim>(points.n_points_in(cell)) : 0.;
          const auto          sum = share > 0. ?
                                      sum_cell<dim, affine, with_acceleration> :
                                      sum_cell<dim, false, with_acceleration>;
          const CellSums<dim> sums =
            occupancy.hanging().has_matrix(cell) ?
              sum_hanging_cell(
                arrays, points, occupancy, cell, share, with_acceleration) :
              sum(arrays,
                  points.first_point(cell),
                  points.first_point(cell + 1),
                  locator.lower_corner(cell),
                  locator.extent(cell),
                  share);
          const unsigned int *nodes = occupancy.cell_nodes(cell);
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



    /// Sums to means; components that walls fix are zero. Own nodes.
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
      for (unsigned int node = 0; node < occupancy.n_own_nodes(); ++node)
        {
          const double       inverse = mass[node] > 0. ? 1. / mass[node] : 0.;
          const unsigned int fixed   = occupancy.fixed_components(node);
          pressure[node] *= inverse;
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double factor = (fixed >> c) & 1u ? 0. : inverse;
              velocity[dim * node + c] *= factor;
              if (with_acceleration)
                acceleration[dim * node + c] *= factor;
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

    const auto sum = method.affine ?
                       (with_acceleration ? &sum_all_cells<dim, true, true> :
                                            &sum_all_cells<dim, true, false>) :
                       (with_acceleration ? &sum_all_cells<dim, false, true> :
                                            &sum_all_cells<dim, false, false>);
    sum(points, occupancy, state);
    for (Vector *vector : sums)
      vector->compress(dealii::VectorOperation::add);
    divide_by_mass(occupancy, with_acceleration, state);
    for (Vector *vector : sums)
      vector->update_ghost_values();
    state.velocity_start = state.velocity_n;
    state.velocity_start.update_ghost_values();
  }



  template void
  Transfer<2>::points_to_grid(const PointCloud<2> &, GridState<2> &) const;
  template void
  Transfer<3>::points_to_grid(const PointCloud<3> &, GridState<3> &) const;
} // namespace seiche
