// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/cell_simplices.h>
#include <seiche/utilities/box_face.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// The places that are vertices of simplices: those of the cell, in 3D the
    /// centres of its faces, and its centre.
    template <int dim>
    constexpr unsigned int n_places = dim == 2 ? 5 : 15;

    /// The places as means of the cell's vertices.
    template <int dim>
    std::array<Point<dim>, n_places<dim>>
    make_places()
    {
      std::array<Point<dim>, n_places<dim>> result;
      for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
        result[v] = GeometryInfo<dim>::unit_cell_vertex(v);
      unsigned int place = GeometryInfo<dim>::vertices_per_cell;
      for (unsigned int d = 0; d < dim; ++d)
        result.back()[d] = 0.5;
      if constexpr (dim == 3)
        for (const BoxFace face : GeometryInfo<dim>::face_indices())
          {
            result[place]                     = result.back();
            result[place++][face.direction()] = face.is_upper();
          }
      return result;
    }

    template <int dim>
    std::array<double, n_places<dim>>
    values_at_places(const VertexValues<dim> &values)
    {
      std::array<double, n_places<dim>> result;
      constexpr unsigned int n = std::tuple_size_v<VertexValues<dim>>;
      std::copy(values.begin(), values.end(), result.begin());
      double sum = 0.;
      for (const double value : values)
        sum += value;
      result.back() = sum / n;
      if constexpr (dim == 3)
        for (const BoxFace face : GeometryInfo<dim>::face_indices())
          {
            sum = 0.;
            for (unsigned int v = 0; v < n; ++v)
              if (face.has_vertex(v))
                sum += values[v];
            result[n + face] = sum / (n / 2);
          }
      return result;
    }

    template <int dim>
    using Corners = std::array<unsigned int, dim + 1>; ///< places

    /// The cell's centre, then (3D) the face's, then the edge.
    template <int dim>
    std::array<Corners<dim>, n_cell_simplices<dim>>
    make_corners()
    {
      std::array<Corners<dim>, n_cell_simplices<dim>> result;
      constexpr unsigned int n    = std::tuple_size_v<VertexValues<dim>>;
      auto                   next = result.begin();
      for (const BoxFace face : GeometryInfo<dim>::face_indices())
        for (unsigned int v = 0; v < n; ++v)
          for (unsigned int d = 0; d < dim; ++d)
            if (const unsigned int w = v | (1u << d);
                w != v && face.has_vertex(v) && face.has_vertex(w))
              {
                Corners<dim> corners;
                corners[0] = n_places<dim> - 1;
                if constexpr (dim == 3)
                  corners[1] = n + face;
                corners[dim - 1] = v;
                corners[dim]     = w;
                *next++          = corners;
              }
      return result;
    }
  } // namespace

  template <int dim>
  std::array<CellSimplex<dim>, n_cell_simplices<dim>>
  cell_simplices(const VertexValues<dim> &values)
  {
    static const auto places  = make_places<dim>();
    static const auto corners = make_corners<dim>();
    const auto        at      = values_at_places<dim>(values);
    std::array<CellSimplex<dim>, n_cell_simplices<dim>> result;
    for (unsigned int s = 0; s < result.size(); ++s)
      for (unsigned int v = 0; v <= dim; ++v)
        {
          result[s].vertices[v] = places[corners[s][v]];
          result[s].values[v]   = at[corners[s][v]];
        }
    return result;
  }

  template std::array<CellSimplex<2>, n_cell_simplices<2>>
  cell_simplices<2>(const VertexValues<2> &);
  template std::array<CellSimplex<3>, n_cell_simplices<3>>
  cell_simplices<3>(const VertexValues<3> &);
} // namespace seiche
