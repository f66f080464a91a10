// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_cloud.h>

#include <deal.II/base/exceptions.h>

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
    const Found              found = find_cells(emigrants);
    // every rank takes part in the exchange, also when a point is lost here
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) > 1)
      migrate(emigrants);
    // sorting drops what has no cell; a lost point stays for the last frame
    if (found.n_lost == 0 &&
        (found.moved || size() > found.n_before || cell_begin.empty()))
      sort();
    account(found);
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
        const dealii::Point<dim> inside = locator.periods.wrapped(here);
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
  typename PointCloud<dim>::Found
  PointCloud<dim>::find_cells(std::vector<std::size_t> &emigrants)
  {
    Found found;
    found.n_before = size();
    std::array<double *, dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = data(PointColumn::position, d);

    for (std::size_t p = 0; p < found.n_before; ++p)
      {
        if (put_out_of_solids(p))
          ++found.n_set_on_walls;
        dealii::Point<dim> here;
        for (unsigned int d = 0; d < dim; ++d)
          here[d] = x[d][p];
        if (point_cells[p] != invalid &&
            locator.cells.geometry(point_cells[p]).holds(here))
          continue;

        // a position that is not a number has no cell and stays where it is
        const bool   is_place = std::isfinite(here.norm_square());
        unsigned int cell =
          is_place ? locator.find(here, point_cells[p]) : invalid;
        if (cell == invalid)
          {
            cell = is_place ? set_on_wall(p) : invalid;
            if (cell == invalid)
              count_outside(p, found);
            else
              ++found.n_set_on_walls;
          }
        if (cell != invalid && !locator.cells.geometry(cell).holds(position(p)))
          // on a wall up to round-off: put it there, so that no shape
          // function becomes negative
          {
            const auto inside =
              locator.cells.geometry(cell).clamped(position(p));
            for (unsigned int d = 0; d < dim; ++d)
              x[d][p] = inside[d];
          }
        found.moved    = found.moved || cell != point_cells[p];
        point_cells[p] = cell;
        if (cell != invalid && cell >= locator.cells.n_owned())
          emigrants.push_back(p);
      }
    return found;
  }



  template class PointCloud<2>;
  template class PointCloud<3>;
} // namespace seiche
