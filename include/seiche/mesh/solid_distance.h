// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_solid_distance_h
#define seiche_mesh_solid_distance_h

#include <seiche/mesh/cell_geometry.h>
#include <seiche/scene/solid.h>

namespace seiche
{
  /**
   * @brief Distance from solids in a cell as the grid has it: that of the
   * cell's vertices, interpolated (doc/theory.md, section 8).
   */
  template <int dim>
  class SolidDistance
  {
  public:
    /// @p geometry must outlive the object.
    SolidDistance(const std::vector<Solid<dim>> &solids,
                  const CellGeometry<dim>       &geometry)
      : cell(geometry)
    {
      for (const unsigned int v : Shape::vertex_indices())
        at_vertices[v] =
          distance_from(solids, cell.to_real(Shape::unit_cell_vertex(v)));
    }

    /// [m], positive in the fluid.
    double
    value(const dealii::Point<dim> &x) const
    {
      const dealii::Point<dim> unit   = cell.to_unit(x);
      double                   result = 0.;
      for (const unsigned int v : Shape::vertex_indices())
        result += at_vertices[v] * Shape::d_linear_shape_function(unit, v);
      return result;
    }

    dealii::Tensor<1, dim>
    gradient(const dealii::Point<dim> &x) const
    {
      const dealii::Point<dim> unit = cell.to_unit(x);
      dealii::Tensor<1, dim>   result;
      for (const unsigned int v : Shape::vertex_indices())
        result +=
          at_vertices[v] * Shape::d_linear_shape_function_gradient(unit, v);
      for (unsigned int d = 0; d < dim; ++d)
        result[d] /= cell.edges[d];
      return result;
    }

  private:
    using Shape = dealii::GeometryInfo<dim>;

    const CellGeometry<dim>                     &cell;
    std::array<double, Shape::vertices_per_cell> at_vertices;
  };
} // namespace seiche

#endif
