// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of a cell where a linear function is negative: volume, centre and
// second moments are exact, the rule's points lie inside, and both sides of the
// function add up to the cell.
#include <seiche/space/cut_cell.h>

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

  /// Corners of the cell cut off by a plane: simplices.
  template <int dim>
  double
  error_of_corners()
  {
    std::mt19937 generator(5);
    double       error = 0.;
    for (unsigned int corner = 0; corner < CutCell<dim>::n_vertices; ++corner)
      for (unsigned int i = 0; i < 20; ++i)
        {
          Tensor<1, dim> edge, normal; // lengths along the cell's edges
          double         distance = 1., volume = dim == 2 ? 0.5 : 1. / 6.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              edge[d] = 0.05 + 0.95 * generator() / generator.max();
              volume *= edge[d];
              const bool upper = (corner >> d & 1u) != 0;
              normal[d]        = (upper ? -1. : 1.) / edge[d];
              distance += upper ? normal[d] : 0.;
            }
          std::array<double, 1 + dim + dim * dim> exact{};
          exact[0] = volume;
          Tensor<1, dim> sign, origin;
          for (unsigned int d = 0; d < dim; ++d)
            {
              origin[d] = corner >> d & 1u;
              sign[d]   = 1. - 2. * origin[d];
            }
          // x = origin + sign y, int y_d = V a_d/(dim + 1), int y_d y_e = V
          // a_d a_e (1 + delta_de)/((dim + 1)(dim + 2))
          const auto first = [&](const unsigned int d) {
            return volume * edge[d] / (dim + 1);
          };
          for (unsigned int d = 0; d < dim; ++d)
            {
              exact[1 + d] = origin[d] * volume + sign[d] * first(d);
              for (unsigned int e = 0; e < dim; ++e)
                exact[1 + dim + d * dim + e] =
                  origin[d] * origin[e] * volume +
                  origin[d] * sign[e] * first(e) +
                  origin[e] * sign[d] * first(d) +
                  sign[d] * sign[e] * volume * edge[d] * edge[e] *
                    (d == e ? 2. : 1.) / ((dim + 1) * (dim + 2));
            }
          const auto found =
            moments(CutCell<dim>(plane<dim>(normal, distance)));
          for (unsigned int k = 0; k < found.size(); ++k)
            error = std::max(error, std::abs(found[k] - exact[k]));
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
    std::cout << dim << "D, moments of corners cut off: "
              << (error_of_corners<dim>() < 1e-12 ? "yes" : "NO") << '\n';
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
