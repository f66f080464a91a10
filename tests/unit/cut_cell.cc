// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of a cell where a linear function is negative: volume, centre and
// second moments are exact, the rule's points lie inside, and both sides of the
// function add up to the cell.
#include <seiche/grid/cut_cell.h>

#include <cmath>
#include <iostream>
#include <random>

namespace
{
  using namespace dealii;
  using seiche::CutCell;
  using seiche::VertexValues;

  template <int dim>
  VertexValues<dim>
  plane(const Tensor<1, dim> &normal, const double distance)
  {
    VertexValues<dim> values;
    for (unsigned int v = 0; v < values.size(); ++v)
      {
        values[v] = -distance;
        for (unsigned int d = 0; d < dim; ++d)
          values[v] += normal[d] * ((v >> d) & 1u);
      }
    return values;
  }

  /// Volume, first and second moments by the rule.
  template <int dim>
  std::array<double, 1 + dim + dim * dim>
  moments(const CutCell<dim> &part)
  {
    std::array<double, 1 + dim + dim * dim> result{};
    if (part.volume() == 0.)
      return result;
    for (const Point<dim> &x : part.points())
      {
        const double weight = part.volume() / CutCell<dim>::n_vertices;
        result[0] += weight;
        for (unsigned int d = 0; d < dim; ++d)
          {
            result[1 + d] += weight * x[d];
            for (unsigned int e = 0; e < dim; ++e)
              result[1 + dim + d * dim + e] += weight * x[d] * x[e];
          }
      }
    return result;
  }

  /// A cut along x_d, and the Gauss rule of what is left.
  template <int dim>
  double
  error_along_axes()
  {
    double error = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      for (const double height : {0.1, 0.5, 0.93, 1.})
        {
          Tensor<1, dim> normal;
          normal[d] = 1.;
          const CutCell<dim> part(
            plane<dim>(normal, height == 1. ? 1.1 : height));
          error = std::max(error, std::abs(part.volume() - height));
          for (const Point<dim> &x : part.points())
            for (unsigned int e = 0; e < dim; ++e)
              {
                const double size = e == d ? height : 1.;
                error             = std::max(error,
                                 std::abs(std::abs(x[e] - 0.5 * size) -
                                          0.5 * size / std::sqrt(3.)));
              }
        }
    return error;
  }

  /// Both sides of oblique planes against the whole cell; volumes against the
  /// share of many points.
  template <int dim>
  void
  check_planes()
  {
    std::mt19937 generator(3);
    const auto   random = [&]() {
      return generator() / static_cast<double>(generator.max());
    };
    const auto whole = moments(CutCell<dim>(plane<dim>(Tensor<1, dim>(), 1.)));
    double     error = 0., sampled = 0., outside = 0.;
    for (unsigned int i = 0; i < 200; ++i)
      {
        Tensor<1, dim> normal;
        for (unsigned int d = 0; d < dim; ++d)
          normal[d] = 2. * random() - 1.;
        double distance = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          distance += normal[d] * random();
        const auto values = plane<dim>(normal, distance);
        auto       other  = values;
        for (double &value : other)
          value = -value;
        const CutCell<dim> part(values);
        const auto one = moments(part), two = moments(CutCell<dim>(other));
        for (unsigned int k = 0; k < one.size(); ++k)
          error = std::max(error, std::abs(one[k] + two[k] - whole[k]));
        if (part.volume() > 0.)
          for (const Point<dim> &x : part.points())
            for (unsigned int d = 0; d < dim; ++d)
              outside = std::max({outside, -x[d], x[d] - 1.});
        constexpr unsigned int n     = 2000;
        unsigned int           below = 0;
        for (unsigned int s = 0; s < n; ++s)
          {
            double value = -distance;
            for (unsigned int d = 0; d < dim; ++d)
              value += normal[d] * random();
            below += value < 0.;
          }
        sampled =
          std::max(sampled,
                   std::abs(part.volume() - below / static_cast<double>(n)));
      }
    std::cout << dim << "D, both sides of a plane add up to the cell: "
              << (error < 1e-12 ? "yes" : "NO")
              << "; volumes as sampled: " << (sampled < 0.06 ? "yes" : "NO")
              << "; points in the cell up to 0.02: "
              << (outside < 0.02 ? "yes" : "NO") << '\n';
  }

  template <int dim>
  void
  check()
  {
    std::cout << dim << "D, Gauss points of a cell cut along an axis: "
              << (error_along_axes<dim>() < 1e-12 ? "yes" : "NO") << '\n';
    check_planes<dim>();
    VertexValues<dim> positive;
    positive.fill(1.);
    std::cout << dim << "D, nothing of a cell outside: "
              << (CutCell<dim>(positive).volume() == 0. ? "yes" : "NO") << '\n';
  }
} // namespace

int
main()
{
  check<2>();
  check<3>();
}
