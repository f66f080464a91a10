// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_surface_pieces_h
#define seiche_space_surface_pieces_h

#include <seiche/space/cell_simplices.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace seiche
{
  /// A flat piece of a surface: a line in 2D, a triangle in 3D.
  template <int dim>
  using SurfacePiece = std::array<dealii::Point<dim>, dim>;

  /// Size of a piece times its normal: that of the triangle's vertices
  /// counterclockwise, to the right of the line.
  template <int dim>
  dealii::Tensor<1, dim>
  area_vector(const SurfacePiece<dim> &piece);

  /// A function with its signs exchanged: of distances from walls, positive in
  /// the fluid, one that is negative there, as level sets are.
  template <int dim>
  VertexValues<dim>
  negated(VertexValues<dim> values)
  {
    for (double &value : values)
      value = -value;
    return values;
  }

  /// Parts of a piece, whose normals are its own, where the linear function
  /// with these @p values at its vertices is negative.
  template <int dim>
  std::vector<SurfacePiece<dim>>
  parts_inside(const SurfacePiece<dim>       &piece,
               const std::array<double, dim> &values);

  /// Add where the function of a simplex vanishes; normals as below.
  template <int dim>
  void
  add_pieces(const CellSimplex<dim>         &simplex,
             std::vector<SurfacePiece<dim>> &pieces);

  /**
   * Where a multilinear function vanishes in the unit cell, taken as linear on
   * the simplices of CutCell (doc/theory.md, section 5): the pieces of
   * neighbours fit together. Normals point to where it is positive.
   */
  template <int dim>
  std::vector<SurfacePiece<dim>>
  surface_pieces(const VertexValues<dim> &values);
} // namespace seiche

#endif
