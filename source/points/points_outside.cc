// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/solid_distance.h>
#include <seiche/points/point_cloud.h>
#include <seiche/utilities/exceptions.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

// The part of PointCloud that deals with points where no fluid can be: set on a
// wall, put out of a solid, outflow, or lost.
namespace seiche
{
  template <int dim>
  unsigned int
  PointCloud<dim>::set_on_wall(const std::size_t point)
  {
    const unsigned int       last = point_cells[point];
    const dealii::Point<dim> here = position(point);
    const Wall<dim>         *wall = locator.wall_beyond(here);
    if (last == invalid || wall == nullptr ||
        wall->condition == WallCondition::no_slip ||
        (wall->is_side() && wall->condition != WallCondition::unilateral))
      return invalid;
    double             nearest = std::numeric_limits<double>::max();
    unsigned int       result  = invalid;
    dealii::Point<dim> place;
    const auto         look_at = [&](const unsigned int cell) {
      const dealii::Point<dim> image = locator.image(here, cell);
      const dealii::Point<dim> inside =
        locator.cells.geometry(cell).clamped(image);
      if (inside.distance(image) < nearest)
        {
          nearest = inside.distance(image);
          result  = cell;
          place   = inside;
        }
    };
    look_at(last);
    for (const unsigned int cell : locator.cells.vertex_neighbors(last))
      look_at(cell);
    if (result != invalid)
      for (unsigned int d = 0; d < dim; ++d)
        data(PointColumn::position, d)[point] = place[d];
    return result;
  }



  template <int dim>
  bool
  PointCloud<dim>::put_out_of_solids(const std::size_t point)
  {
    constexpr double   beside = 1e-6; // of the smallest edge: no cell is dry
    constexpr unsigned rounds = 4;    // curved walls, corners
    const auto        &solids = locator.solids;
    const unsigned int last   = point_cells[point];
    if (solids.empty() ||
        (last != invalid && !locator.cells.is_near_solid(last)))
      return false;
    bool moved = false;
    for (unsigned int round = 0; round < rounds; ++round)
      {
        const dealii::Point<dim> here = position(point);
        const unsigned int       cell = std::isfinite(here.norm_square()) ?
                                          locator.find(here, last) :
                                          invalid;
        if (cell == invalid || !locator.cells.is_near_solid(cell))
          break;
        const CellGeometry<dim> &geometry = locator.cells.geometry(cell);
        if (distance_from(solids, here) > geometry.edges.norm())
          break;
        const SolidDistance<dim> wall(solids, geometry);
        const double             distance = wall.value(here);
        if (!(distance < 0.))
          break;
        dealii::Tensor<1, dim> normal    = wall.gradient(here);
        const double           steepness = normal.norm();
        if (!(steepness > 0.))
          break;
        normal /= steepness;
        const double way =
          -distance / steepness +
          (last == invalid ? 0. : beside * geometry.shortest_edge());
        double approach =
          -(normal * nearest_solid(solids, here)->velocity().at(here));
        for (unsigned int d = 0; d < dim; ++d)
          approach += normal[d] * data(PointColumn::velocity, d)[point];
        for (unsigned int c = 0; c < dim; ++c)
          {
            data(PointColumn::position, c)[point] += way * normal[c];
            data(PointColumn::velocity, c)[point] -=
              std::min(0., approach) * normal[c];
          }
        // where a solid overhangs a side, its normal leads out of the domain
        if (locator.find(position(point), cell) == invalid)
          {
            const dealii::Point<dim> inside = geometry.clamped(position(point));
            for (unsigned int d = 0; d < dim; ++d)
              data(PointColumn::position, d)[point] = inside[d];
          }
        moved = true;
      }
    return moved;
  }



  template <int dim>
  void
  PointCloud<dim>::count_outside(const std::size_t point, Found &found) const
  {
    const Wall<dim>  *wall = locator.wall_beyond(position(point));
    const std::string reason =
      wall == nullptr ?
        "it is not in a cell next to its last one" :
        fmt::format("it is {:.2g} m beyond the wall "
                    "\"{}\"",
                    -wall->distance(position(point), locator.lines.time()),
                    wall->name);
    bool finite = true;
    for (unsigned int d = 0; d < dim; ++d)
      finite = finite && std::isfinite(position(point)[d]);
    if (finite && wall != nullptr && wall->condition == WallCondition::open)
      {
        ++found.n_outflow;
        found.outflow_mass += data(PointColumn::mass)[point];
        return;
      }
    if (found.n_lost++ == 0)
      found.lost_report =
        lost_report(point, finite ? reason : "its position is not finite");
  }



  template <int dim>
  std::string
  PointCloud<dim>::lost_report(const std::size_t  point,
                               const std::string &reason) const
  {
    std::string place, velocity, last_cell;
    double      speed = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double v = data(PointColumn::velocity, d)[point];
        place +=
          fmt::format("{}{:.6g}", d == 0 ? "" : ", ", position(point)[d]);
        speed += v * v;
        if (point_cells[point] != invalid)
          last_cell +=
            fmt::format("{}{:.6g}",
                        d == 0 ? "; its last cell starts at (" : ", ",
                        locator.cells.geometry(point_cells[point]).lower[d]);
      }
    if (!last_cell.empty())
      last_cell += ")";
    return fmt::format("Material point {} at ({}) m, speed {:.6g} m/s, is "
                       "lost: {}{}.",
                       point_ids[point],
                       place,
                       std::sqrt(speed),
                       reason,
                       last_cell);
  }



  template <int dim>
  void
  PointCloud<dim>::account(const Found &found)
  {
    // exact in double up to 2^53 points
    std::array<double, 6> sums   = {{double(found.n_before),
                                     double(size()),
                                     double(found.n_outflow),
                                     double(found.n_lost),
                                     found.outflow_mass,
                                     double(found.n_set_on_walls)}};
    std::string           report = found.lost_report;
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      {
        const std::array<double, 6> own = sums;
        dealii::Utilities::MPI::sum(
          dealii::ArrayView<const double>(own.data(), own.size()),
          communicator,
          dealii::ArrayView<double>(sums.data(), sums.size()));
        if (sums[3] > 0.)
          for (const std::string &text :
               dealii::Utilities::MPI::all_gather(communicator, report))
            if (report.empty())
              report = text; // all ranks end with the same kind of error
      }
    if (sums[3] > 0.)
      throw NumericalError(
        fmt::format("{} ({:.0f} such point(s) in all)", report, sums[3]));
    if (sums[0] != sums[1] + sums[2])
      throw NumericalError(
        fmt::format("{:.0f} material points vanished on the way between "
                    "ranks. Choose a smaller \"Time/Step\".",
                    sums[0] - sums[1] - sums[2]));
    global_size = static_cast<std::uint64_t>(sums[1]);
    outflow.points += static_cast<std::uint64_t>(sums[2]);
    outflow.mass += sums[4];
    outflow.set_on_walls += static_cast<std::uint64_t>(sums[5]);
  }



  template unsigned int
  PointCloud<2>::set_on_wall(const std::size_t);
  template unsigned int
  PointCloud<3>::set_on_wall(const std::size_t);
  template bool
  PointCloud<2>::put_out_of_solids(const std::size_t);
  template bool
  PointCloud<3>::put_out_of_solids(const std::size_t);
  template void
  PointCloud<2>::count_outside(const std::size_t, Found &) const;
  template void
  PointCloud<3>::count_outside(const std::size_t, Found &) const;
  template void
  PointCloud<2>::account(const Found &);
  template void
  PointCloud<3>::account(const Found &);
} // namespace seiche
