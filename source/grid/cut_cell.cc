// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/cut_cell.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  CutCell<dim>::CutCell(const Values &values)
  {
    const bool any = std::any_of(values.begin(), values.end(), [](double v) {
      return v < 0.;
    });
    const bool all = std::all_of(values.begin(), values.end(), [](double v) {
      return v < 0.;
    });
    if (all)
      {
        sum = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          {
            first[d] = 0.5;
            for (unsigned int e = 0; e <= d; ++e)
              second[d][e] = d == e ? 1. / 3. : 1. / 4.;
          }
      }
    else if (any)
      divide(values);
  }

  template <int dim>
  void
  CutCell<dim>::divide(const Values &values)
  {
    const auto mean = [&](const auto &chosen, auto &point) {
      double       value = 0.;
      unsigned int n     = 0;
      point              = Point<dim>();
      for (unsigned int v = 0; v < n_vertices; ++v)
        if (chosen(v))
          {
            value += values[v];
            point += GeometryInfo<dim>::unit_cell_vertex(v);
            ++n;
          }
      point /= n;
      return value / n;
    };
    Simplex simplex;
    // the cell's centre, then (3D) the face's, then the edge
    simplex.values[0] =
      mean([](unsigned int) { return true; }, simplex.vertices[0]);
    for (const unsigned int face : GeometryInfo<dim>::face_indices())
      {
        const auto on_face = [&](const unsigned int v) {
          return ((v >> (face / 2)) & 1u) == face % 2;
        };
        if constexpr (dim == 3)
          simplex.values[1] = mean(on_face, simplex.vertices[1]);
        for (unsigned int v = 0; v < n_vertices; ++v)
          for (unsigned int d = 0; d < dim; ++d)
            if (const unsigned int w = v | (1u << d);
                w != v && on_face(v) && on_face(w))
              {
                simplex.vertices[dim - 1] =
                  GeometryInfo<dim>::unit_cell_vertex(v);
                simplex.vertices[dim] = GeometryInfo<dim>::unit_cell_vertex(w);
                simplex.values[dim - 1] = values[v];
                simplex.values[dim]     = values[w];
                add_negative(simplex);
              }
      }
  }

  template <int dim>
  void
  CutCell<dim>::add_negative(const Simplex &simplex)
  {
    const auto &values = simplex.values;
    const auto  inside =
      std::min_element(values.begin(), values.end()) - values.begin();
    const auto outside =
      std::max_element(values.begin(), values.end()) - values.begin();
    if (values[inside] >= 0.)
      return;
    if (values[outside] <= 0.)
      {
        add(simplex);
        return;
      }
    // divided in two where the function vanishes on this edge
    const double     t = values[inside] / (values[inside] - values[outside]);
    const Point<dim> x =
      simplex.vertices[inside] +
      t * (simplex.vertices[outside] - simplex.vertices[inside]);
    for (const auto replaced : {outside, inside})
      {
        Simplex part            = simplex;
        part.vertices[replaced] = x;
        part.values[replaced]   = 0.;
        add_negative(part);
      }
  }

  template <int dim>
  void
  CutCell<dim>::add(const Simplex &simplex)
  {
    Tensor<2, dim> edges;
    Tensor<1, dim> total = simplex.vertices[0] - Point<dim>();
    for (unsigned int i = 0; i < dim; ++i)
      {
        edges[i] = simplex.vertices[i + 1] - simplex.vertices[0];
        total += simplex.vertices[i + 1] - Point<dim>();
      }
    const double volume = std::abs(determinant(edges)) / (dim == 2 ? 2. : 6.);
    SymmetricTensor<2, dim> products;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e <= d; ++e)
        {
          double sum_of_vertices = total[d] * total[e];
          for (const Point<dim> &x : simplex.vertices)
            sum_of_vertices += x[d] * x[e];
          products[d][e] = sum_of_vertices;
        }
    sum += volume;
    first += volume / (dim + 1) * total;
    second += volume / ((dim + 1) * (dim + 2)) * products;
  }

  template <int dim>
  std::array<Point<dim>, CutCell<dim>::n_vertices>
  CutCell<dim>::points() const
  {
    const Tensor<1, dim>    centre   = first / sum;
    SymmetricTensor<2, dim> variance = second / sum;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e <= d; ++e)
        variance[d][e] -= centre[d] * centre[e];
    // the symmetric root: no axis comes first
    SymmetricTensor<2, dim> root;
    for (const auto &[value, direction] :
         eigenvectors(variance, SymmetricTensorEigenvectorMethod::jacobi))
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e <= d; ++e)
          root[d][e] +=
            std::sqrt(std::max(0., value)) * direction[d] * direction[e];
    std::array<Point<dim>, n_vertices> result;
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        Tensor<1, dim> sign;
        for (unsigned int d = 0; d < dim; ++d)
          sign[d] = ((v >> d) & 1u) != 0 ? 1. : -1.;
        result[v] = Point<dim>() + centre + root * sign;
      }
    return result;
  }

  template class CutCell<2>;
  template class CutCell<3>;
} // namespace seiche
