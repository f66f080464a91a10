// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_cloud.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/state_archive.h>

#include <deal.II/base/exceptions.h>

#include <fmt/format.h>

#include <cmath>

namespace seiche
{
  namespace
  {
    const std::set<PointColumn> always_present = {PointColumn::position,
                                                  PointColumn::velocity,
                                                  PointColumn::volume_ratio,
                                                  PointColumn::mass,
                                                  PointColumn::initial_volume,
                                                  PointColumn::pressure};
  }



  template <int dim>
  PointCloud<dim>::PointCloud(const CellLocator<dim>      &cell_locator,
                              const std::set<PointColumn> &columns,
                              const MPI_Comm               mpi_communicator)
    : locator(cell_locator)
    , communicator(mpi_communicator)
  {
    unsigned int n_arrays = 0;
    for (const PointColumnInfo &info : point_column_table)
      {
        unsigned int &first =
          first_array[static_cast<unsigned int>(info.column)];
        first = invalid;
        if (always_present.count(info.column) + columns.count(info.column) > 0)
          {
            first = n_arrays;
            n_arrays += n_components(info.column, dim);
          }
      }
    arrays.resize(n_arrays);
    build_cell_index();
  }



  template <int dim>
  bool
  PointCloud<dim>::has(const PointColumn column) const
  {
    return first_array[static_cast<unsigned int>(column)] != invalid;
  }



  template <int dim>
  double *
  PointCloud<dim>::data(const PointColumn column, const unsigned int component)
  {
    Assert(has(column), dealii::ExcMessage("The points lack this column."));
    AssertIndexRange(component, n_components(column, dim));
    return arrays[first_array[static_cast<unsigned int>(column)] + component]
      .data();
  }



  template <int dim>
  const double *
  PointCloud<dim>::data(const PointColumn  column,
                        const unsigned int component) const
  {
    Assert(has(column), dealii::ExcMessage("The points lack this column."));
    AssertIndexRange(component, n_components(column, dim));
    return arrays[first_array[static_cast<unsigned int>(column)] + component]
      .data();
  }



  template <int dim>
  dealii::Point<dim>
  PointCloud<dim>::position(const std::size_t point) const
  {
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = data(PointColumn::position, d)[point];
    return result;
  }



  template <int dim>
  void
  PointCloud<dim>::insert(const std::uint64_t           id,
                          const dealii::Point<dim>     &position,
                          const dealii::Tensor<1, dim> &velocity,
                          const double                  mass,
                          const double                  initial_volume)
  {
    const std::size_t point = size();
    for (auto &array : arrays)
      array.push_back(0.);
    point_ids.push_back(id);
    point_cells.push_back(invalid);
    for (unsigned int d = 0; d < dim; ++d)
      {
        data(PointColumn::position, d)[point] = position[d];
        data(PointColumn::velocity, d)[point] = velocity[d];
      }
    data(PointColumn::mass)[point]           = mass;
    data(PointColumn::initial_volume)[point] = initial_volume;
    data(PointColumn::volume_ratio)[point]   = 1.;
  }



  template <int dim>
  void
  PointCloud<dim>::remove(const std::vector<std::size_t> &dropped)
  {
    if (dropped.empty())
      return;
    for (const std::size_t point : dropped)
      point_cells[point] = invalid;
    sort();
  }



  template <int dim>
  void
  PointCloud<dim>::locate()
  {
    wrap();
    std::vector<std::size_t> emigrants;
    const Census             census = find_cells(emigrants);
    // every rank takes part in the exchange, also when a point is lost here
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      migrate(emigrants);
    // sorting drops what has no cell; a lost point stays for the last frame
    if (census.n_lost == 0 &&
        (census.moved || size() > census.n_before || cell_begin.empty()))
      sort();
    account(census);
  }



  template <int dim>
  void
  PointCloud<dim>::wrap()
  {
    if (!locator.grid.parameters.any_periodic())
      return;
    for (std::size_t p = 0; p < size(); ++p)
      {
        const dealii::Point<dim> here   = position(p);
        const dealii::Point<dim> inside = locator.wrapped(here);
        for (unsigned int d = 0; d < dim; ++d)
          if (inside[d] != here[d])
            data(PointColumn::position, d)[p] = inside[d];
      }
  }



  template <int dim>
  void
  PointCloud<dim>::relocate()
  {
    std::fill(point_cells.begin(), point_cells.end(), invalid);
    cell_begin.clear(); // of other cells; also where there is no point
    locate();
  }



