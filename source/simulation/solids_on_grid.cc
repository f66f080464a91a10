// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/solids_on_grid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Of a solid's volume that the grid may miss.
    constexpr double most_missed = 0.3;

    /// True if all of the shape lies in the domain.
    template <int dim>
    bool
    lies_inside(const Shape<dim> &shape, const BoundingBox<dim> &domain)
    {
      const auto [lower, upper] = shape.bounding_box().get_boundary_points();
      return !shape.is_endless() && domain.point_inside(lower) &&
             domain.point_inside(upper);
    }
  } // namespace

  template <int dim>
  void
  require_solids_on_grid(const Occupancy<dim> &occupancy,
                         const InputFile      &input)
  {
    const auto &locator = occupancy.locator;
    const auto &walls   = occupancy.mesh_nodes.cut_walls;
    const auto &solids  = locator.solids;
    if (solids.empty())
      return;
    const unsigned int  n = solids.size();
    std::vector<double> sums(2 * n, 0.); // area of the wall, volume
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        const CellGeometry<dim> &geometry = locator.cells.geometry(cell);
        if (walls.cuts(cell))
          for (const WallPoint<dim> &point : walls.whole(cell).wall)
            sums[point.solid] += point.area.norm();
        if (const double share = 1. - walls.wet_share(cell); share > 0.)
          sums[n + (nearest_solid(solids, geometry.box().center()) -
                    solids.data())] += share * geometry.measure;
      }
    const MPI_Comm communicator = locator.grid.triangulation.get_communicator();
    Utilities::MPI::sum(sums, communicator, sums);
    const double size =
      Utilities::MPI::min(occupancy.smallest_extent(), communicator);
    for (unsigned int s = 0; s < n; ++s)
      {
        const std::string path = "Solid " + solids[s].name + "/Shape";
        input.require(sums[s] > 0.,
                      path,
                      fmt::format("its wall cuts no cell: it lies outside of "
                                  "the domain, fills all of it, or is thinner "
                                  "than the smallest cells, {:.3g} m.",
                                  size));
        const Shape<dim> &shape = *solids[s].shape;
        const double      own   = shape.volume();
        if (!std::isfinite(own) ||
            !lies_inside(shape, locator.grid.parameters.domain()))
          continue;
        input.require(
          std::abs(sums[n + s] / own - 1.) < most_missed,
          path,
          fmt::format("on the grid its volume is {:.3g} of {:.3g} m^{}: it is "
                      "too thin for cells of {:.3g} m, which must be half as "
                      "large as it is thick, or it lies in another solid. Make "
                      "Grid/Cell size smaller, or refine around it.",
                      sums[n + s],
                      own,
                      dim,
                      size));
      }
  }

  template void
  require_solids_on_grid(const Occupancy<2> &, const InputFile &);
  template void
  require_solids_on_grid(const Occupancy<3> &, const InputFile &);
} // namespace seiche
