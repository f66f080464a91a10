// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/background_grid.h>
#include <seiche/scene/wall_slack.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/table.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  namespace
  {
    /// How often two divides all counts.
    template <int dim>
    unsigned int
    common_power_of_two(
      const std::array<std::vector<GridSegment>, dim> &lattice)
    {
      unsigned int all = 0;
      for (const auto &segments : lattice)
        for (const GridSegment &segment : segments)
          all |= segment.cells;
      unsigned int power = 0;
      while ((all & 1u) == 0)
        {
          all >>= 1;
          ++power;
        }
      return power;
    }



    /// Index of the cell above the line at @p place.
    unsigned int
    index_of_line(const std::vector<GridSegment> &segments, const double place)
    {
      for (const GridSegment &segment : segments)
        {
          const double size = (segment.end - segment.begin) / segment.cells;
          if (place < segment.end - 0.5 * size)
            {
              const double offset = (place - segment.begin) / size;
              return segment.first + static_cast<unsigned int>(
                                       std::lround(std::max(offset, 0.)));
            }
        }
      return segments.back().first + segments.back().cells;
    }
  } // namespace



  template <int dim>
  BackgroundGrid<dim>::BackgroundGrid(
    const GridParameters<dim> &grid_parameters,
    MPI_Comm                   communicator)
    : parameters(grid_parameters)
    , triangulation(communicator,
                    dealii::Triangulation<dim>::none,
                    dealii::parallel::distributed::Triangulation<
                      dim>::no_automatic_repartitioning)
  {
    for (unsigned int d = 0; d < dim; ++d)
      lattice[d] = make_segments(parameters, d);
    n_refinements = common_power_of_two<dim>(lattice);
    // nor may refinement leave fewer: the coarsest cells are the forest's
    for (unsigned int d = 0; d < dim; ++d)
      while (parameters.is_periodic(d) && n_refinements > 0 &&
             (n_lattice_cells(d) >> n_refinements) <
               parameters.fewest_periodic_cells)
        --n_refinements;
    for (const auto &obstacle : parameters.obstacles())
      {
        LatticeBox box;
        for (unsigned int d = 0; d < dim; ++d)
          {
            box.first[d]  = index_of_line(lattice[d], obstacle.lower_corner[d]);
            box.second[d] = index_of_line(lattice[d], obstacle.upper_corner[d]);
          }
        obstacle_boxes.push_back(box);
      }
    make_coarse_cells();
    set_boundary_ids();
    join_periodic_sides();
    triangulation.repartition(); // automatic partitioning is off
    for (unsigned int i = 0; i < n_refinements; ++i)
      {
        // shared out at once: p4est begins with one cell a tree, on one rank
        triangulation.refine_global(1);
        triangulation.repartition();
      }
  }



  template <int dim>
  void
  BackgroundGrid<dim>::repartition(
    const std::function<unsigned int(
      const typename dealii::Triangulation<dim>::cell_iterator &)> &weight)
  {
    const auto connection = triangulation.signals.weight.connect(
      [&](const auto &cell, const auto) { return weight(cell); });
    triangulation.repartition();
    connection.disconnect();
  }



  template <int dim>
  void
  BackgroundGrid<dim>::make_coarse_cells()
  {
    std::vector<std::vector<double>> spacings(dim);
    dealii::TableIndices<dim>        sizes;
    for (unsigned int d = 0; d < dim; ++d)
      {
        for (const Segment &segment : lattice[d])
          {
            const unsigned int n = segment.cells >> n_refinements;
            spacings[d].insert(spacings[d].end(),
                               n,
                               (segment.end - segment.begin) / n);
          }
        sizes[d] = spacings[d].size();
      }

    dealii::Table<dim, dealii::types::material_id> material_ids;
    material_ids.reinit(sizes);
    material_ids.fill(dealii::types::material_id(0));
    for (const LatticeBox &box : obstacle_boxes)
      {
        std::array<unsigned int, 3> begin = {{0, 0, 0}}, end = {{1, 1, 1}};
        for (unsigned int d = 0; d < dim; ++d)
          {
            begin[d] = box.first[d] >> n_refinements;
            end[d]   = box.second[d] >> n_refinements;
          }
        dealii::TableIndices<dim> index;
        for (unsigned int k = begin[2]; k < end[2]; ++k)
          for (unsigned int j = begin[1]; j < end[1]; ++j)
            for (unsigned int i = begin[0]; i < end[0]; ++i)
              {
                const std::array<unsigned int, 3> ijk = {{i, j, k}};
                for (unsigned int d = 0; d < dim; ++d)
                  index[d] = ijk[d];
                material_ids(index) = dealii::numbers::invalid_material_id;
              }
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(triangulation,
                                                      spacings,
                                                      parameters.lower_corner,
                                                      material_ids);
  }



  template <int dim>
  void
  BackgroundGrid<dim>::set_boundary_ids()
  {
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const BoxFace face : cell->face_indices())
        {
          if (!cell->at_boundary(face))
            continue;
          const unsigned int       direction = face.direction();
          const dealii::Point<dim> centre    = cell->face(face)->center();
          const double             slack =
            wall_slack(parameters.domain().side_length(direction));
          const double side = face.is_upper() ?
                                parameters.upper_corner[direction] :
                                parameters.lower_corner[direction];
          unsigned int id   = face;
          if (std::abs(centre[direction] - side) > slack)
            {
              // across the face there must be an obstacle, whose own may lie
              // farther by the slack
              dealii::Point<dim> beyond = centre;
              beyond[direction] += 2. * face.outward() * slack;
              id = parameters.obstacle_at(beyond)->number;
            }
          cell->face(face)->set_all_boundary_ids(id);
        }
  }



  template <int dim>
  void
  BackgroundGrid<dim>::join_periodic_sides()
  {
    std::vector<dealii::GridTools::PeriodicFacePair<
      typename dealii::Triangulation<dim>::cell_iterator>>
      pairs;
    for (unsigned int d = 0; d < dim; ++d)
      if (parameters.is_periodic(d))
        dealii::GridTools::collect_periodic_faces(
          triangulation, 2 * d, 2 * d + 1, d, pairs);
    if (!pairs.empty())
      triangulation.add_periodicity(pairs);
  }



  template <int dim>
  const std::vector<GridSegment> &
  BackgroundGrid<dim>::segments(const unsigned int direction) const
  {
    return lattice[direction];
  }



  template <int dim>
  unsigned int
  BackgroundGrid<dim>::n_lattice_cells(const unsigned int direction) const
  {
    return lattice[direction].back().first + lattice[direction].back().cells;
  }



  template <int dim>
  unsigned int
  BackgroundGrid<dim>::lattice_level() const
  {
    return n_refinements;
  }



  template <int dim>
  unsigned int
  BackgroundGrid<dim>::finest_level() const
  {
    return n_refinements + parameters.refinement.finest_level();
  }



  template <int dim>
  const typename BackgroundGrid<dim>::LatticeBox &
  BackgroundGrid<dim>::obstacle_box(const unsigned int index) const
  {
    return obstacle_boxes[index];
  }



  template <int dim>
  const Wall<dim> &
  BackgroundGrid<dim>::wall(const unsigned int number) const
  {
    AssertIndexRange(number, parameters.walls.size());
    return parameters.walls[number];
  }



  template class BackgroundGrid<2>;
  template class BackgroundGrid<3>;
} // namespace seiche