  template <int dim>
  typename PointCloud<dim>::Census
  PointCloud<dim>::find_cells(std::vector<std::size_t> &emigrants)
  {
    Census census;
    census.n_before = size();
    std::array<double *, dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = data(PointColumn::position, d);

    for (std::size_t p = 0; p < census.n_before; ++p)
      {
        dealii::Point<dim> here;
        for (unsigned int d = 0; d < dim; ++d)
          here[d] = x[d][p];
        if (point_cells[p] != invalid &&
            locator.geometry(point_cells[p]).holds(here))
          continue;

        // a position that is not a number has no cell and is not put back
        const bool   is_place = std::isfinite(here.norm_square());
        unsigned int cell =
          is_place ? locator.find(here, point_cells[p]) : invalid;
        if (cell == invalid)
          {
            cell = is_place ? put_back(p) : invalid;
            if (cell == invalid)
              judge_outside(p, census);
            else
              ++census.n_put_back;
          }
        if (cell != invalid && !locator.geometry(cell).holds(position(p)))
          // on a wall up to round-off: put it there, so that no shape
          // function becomes negative
          {
            const auto inside = locator.geometry(cell).clamped(position(p));
            for (unsigned int d = 0; d < dim; ++d)
              x[d][p] = inside[d];
          }
        census.moved   = census.moved || cell != point_cells[p];
        point_cells[p] = cell;
        if (cell != invalid && cell >= locator.n_owned())
          emigrants.push_back(p);
      }
    return census;
  }



  template <int dim>
  unsigned int
  PointCloud<dim>::put_back(const std::size_t point)
  {
    const dealii::Point<dim> here = position(point);
    const Wall<dim>         *wall = locator.wall_beyond(here);
    if (point_cells[point] == invalid || wall == nullptr || wall->is_side() ||
        wall->condition == WallCondition::no_slip)
      return invalid;
    const dealii::Tensor<1, dim> extent =
      locator.geometry(point_cells[point]).edges;
    double       nearest = std::numeric_limits<double>::max();
    unsigned int result = invalid, direction = 0;
    double       place = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      for (const double face : {wall->lower_corner[d], wall->upper_corner[d]})
        {
          const double depth = std::abs(here[d] - face);
          if (depth > 0.5 * extent[d] || depth >= nearest)
            continue;
          dealii::Point<dim> on_face = here;
          on_face[d]                 = face;
          const unsigned int cell = locator.find(on_face, point_cells[point]);
          if (cell == invalid)
            continue;
          nearest   = depth;
          result    = cell;
          direction = d;
          place     = face;
        }
    if (result != invalid)
      data(PointColumn::position, direction)[point] = place;
    return result;
  }



  template <int dim>
  void
  PointCloud<dim>::judge_outside(const std::size_t point, Census &census) const
  {
    const Wall<dim>  *wall   = locator.wall_beyond(position(point));
    const std::string reason = wall == nullptr ?
                                 "it is not in a cell next to its last one" :
                                 "it is beyond the wall \"" + wall->name + "\"";
    bool              finite = true;
    for (unsigned int d = 0; d < dim; ++d)
      finite = finite && std::isfinite(position(point)[d]);
    if (finite && wall != nullptr && wall->condition == WallCondition::open)
      {
        ++census.n_outflow;
        census.outflow_mass += data(PointColumn::mass)[point];
        return;
      }
    if (census.n_lost++ == 0)
      census.lost_report =
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
                        locator.geometry(point_cells[point]).lower[d]);
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
  PointCloud<dim>::account(const Census &census)
  {
    // exact in double up to 2^53 points
    std::array<double, 6> sums   = {{double(census.n_before),
                                     double(size()),
                                     double(census.n_outflow),
                                     double(census.n_lost),
                                     census.outflow_mass,
                                     double(census.n_put_back)}};
    std::string           report = census.lost_report;
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
    outflow += static_cast<std::uint64_t>(sums[2]);
    mass_of_outflow += sums[4];
    put_back_total += static_cast<std::uint64_t>(sums[5]);
  }



  template <int dim>
  void
  PointCloud<dim>::save_or_load(StateArchive &archive)
  {
    archive("outflow points", outflow);
    archive("outflow mass", mass_of_outflow);
    archive("points put back", put_back_total);
  }



  template class PointCloud<2>;
  template class PointCloud<3>;
} // namespace seiche
