// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/cell_simplices.h>
#include <seiche/utilities/box_face.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  std::array<CellSimplex<dim>, n_cell_simplices<dim>>
  cell_simplices(const VertexValues<dim> &values)
  {
    const auto mean = [&](const auto &chosen, auto &point) {
      double       value = 0.;
      unsigned int n     = 0;
      point              = Point<dim>();
      for (unsigned int v = 0; v < values.size(); ++v)
        if (chosen(v))
          {
            value += values[v];
            point += GeometryInfo<dim>::unit_cell_vertex(v);
            ++n;
          }
      point /= n;
      return value / n;
    };
    std::array<CellSimplex<dim>, n_cell_simplices<dim>> result;
    auto                                                next = result.begin();
    CellSimplex<dim>                                    simplex;
    // the cell's centre, then (3D) the face's, then the edge
    simplex.values[0] =
      mean([](unsigned int) { return true; }, simplex.vertices[0]);
    for (const BoxFace face : GeometryInfo<dim>::face_indices())
      {
        const auto on_face = [&](const unsigned int v) {
          return face.has_vertex(v);
        };
        if constexpr (dim == 3)
          simplex.values[1] = mean(on_face, simplex.vertices[1]);
        for (unsigned int v = 0; v < values.size(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            if (const unsigned int w = v | (1u << d);
                w != v && on_face(v) && on_face(w))
              {
                simplex.vertices[dim - 1] =
                  GeometryInfo<dim>::unit_cell_vertex(v);
                simplex.vertices[dim] = GeometryInfo<dim>::unit_cell_vertex(w);
                simplex.values[dim - 1] = values[v];
                simplex.values[dim]     = values[w];
                *next++                 = simplex;
              }
      }
    return result;
  }

  template std::array<CellSimplex<2>, n_cell_simplices<2>>
  cell_simplices<2>(const VertexValues<2> &);
  template std::array<CellSimplex<3>, n_cell_simplices<3>>
  cell_simplices<3>(const VertexValues<3> &);
} // namespace seiche
