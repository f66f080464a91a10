// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/cell_locator.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <optional>

// The part of CellLocator that knows which cells touch.
namespace seiche
{
  template <int dim>
  void
  CellLocator<dim>::find_face_neighbors()
  {
    face_neighbors.resize(n_cells());
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int face = 0; face < 2 * dim; ++face)
        {
          face_neighbors[cell][face] = invalid;
          if (at_boundary(cell, face))
            continue;
          if (at_seam(cell, face))
            {
              face_neighbors[cell][face] = across_seam(cell, face);
              continue;
            }
          const auto other = iterators[cell]->neighbor(face);
          if (other->is_active() && !other->is_artificial())
            face_neighbors[cell][face] = index(other);
        }
  }



  template <int dim>
  void
  CellLocator<dim>::find_vertex_neighbors()
  {
    constexpr unsigned int n_vertices =
      dealii::GeometryInfo<dim>::vertices_per_cell;
    const std::vector<unsigned int> joined = joined_vertices();
    const auto vertex_of = [&](const unsigned int cell, const unsigned int v) {
      return joined[iterators[cell]->vertex_index(v)];
    };
    std::vector<unsigned int> begin(grid.triangulation.n_vertices() + 1, 0);
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int v = 0; v < n_vertices; ++v)
        ++begin[vertex_of(cell, v) + 1];
    for (unsigned int v = 1; v < begin.size(); ++v)
      begin[v] += begin[v - 1];
    std::vector<unsigned int> next(begin.begin(), begin.end() - 1);
    std::vector<unsigned int> cells_at(begin.back());
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (unsigned int v = 0; v < n_vertices; ++v)
        cells_at[next[vertex_of(cell, v)]++] = cell;

    vertex_neighbor_begin.assign(1, 0);
    vertex_neighbor_list.clear();
    for (unsigned int cell = 0; cell < n_owned(); ++cell)
      {
        for (unsigned int v = 0; v < n_vertices; ++v)
          {
            const unsigned int vertex = vertex_of(cell, v);
            for (unsigned int i = begin[vertex]; i < begin[vertex + 1]; ++i)
              if (cells_at[i] != cell)
                vertex_neighbor_list.push_back(cells_at[i]);
          }
        const auto first =
          vertex_neighbor_list.begin() + vertex_neighbor_begin.back();
        std::sort(first, vertex_neighbor_list.end());
        vertex_neighbor_list.erase(std::unique(first,
                                               vertex_neighbor_list.end()),
                                   vertex_neighbor_list.end());
        vertex_neighbor_begin.push_back(vertex_neighbor_list.size());
      }
    find_reaches();
  }



  template <int dim>
  void
  CellLocator<dim>::find_reaches()
  {
    reaches.resize(n_owned());
    for (unsigned int cell = 0; cell < n_owned(); ++cell)
      {
        reaches[cell] = geometries[cell].edges;
        for (const unsigned int other : vertex_neighbors(cell))
          for (unsigned int d = 0; d < dim; ++d)
            reaches[cell][d] =
              std::min(reaches[cell][d], geometries[other].edges[d]);
      }
  }



  template <int dim>
  template <typename Number>
  void
  CellLocator<dim>::exchange_to_ghosts(std::vector<Number> &cell_values) const
  {
    AssertDimension(cell_values.size(), n_cells());
    if (dealii::Utilities::MPI::n_mpi_processes(
          grid.triangulation.get_communicator()) == 1)
      return;
    using Iterator = typename dealii::parallel::distributed::Triangulation<
      dim>::active_cell_iterator;
    dealii::GridTools::exchange_cell_data_to_ghosts<Number>(
      grid.triangulation,
      [&](const Iterator &cell) -> std::optional<Number> {
        return cell_values[index(cell)];
      },
      [&](const Iterator &cell, const Number value) {
        cell_values[index(cell)] = value;
      });
  }



  template void
  CellLocator<2>::find_face_neighbors();
  template void
  CellLocator<3>::find_face_neighbors();
  template void
  CellLocator<2>::find_vertex_neighbors();
  template void
  CellLocator<3>::find_vertex_neighbors();
  template void
  CellLocator<2>::exchange_to_ghosts(std::vector<double> &) const;
  template void
  CellLocator<3>::exchange_to_ghosts(std::vector<double> &) const;
  template void
  CellLocator<2>::exchange_to_ghosts(std::vector<char> &) const;
  template void
  CellLocator<3>::exchange_to_ghosts(std::vector<char> &) const;
} // namespace seiche
