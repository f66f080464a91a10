// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/cell_locator.h>
#include <seiche/scene/wrapped.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <map>

// The part of CellLocator that knows periodic sides: the seam.
namespace seiche
{
  template <int dim>
  dealii::Point<dim>
  CellLocator<dim>::wrapped_at_seam(const dealii::Point<dim> &x) const
  {
    dealii::Point<dim> result = x;
    for (unsigned int d = 0; d < dim; ++d)
      if (periodic[d])
        result[d] = seiche::wrapped(x[d],
                                    lines[d].places.front(),
                                    lines[d].places.back());
    return result;
  }



  template <int dim>
  dealii::Tensor<1, dim>
  CellLocator<dim>::shortest_at_seam(const dealii::Tensor<1, dim> &x) const
  {
    dealii::Tensor<1, dim> result = x;
    for (unsigned int d = 0; d < dim; ++d)
      if (periodic[d])
        {
          const double length =
            lines[d].places.back() - lines[d].places.front();
          result[d] -= length * std::round(x[d] / length);
        }
    return result;
  }



  template <int dim>
  dealii::Point<dim>
  CellLocator<dim>::image_at_seam(const dealii::Point<dim> &x,
                                  const unsigned int        cell) const
  {
    dealii::Point<dim> result = x;
    for (unsigned int d = 0; d < dim; ++d)
      if (periodic[d])
        {
          const double length =
            lines[d].places.back() - lines[d].places.front();
          const double centre =
            0.5 * (geometries[cell].lower[d] + geometries[cell].upper[d]);
          result[d] -= length * std::round((x[d] - centre) / length);
        }
    return result;
  }



  template <int dim>
  bool
  CellLocator<dim>::at_seam(const unsigned int cell) const
  {
    for (unsigned int face = 0; face < 2 * dim; ++face)
      if (at_seam(cell, face))
        return true;
    return false;
  }



  template <int dim>
  std::array<unsigned int, dim>
  CellLocator<dim>::lattice_place(
    const unsigned int                   cell,
    const std::array<unsigned int, dim> &halves) const
  {
    std::array<unsigned int, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int n = 2 * (lines[d].places.size() - 1);
        result[d] = 2 * lattice_lower[cell][d] + halves[d] * lattice_size(cell);
        if (periodic[d] && result[d] == n)
          result[d] = 0;
      }
    return result;
  }



  template <int dim>
  unsigned int
  CellLocator<dim>::across_seam(const unsigned int cell,
                                const BoxFace      face) const
  {
    const unsigned int d      = face.direction();
    Lattice            beyond = lattice_lower[cell];
    beyond[d]                = face.is_upper() ? 0 : lines[d].places.size() - 2;
    const unsigned int other = search(beyond);
    return other != invalid && level(other) <= level(cell) ? other : invalid;
  }



  template <int dim>
  std::vector<unsigned int>
  CellLocator<dim>::joined_vertices() const
  {
    std::vector<unsigned int> result(grid.triangulation.n_vertices());
    for (unsigned int v = 0; v < result.size(); ++v)
      result[v] = v;
    if (!grid.parameters.any_periodic())
      return result;
    std::map<std::array<unsigned int, dim>, unsigned int> first;
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      if (at_seam(cell))
        for (unsigned int v = 0;
             v < dealii::GeometryInfo<dim>::vertices_per_cell;
             ++v)
          {
            std::array<unsigned int, dim> halves;
            for (unsigned int d = 0; d < dim; ++d)
              halves[d] = 2 * ((v >> d) & 1u);
            const unsigned int vertex = iterators[cell]->vertex_index(v);
            result[vertex] =
              first.emplace(lattice_place(cell, halves), vertex).first->second;
          }
    return result;
  }



  template dealii::Point<2>
  CellLocator<2>::wrapped_at_seam(const dealii::Point<2> &) const;
  template dealii::Point<3>
  CellLocator<3>::wrapped_at_seam(const dealii::Point<3> &) const;
  template dealii::Tensor<1, 2>
  CellLocator<2>::shortest_at_seam(const dealii::Tensor<1, 2> &) const;
  template dealii::Tensor<1, 3>
  CellLocator<3>::shortest_at_seam(const dealii::Tensor<1, 3> &) const;
  template dealii::Point<2>
  CellLocator<2>::image_at_seam(const dealii::Point<2> &,
                                const unsigned int) const;
  template dealii::Point<3>
  CellLocator<3>::image_at_seam(const dealii::Point<3> &,
                                const unsigned int) const;
  template bool
  CellLocator<2>::at_seam(const unsigned int) const;
  template bool
  CellLocator<3>::at_seam(const unsigned int) const;
  template std::array<unsigned int, 2>
  CellLocator<2>::lattice_place(const unsigned int,
                                const std::array<unsigned int, 2> &) const;
  template std::array<unsigned int, 3>
  CellLocator<3>::lattice_place(const unsigned int,
                                const std::array<unsigned int, 3> &) const;
  template unsigned int
  CellLocator<2>::across_seam(const unsigned int, const BoxFace) const;
  template unsigned int
  CellLocator<3>::across_seam(const unsigned int, const BoxFace) const;
  template std::vector<unsigned int>
  CellLocator<2>::joined_vertices() const;
  template std::vector<unsigned int>
  CellLocator<3>::joined_vertices() const;
} // namespace seiche
