// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_range.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/held_points.h>
#include <seiche/transfer/point_arrays.h>
#include <seiche/transfer/transfer.h>
#include <seiche/transfer/wall_faces.h>
#include <seiche/utilities/over_ranks.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>

#include <cmath>

// The trial of a step: what it would do to the points.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// True if no point of a cell with these displacements can move farther
    /// than @p limit times reach or change its volume by more than a third:
    /// gradients and values of FE_Q(1) lie between those of edges and nodes.
    template <int dim>
    bool
    is_small(const double (&u)[dim][Basis<dim, 1>::n_nodes],
             const dealii::Tensor<1, dim> &edges,
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
            for (unsigned int a = 0; a < (Basis<dim, 1>::n_nodes); ++a)
              {
                const double difference = u[c][a | 1u << d] - u[c][a];
                near &= std::abs(u[c][a]) <= limit * reach[c];
                largest = std::max(largest, std::abs(difference));
              }
            sum += std::pow(largest / edges[d], 2);
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
    std::array<double, 4> worst = {
      {-min_det_F, max_displacement, beyond_wall, finite ? 0. : 1.}};
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      maximum_over_ranks(worst, communicator);
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
    PointBatch<dim, degree>                       batch;
    WallFaces<dim, degree>                        walls(occupancy);
    double                                        u_nodal[dim][batch.n_nodes];
    double                                        min_det = result.min_det_F;
    double max_u  = result.max_displacement;
    double beyond = result.beyond_wall;
    double sum    = 0.; // not finite if any value is not
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        if (occupancy.degree(cell) != degree)
          continue;
        const CellGeometry<dim> &geometry = locator.cells.geometry(cell);
        // beside finer cells, their size is the limit: a point must not pass
        // the layer of neighbours
        const auto &reach = locator.cells.reach(cell);
        occupancy.template unknowns<degree>(cell).read(
          state.displacement().begin(), u_nodal);
        if constexpr (degree == 1)
          if (is_small(u_nodal, geometry.edges, reach, limit))
            continue;
        walls.reinit(cell, u_nodal);
        for_each_range(points, cell, [&](const PointRange &range) {
          const Point<dim, Lanes> x = range.position(arrays.position);
          batch.reinit(geometry, geometry.to_unit(x));
          const Tensor<1, dim, Lanes> u   = batch.value(u_nodal);
          const Tensor<2, dim, Lanes> H   = batch.gradient(u_nodal);
          const Lanes                 det = determinant(identity_plus(H));
          // half-way too: a turn by 180 degrees keeps the determinant but
          // takes points in a corner of the domain through both walls
          const Lanes half = determinant(identity_plus<dim, Lanes>(0.5 * H));
          for (unsigned int l = 0; l < range.size; ++l)
            {
              min_det = std::min({min_det, det[l], half[l]});
              sum += det[l];
              for (unsigned int c = 0; c < dim; ++c)
                {
                  sum += u[c][l];
                  max_u = std::max(max_u, std::abs(u[c][l]) / reach[c]);
                  beyond =
                    std::max(beyond, walls.way_beyond(c, x[c][l] + u[c][l]));
                }
            }
        });
      }

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
