// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/cell_locator.h>
#include <seiche/mesh/morton_key.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace seiche
{
  template <int dim>
  CellLocator<dim>::CellLocator(const BackgroundGrid<dim> &background_grid)
    : grid(background_grid)
  {
    for (unsigned int d = 0; d < dim; ++d)
      periodic[d] = grid.parameters.is_periodic(d);
    has_seam = grid.parameters.any_periodic();
    reinit();
  }



  template <int dim>
  void
  CellLocator<dim>::reinit()
  {
    const auto &triangulation = grid.triangulation;
    make_lines();

    geometries.clear();
    owners.clear();
    walls.clear();
    lattice_lower.clear();
    lattice_upper.clear();
    iterators.clear();
    by_active_index.assign(triangulation.n_active_cells(), invalid);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        add_cell(cell);
    n_owned_cells = n_cells();
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_ghost())
        add_cell(cell);

    by_key.resize(n_cells());
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      by_key[cell] = {morton_key<dim>(lattice_lower[cell]), cell};
    std::sort(by_key.begin(), by_key.end());
    find_face_neighbors();
    find_vertex_neighbors();
  }



  template <int dim>
  typename CellLocator<dim>::Lines
  CellLocator<dim>::make_line(const unsigned int direction,
                              const LinePlace   &place) const
  {
    Lines line;
    for (const auto &segment : grid.segments(direction))
      {
        const double       begin = place(direction, segment.begin);
        const double       end   = place(direction, segment.end);
        const unsigned int n     = segment.cells << obstacle_shift;
        const double       size  = (end - begin) / n;
        line.segments.push_back(
          {end, begin, 1. / size, segment.first << obstacle_shift});
        for (unsigned int i = 0; i < n; ++i)
          line.places.push_back(begin + i * size);
      }
    line.places.push_back(line.segments.back().end);
    return line;
  }



  template <int dim>
  void
  CellLocator<dim>::make_lines()
  {
    finest_level    = grid.finest_level();
    obstacle_shift  = finest_level - grid.lattice_level();
    const auto stay = [](const unsigned int, const double place) {
      return place;
    };
    for (unsigned int d = 0; d < dim; ++d)
      {
        reference[d] = make_line(d, stay);
        lines[d]     = line_place ? make_line(d, line_place) : reference[d];
      }
  }



  template <int dim>
  void
  CellLocator<dim>::move(const LinePlace &place)
  {
    line_place = place;
    make_lines();
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      set_geometry(cell);
    find_reaches();
  }



  template <int dim>
  dealii::BoundingBox<dim>
  CellLocator<dim>::domain() const
  {
    dealii::Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = lines[d].places.front();
        upper[d] = lines[d].places.back();
      }
    return dealii::BoundingBox<dim>({lower, upper});
  }



  template <int dim>
  dealii::Point<dim>
  CellLocator<dim>::moved(const dealii::Point<dim> &x) const
  {
    dealii::Point<dim> result = x;
    if (line_place)
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = line_place(d, x[d]);
    return result;
  }



  template <int dim>
  void
  CellLocator<dim>::set_geometry(const unsigned int cell)
  {
    dealii::Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = lines[d].places[lattice_lower[cell][d]];
        upper[d] = lines[d].places[lattice_upper[cell][d]];
      }
    geometries[cell] = {lower, upper};
  }



  template <int dim>
  void
  CellLocator<dim>::add_cell(
    const typename dealii::Triangulation<dim>::active_cell_iterator &cell)
  {
    const unsigned int size = 1u << (finest_level - cell->level());
    Lattice            begin, end;
    for (unsigned int d = 0; d < dim; ++d)
      {
        // a coarse cell's centre lies in its second half
        begin[d] = reference[d].index(cell->center()[d]) / size * size;
        end[d]   = begin[d] + size;
      }
    const unsigned int number                  = n_cells();
    by_active_index[cell->active_cell_index()] = number;
    geometries.emplace_back();
    lattice_lower.push_back(begin);
    lattice_upper.push_back(end);
    set_geometry(number);
    owners.push_back(cell->subdomain_id());
    iterators.push_back(cell);
    walls.emplace_back();
    for (const unsigned int face : cell->face_indices())
      walls.back()[face] = cell->at_boundary(face) && !at_seam(number, face) ?
                             &grid.wall(cell->face(face)->boundary_id()) :
                             nullptr;
  }



  template <int dim>
  std::uint64_t
  CellLocator<dim>::lattice_index(
    const unsigned int                   cell,
    const std::array<unsigned int, dim> &offset) const
  {
    std::uint64_t result = 0;
    for (unsigned int d = dim; d-- > 0;)
      result = result * (lines[d].places.size() - 1) + lattice_lower[cell][d] +
               offset[d];
    return result;
  }



  template <int dim>
  double
  CellLocator<dim>::n_lattice_cells() const
  {
    double result = 1.;
    for (const auto &line : lines)
      result *= line.places.size() - 1.;
    return result;
  }



  template <int dim>
  dealii::BoundingBox<dim>
  CellLocator<dim>::lattice_box(
    const unsigned int                   cell,
    const std::array<unsigned int, dim> &offset) const
  {
    dealii::Point<dim> low, high;
    for (unsigned int d = 0; d < dim; ++d)
      {
        low[d]  = lines[d].places[lattice_lower[cell][d] + offset[d]];
        high[d] = lines[d].places[lattice_lower[cell][d] + offset[d] + 1];
      }
    return dealii::BoundingBox<dim>({low, high});
  }



  template <int dim>
  const Wall<dim> *
  CellLocator<dim>::wall_beyond(const dealii::Point<dim> &x) const
  {
    const Wall<dim> *result  = nullptr;
    double           largest = 0.; // distance behind the wall [m]
    const auto       take    = [&](const double distance, const BoxFace side) {
      if (distance > largest)
        {
          largest = distance;
          result  = &grid.wall(side);
        }
    };
    for (unsigned int d = 0; d < dim; ++d)
      {
        take(lines[d].places.front() - x[d], {d, /*upper=*/false});
        take(x[d] - lines[d].places.back(), {d, /*upper=*/true});
      }
    return result != nullptr ? result : grid.parameters.obstacle_at(x);
  }



  template class CellLocator<2>;
  template class CellLocator<3>;
} // namespace seiche
