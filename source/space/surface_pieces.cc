// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/divided_simplex.h>
#include <seiche/space/surface_pieces.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Area of a piece that is a point or a line but for round-off, and whose
    /// normal says nothing.
    constexpr double negligible_area = 1e-12; // of the cell's faces
  }                                           // namespace

  template <int dim>
  void
  add_pieces(const CellSimplex<dim>         &simplex,
             std::vector<SurfacePiece<dim>> &pieces)
  {
    const DividedSimplex<dim> divided(simplex);
    const unsigned int        n_inside = divided.n_inside,
                       n_outside       = divided.n_outside;
    if (n_inside == 0 || n_outside == 0)
      return;

    // the corners of its zero: one on each edge that changes sign, in order
    std::vector<Point<dim>> corners;
    for (unsigned int i = 0; i < n_inside; ++i)
      for (unsigned int k = 0; k < n_outside; ++k)
        {
          const unsigned int o = i % 2 == 0 ? k : n_outside - 1 - k;
          corners.push_back(divided.zero(i, n_inside + o));
        }
    // the zero may pass through vertices outside, never through this one
    const Point<dim> &inside =
      simplex.vertices[std::min_element(simplex.values.begin(),
                                        simplex.values.end()) -
                       simplex.values.begin()];
    for (unsigned int first = 1; first + dim - 1 <= corners.size(); ++first)
      {
        SurfacePiece<dim> piece;
        piece[0] = corners[0];
        std::copy_n(corners.begin() + first, dim - 1, piece.begin() + 1);
        const Tensor<1, dim> normal = area_vector<dim>(piece);
        if (normal * (piece[0] - inside) < 0.)
          std::swap(piece[0], piece[1]);
        if (normal.norm() > negligible_area)
          pieces.push_back(piece);
      }
  }

  template <int dim>
  std::vector<SurfacePiece<dim>>
  parts_inside(const SurfacePiece<dim>       &piece,
               const std::array<double, dim> &values)
  {
    const CellSimplex<dim, dim - 1> simplex{piece, values};
    const Tensor<1, dim>            area = area_vector<dim>(piece);
    std::vector<SurfacePiece<dim>>  result;
    DividedSimplex<dim, dim - 1>(simplex).for_each_inside(
      [&](SurfacePiece<dim> part) {
        if (area_vector<dim>(part) * area < 0.) // it may be turned
          std::swap(part[0], part[1]);
        // the zero passes through a vertex
        if (area_vector<dim>(part).norm() > negligible_area)
          result.push_back(part);
      });
    return result;
  }

  template <int dim>
  Tensor<1, dim>
  area_vector(const SurfacePiece<dim> &piece)
  {
    if constexpr (dim == 2)
      return cross_product_2d(Tensor<1, dim>(piece[1] - piece[0]));
    else
      return 0.5 * cross_product_3d(Tensor<1, dim>(piece[1] - piece[0]),
                                    Tensor<1, dim>(piece[2] - piece[0]));
  }

  template <int dim>
  std::vector<SurfacePiece<dim>>
  surface_pieces(const VertexValues<dim> &values)
  {
    std::vector<SurfacePiece<dim>> pieces;
    const auto is_inside = [](const double value) { return value < 0.; };
    if (std::any_of(values.begin(), values.end(), is_inside) &&
        !std::all_of(values.begin(), values.end(), is_inside))
      for (const CellSimplex<dim> &simplex : cell_simplices<dim>(values))
        add_pieces<dim>(simplex, pieces);
    return pieces;
  }

  template Tensor<1, 2>
  area_vector<2>(const SurfacePiece<2> &);
  template Tensor<1, 3>
  area_vector<3>(const SurfacePiece<3> &);
  template std::vector<SurfacePiece<2>>
  parts_inside<2>(const SurfacePiece<2> &, const std::array<double, 2> &);
  template std::vector<SurfacePiece<3>>
  parts_inside<3>(const SurfacePiece<3> &, const std::array<double, 3> &);
  template void
  add_pieces<2>(const CellSimplex<2> &, std::vector<SurfacePiece<2>> &);
  template void
  add_pieces<3>(const CellSimplex<3> &, std::vector<SurfacePiece<3>> &);
  template std::vector<SurfacePiece<2>>
  surface_pieces<2>(const VertexValues<2> &);
  template std::vector<SurfacePiece<3>>
  surface_pieces<3>(const VertexValues<3> &);
} // namespace seiche
