// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_cell_simplices_h
#define seiche_space_cell_simplices_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>

#include <array>

namespace seiche
{
  /// Values of a function at the vertices of a cell, bit d of whose number is
  /// coordinate d.
  template <int dim>
  using VertexValues =
    std::array<double, dealii::GeometryInfo<dim>::vertices_per_cell>;

  /// A part of the unit cell, or (k < dim) a line or triangle in it, and the
  /// values of a function at its vertices.
  template <int dim, int k = dim>
  struct CellSimplex
  {
    std::array<dealii::Point<dim>, k + 1> vertices;
    std::array<double, k + 1>             values;
  };

  template <int dim>
  constexpr unsigned int n_cell_simplices = dim == 2 ? 4 : 24;

  /**
   * The unit cell divided into simplices around its centre (in 3D around the
   * centres of its faces, too), with the values there of the multilinear
   * function that has these @p values at the vertices (doc/theory.md, section
   * 5, step 3). Neighbours divide the face between them in the same way.
   */
  template <int dim>
  std::array<CellSimplex<dim>, n_cell_simplices<dim>>
  cell_simplices(const VertexValues<dim> &values);
} // namespace seiche

#endif
