// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/cut_cell.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  CutCell<dim>::CutCell(const VertexValues<dim> &values)
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
      for (const CellSimplex<dim> &simplex : cell_simplices<dim>(values))
        add_negative(simplex);
  }

  template <int dim>
  void
  CutCell<dim>::add_negative(const CellSimplex<dim> &simplex)
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
        CellSimplex<dim> part   = simplex;
        part.vertices[replaced] = x;
        part.values[replaced]   = 0.;
        add_negative(part);
      }
  }

  template <int dim>
  void
  CutCell<dim>::add(const CellSimplex<dim> &simplex)
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
