// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_wet_part_h
#define seiche_space_wet_part_h

#include <seiche/mesh/cell_geometry.h>
#include <seiche/space/cell_simplices.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace seiche
{
  /// A point in the unit cell with its share of the cell's volume [-].
  template <int dim>
  struct WeightedPoint
  {
    dealii::Point<dim> unit;
    double             weight;
  };

  /// Add the hat functions of the vertices at a point to their integrals.
  template <int dim>
  inline void
  add_hats(const WeightedPoint<dim> &point, VertexValues<dim> &integrals)
  {
    for (unsigned int v = 0; v < integrals.size(); ++v)
      integrals[v] +=
        point.weight *
        dealii::GeometryInfo<dim>::d_linear_shape_function(point.unit, v);
  }

  /// A point of a wall in the unit cell.
  template <int dim>
  struct WallPoint
  {
    dealii::Point<dim>     unit;
    dealii::Tensor<1, dim> area; ///< times the normal out of the fluid
                                 ///< [m^(dim-1)]
    unsigned int solid = 0;      ///< the nearest (GridParameters::solids)
    /// Unit vector out of the fluid, that of the solid itself: the grid's walls
    /// are chords.
    dealii::Tensor<1, dim> normal = {};
  };

  /// What a solid does to the fluid at a point of its wall.
  template <int dim>
  struct SolidReaction
  {
    unsigned int           solid; ///< number
    dealii::Point<dim>     place; ///< in the configuration of the forces [m]
    dealii::Tensor<1, dim> force; ///< on the fluid [N]
    double                 work = 0.; ///< on the fluid in the step [J]
  };

  /**
   * @brief The fluid in a cell that a wall cuts: where one multilinear function
   * is negative (the level set of the free surface) and another one is positive
   * (the distance from the wall), both taken as linear on cell_simplices().
   *
   * Rule and wall together satisfy the divergence theorem of p w, p linear and
   * w multilinear: water at rest stays at rest wherever the wall lies
   * (doc/theory.md, section 8).
   */
  template <int dim>
  struct WetPart
  {
    /// Nothing.
    WetPart() = default;

    WetPart(const VertexValues<dim> &surface,
            const VertexValues<dim> &wall,
            const CellGeometry<dim> &geometry);

    /// Share of the cell [-].
    double volume = 0.;
    /// Positive weights; exact for polynomials of degree dim.
    std::vector<WeightedPoint<dim>> points;
    /// Of the wall where there is fluid at it; exact for the products of p w n.
    std::vector<WallPoint<dim>> wall;
  };

  /// Integrals, over the cell's measure, of the hat functions of the vertices
  /// over what both functions leave, as above: @p wall negative for the other
  /// side.
  template <int dim>
  VertexValues<dim>
  hat_integrals(const VertexValues<dim> &surface,
                const VertexValues<dim> &wall);

  /// The same of one vertex.
  template <int dim>
  double
  hat_integral(const unsigned int       vertex,
               const VertexValues<dim> &surface,
               const VertexValues<dim> &wall);
} // namespace seiche

#endif
