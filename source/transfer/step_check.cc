// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/held_points.h>
#include <seiche/transfer/point_arrays.h>
#include <seiche/transfer/point_block.h>
#include <seiche/transfer/transfer.h>
#include <seiche/transfer/wall_faces.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>

#include <cmath>

// The trial of a step: what it would do to the points.
namespace seiche
{
  namespace
  {
    /// True if no point of a cell with these displacements can move farther
    /// than @p limit times reach or change its volume by more than a third:
    /// gradients and values of FE_Q(1) lie between those of edges and nodes.
    template <int dim>
    bool
    is_gentle(const CellField<dim, 1>      &u,
              const dealii::Tensor<1, dim> &extent,
              const dealii::Tensor<1, dim> &reach,
              const double                  limit)
    {
      constexpr double small = 0.3; // |grad u|, so that det f >= 0.7^dim
      double           sum   = 0.;
      bool             near  = true;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          {
            double largest = 0.;
            for (unsigned int a = 0; a < u.n_nodes; ++a)
              {
                const double difference =
                  u.values[c][a | 1u << d] - u.values[c][a];
                near &= std::abs(u.values[c][a]) <= limit * reach[c];
                largest = std::max(largest, std::abs(difference));
              }
            sum += std::pow(largest / extent[d], 2);
          }
      return near && sum <= small * small;
    }
  } // namespace



  std::string
  StepCheck::problem(const double limit, const bool holds_points) const
  {
    if (!finite)
      return "a point's new position or velocity is not finite";
    if (holds_points)
      return "";
    if (min_det_F < least_det_F)
      return fmt::format("a point's volume changes by the factor {:.3g}",
                         min_det_F);
    if (max_displacement > limit)
      return fmt::format("a point moves by {:.3g} cells", max_displacement);
    if (beyond_wall > wall_tolerance)
      return fmt::format("a point goes through a wall by {:.3g} cells",
                         beyond_wall);
    return "";
  }



  StepCheck
  StepCheck::of_all_ranks(const MPI_Comm communicator) const
  {
    const std::array<double, 4> own = {
      {-min_det_F, max_displacement, beyond_wall, finite ? 0. : 1.}};
    std::array<double, 4> worst = own;
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      dealii::Utilities::MPI::max(
        dealii::ArrayView<const double>(own.data(), own.size()),
        communicator,
        dealii::ArrayView<double>(worst.data(), worst.size()));
    StepCheck result;
    result.min_det_F        = -worst[0];
    result.max_displacement = worst[1];
    result.beyond_wall      = worst[2];
    result.finite           = worst[3] == 0.;
    return result;
  }



  template <int dim>
  StepCheck
  Transfer<dim>::check(const GridState<dim>  &state,
                       const PointCloud<dim> &points,
                       const double           limit) const
  {
    StepCheck result;
    occupancy.for_each_degree([&](const auto degree) {
      this->template check_cells<degree>(state, points, limit, result);
    });
    return result.of_all_ranks(points.communicator);
  }



  template <int dim>
  template <int degree>
  void
  Transfer<dim>::check_cells(const GridState<dim>  &state,
                             const PointCloud<dim> &points,
                             const double           limit,
                             StepCheck             &result) const
  {
    const PointArrays<dim, const PointCloud<dim>> arrays(points);
    const CellLocator<dim>                       &locator = points.locator;
    const double *displacement = state.displacement().begin();

    CellField<dim, degree> u;
    Block<dim, degree>     block;
    WallFaces<dim, degree> walls(occupancy);
    double                 min_det = result.min_det_F;
    double                 max_u   = result.max_displacement;
    double                 beyond  = result.beyond_wall;
    double                 sum     = 0.; // not finite if any value is not
    for_each_block(
      occupancy,
      points,
      [&](const unsigned int cell) {
        if (occupancy.degree(cell) != degree)
          return false;
        u.gather(displacement, occupancy, cell);
        if constexpr (degree == 1)
          if (is_gentle(u, locator.extent(cell), locator.reach(cell), limit))
            return false;
        walls.reinit(cell, u);
        return true;
      },
      [&](const unsigned int cell,
          const std::size_t  first,
          const unsigned int n_filled) {
        block.reinit(arrays,
                     first,
                     n_filled,
                     locator.lower_corner(cell),
                     locator.extent(cell));
        double F[dim][dim][n_lanes], cofactor[dim][dim][n_lanes];
        double det[n_lanes], moved[n_lanes];
        block.field_gradient(u, /*add_identity=*/true, F);
        determinant_and_cofactors<dim>(F, det, cofactor);
        for (unsigned int l = 0; l < n_lanes; ++l)
          {
            min_det = std::min(min_det, det[l]);
            sum += det[l];
          }
        // half-way too: a turn by 180 degrees keeps the determinant but takes
        // points in a corner of the domain through both walls
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int l = 0; l < n_lanes; ++l)
              F[c][d][l] = 0.5 * (F[c][d][l] + (c == d ? 1. : 0.));
        determinant_and_cofactors<dim>(F, det, cofactor);
        for (unsigned int l = 0; l < n_lanes; ++l)
          min_det = std::min(min_det, det[l]);
        // beside finer cells, their size is the limit: a point must not pass
        // the layer of neighbours
        const auto &reach = locator.reach(cell);
        for (unsigned int c = 0; c < dim; ++c)
          {
            block.value(u.values[c], moved);
            for (unsigned int l = 0; l < n_lanes; ++l)
              {
                max_u = std::max(max_u, std::abs(moved[l]) / reach[c]);
                sum += moved[l];
              }
            for (unsigned int l = 0; l < n_filled; ++l)
              beyond = std::max(
                beyond,
                walls.way_beyond(c, arrays.position[c][first + l] + moved[l]));
          }
      });

    result.min_det_F        = min_det;
    result.max_displacement = max_u;
    result.beyond_wall      = beyond;
    result.finite           = result.finite && std::isfinite(sum);
  }



  template StepCheck
  Transfer<2>::check(const GridState<2> &,
                     const PointCloud<2> &,
                     const double) const;
  template StepCheck
  Transfer<3>::check(const GridState<3> &,
                     const PointCloud<3> &,
                     const double) const;
} // namespace seiche
