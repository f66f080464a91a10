// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/cells.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <map>

// The part of Cells that knows which cells touch.
namespace seiche
{
  template <int dim>
  void
  Cells<dim>::find_face_neighbors(const CellLattice<dim> &lattice)
  {
    face_neighbors.resize(size());
    for (unsigned int cell = 0; cell < size(); ++cell)
      for (unsigned int face = 0; face < 2 * dim; ++face)
        {
          face_neighbors[cell][face] = invalid;
          if (wall_at(cell, face) != nullptr)
            continue;
          if (lattice.at_seam(cell, face))
            {
              const unsigned int other = lattice.across_seam(cell, face);
              if (other != invalid && level(other) <= level(cell))
                face_neighbors[cell][face] = other;
              continue;
            }
          const auto other = iterators[cell]->neighbor(face);
          if (other->is_active() && !other->is_artificial())
            face_neighbors[cell][face] = index(other);
        }
  }



  template <int dim>
  void
  Cells<dim>::find_vertex_neighbors(const CellLattice<dim> &lattice)
  {
    constexpr unsigned int n_vertices =
      dealii::GeometryInfo<dim>::vertices_per_cell;
    const std::vector<unsigned int> joined = joined_vertices(lattice);
    const auto vertex_of = [&](const unsigned int cell, const unsigned int v) {
      return joined[iterators[cell]->vertex_index(v)];
    };
    std::vector<unsigned int> begin(grid.triangulation.n_vertices() + 1, 0);
    for (unsigned int cell = 0; cell < size(); ++cell)
      for (unsigned int v = 0; v < n_vertices; ++v)
        ++begin[vertex_of(cell, v) + 1];
    for (unsigned int v = 1; v < begin.size(); ++v)
      begin[v] += begin[v - 1];
    std::vector<unsigned int> next(begin.begin(), begin.end() - 1);
    std::vector<unsigned int> cells_at(begin.back());
    for (unsigned int cell = 0; cell < size(); ++cell)
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
  }



  template <int dim>
  void
  Cells<dim>::find_reaches()
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
  std::vector<unsigned int>
  Cells<dim>::joined_vertices(const CellLattice<dim> &lattice) const
  {
    std::vector<unsigned int> result(grid.triangulation.n_vertices());
    for (unsigned int v = 0; v < result.size(); ++v)
      result[v] = v;
    if (!grid.parameters.any_periodic())
      return result;
    std::map<typename CellLattice<dim>::Index, unsigned int> first;
    for (unsigned int cell = 0; cell < size(); ++cell)
      if (lattice.at_seam(cell))
        for (unsigned int v = 0;
             v < dealii::GeometryInfo<dim>::vertices_per_cell;
             ++v)
          {
            typename CellLattice<dim>::Index halves;
            for (unsigned int d = 0; d < dim; ++d)
              halves[d] = 2 * ((v >> d) & 1u);
            const unsigned int vertex = iterators[cell]->vertex_index(v);
            result[vertex] =
              first.emplace(lattice.place(cell, halves), vertex).first->second;
          }
    return result;
  }



  template void
  Cells<2>::find_face_neighbors(const CellLattice<2> &);
  template void
  Cells<3>::find_face_neighbors(const CellLattice<3> &);
  template void
  Cells<2>::find_vertex_neighbors(const CellLattice<2> &);
  template void
  Cells<3>::find_vertex_neighbors(const CellLattice<3> &);
  template void
  Cells<2>::find_reaches();
  template void
  Cells<3>::find_reaches();
} // namespace seiche
