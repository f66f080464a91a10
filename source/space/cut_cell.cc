// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/cut_cell.h>
#include <seiche/space/divided_simplex.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Two roots of eigenvalues below this share of the third are zero: nothing
    /// is left of them beside round-off.
    constexpr double needle = 1e-9;

    template <int dim>
    Moments<dim>
    of_unit_cell()
    {
      Moments<dim> result;
      result.volume = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          result.first[d] = 0.5;
          for (unsigned int e = 0; e <= d; ++e)
            result.second[d][e] = d == e ? 1. / 3. : 1. / 4.;
        }
      return result;
    }

    template <int dim>
    using Simplex = std::array<Point<dim>, dim + 1>; ///< vertices

    template <int dim>
    Moments<dim>
    of_simplex(const Simplex<dim> &simplex)
    {
      Tensor<2, dim> edges;
      Tensor<1, dim> total = simplex[0] - Point<dim>();
      for (unsigned int i = 0; i < dim; ++i)
        {
          edges[i] = simplex[i + 1] - simplex[0];
          total += simplex[i + 1] - Point<dim>();
        }
      Moments<dim> result;
      result.volume = std::abs(determinant(edges)) / (dim == 2 ? 2. : 6.);
      result.first  = result.volume / (dim + 1) * total;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e <= d; ++e)
          {
            double sum = total[d] * total[e];
            for (const Point<dim> &x : simplex)
              sum += x[d] * x[e];
            result.second[d][e] = result.volume / ((dim + 1) * (dim + 2)) * sum;
          }
      return result;
    }

    /// Of the whole simplices of a cell, whatever the values.
    template <int dim>
    const std::array<Moments<dim>, n_cell_simplices<dim>> &
    of_whole_simplices()
    {
      static const auto result = []() {
        std::array<Moments<dim>, n_cell_simplices<dim>> moments;
        const auto simplices = cell_simplices<dim>(VertexValues<dim>());
        for (unsigned int s = 0; s < moments.size(); ++s)
          moments[s] = of_simplex<dim>(simplices[s].vertices);
        return moments;
      }();
      return result;
    }

    /// The root in closed form; rounding may leave @p square slightly
    /// indefinite.
    SymmetricTensor<2, 2>
    symmetric_root(const SymmetricTensor<2, 2> &square)
    {
      const double root = std::sqrt(std::max(0., determinant(square)));
      const double sum  = std::sqrt(std::max(0., trace(square) + 2. * root));
      if (sum == 0.)
        return SymmetricTensor<2, 2>();
      return (square + root * unit_symmetric_tensor<2>()) / sum;
    }

    /// The same in 3D (Franca 1989): the largest eigenvalue gives the
    /// invariants of the root, those the root by its characteristic equation.
    SymmetricTensor<2, 3>
    symmetric_root(const SymmetricTensor<2, 3> &square)
    {
      const double I = trace(square), II = second_invariant(square),
                   III = std::max(0., determinant(square));
      if (!(I > 0.))
        return SymmetricTensor<2, 3>();
      const double k = std::max(0., I * I - 3. * II);
      const double angle =
        k > 0. ? std::acos(std::clamp((I * (I * I - 4.5 * II) + 13.5 * III) /
                                        (k * std::sqrt(k)),
                                      -1.,
                                      1.)) :
                 0.;
      const double largest = std::sqrt(
        std::max(0., (I + 2. * std::sqrt(k) * std::cos(angle / 3.)) / 3.));
      const double product = std::sqrt(III);
      const double sum =
        largest +
        std::sqrt(std::max(0., I - largest * largest + 2. * product / largest));
      const double       pairs = 0.5 * (sum * sum - I);
      const Tensor<2, 3> full(square);
      const double       scale = sum * pairs - product;
      if (scale <= needle * sum * sum * sum)
        return square / sum; // of rank one
      return (sum * product * unit_symmetric_tensor<3>() +
              (sum * sum - pairs) * square - symmetrize(full * full)) /
             scale;
    }
  } // namespace

  template <int dim>
  CutCell<dim>::CutCell(const VertexValues<dim> &values)
  {
    const auto is_inside = [](const double value) { return value < 0.; };
    const auto n_inside =
      std::count_if(values.begin(), values.end(), is_inside);
    if (n_inside == n_vertices)
      part = of_unit_cell<dim>();
    else if (n_inside > 0)
      {
        const auto simplices = cell_simplices<dim>(values);
        for (unsigned int s = 0; s < simplices.size(); ++s)
          add_inside(simplices[s], of_whole_simplices<dim>()[s]);
      }
  }

  template <int dim>
  void
  CutCell<dim>::add_inside(const CellSimplex<dim> &simplex,
                           const Moments<dim>     &whole)
  {
    const DividedSimplex<dim> divided(simplex);
    if (divided.n_inside == 0)
      return;
    if (divided.n_inside == dim + 1)
      part.add(whole);
    else
      divided.for_each_inside([this](const Simplex<dim> &piece) {
        part.add(of_simplex<dim>(piece));
      });
  }

  template <int dim>
  std::array<Point<dim>, CutCell<dim>::n_vertices>
  CutCell<dim>::points() const
  {
    const Tensor<1, dim>    centre   = part.first / part.volume;
    SymmetricTensor<2, dim> variance = part.second / part.volume;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e <= d; ++e)
        variance[d][e] -= centre[d] * centre[e];
    const SymmetricTensor<2, dim>      root = symmetric_root(variance);
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
