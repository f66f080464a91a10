// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/cost_model.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numeric>

namespace seiche
{
  namespace
  {
    /// Fitted to 4000 runs of the shipped scenes and their studies: half of
    /// them within 20 %, nine of ten within a factor of two.
    struct Row
    {
      int          dim;
      unsigned int degree;
      bool         is_mixed;
      double       step;  ///< [us] of any
      double       cell;  ///< [us] a step and occupied cell
      double       point; ///< [us] a step and point
      double       kib;   ///< memory of an occupied cell [KiB]
    };

    constexpr Row table[] = {{2, 1, true, 250., 5.5, 0.08, 3.5},
                             {2, 1, false, 450., 6., 0.11, 5.5},
                             {2, 2, true, 300., 80., 0.08, 22.},
                             {2, 2, false, 300., 75., 0.11, 24.},
                             {3, 1, true, 1200., 22., 0.25, 8.},
                             {3, 1, false, 930., 25., 0.35, 19.},
                             {3, 2, true, 1200., 1500., 0.3, 225.},
                             {3, 2, false, 1200., 1700., 0.3, 275.}};

    // The cells of a viscous step cost up to 1 + 3 times as much, half of the
    // 3 at a diffusion number of 4.
    constexpr double viscous_share = 3., viscous_half = 4.;

    constexpr double kib         = 1024.;
    constexpr double base_memory = 122. * kib * kib; // libraries
    constexpr double mesh_memory = 1. * kib;         // of a cell
    // columns, cell and copies while sorting
    constexpr double point_memory = 200.;



    const Row &
    row(const int dim, const unsigned int degree, const bool is_mixed)
    {
      for (const Row &candidate : table)
        if (candidate.dim == dim && candidate.degree == degree &&
            candidate.is_mixed == is_mixed)
          return candidate;
      AssertThrow(false, dealii::ExcNotImplemented());
      return table[0];
    }



    /// Processor time of products of small matrices, such as the tangent is
    /// made of [s].
    double
    time_of_products()
    {
      constexpr unsigned int               n = 24, repetitions = 400;
      std::array<std::array<double, n>, n> a, b;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            // rows add up to 1: powers do not become subnormal, with which
            // some processors take a hundred times as long
            a[i][j] = (i == j ? 0.5 : 0.5 / (n - 1));
            b[i][j] = (i == j ? 1. : 0.);
          }
      const std::clock_t begin = std::clock();
      for (unsigned int repetition = 0; repetition < repetitions; ++repetition)
        {
          std::array<std::array<double, n>, n> c{};
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int k = 0; k < n; ++k)
              for (unsigned int j = 0; j < n; ++j)
                c[i][j] += a[i][k] * b[k][j];
          b = c; // each product needs the one before
        }
      double sum = 0.;
      for (const auto &row_of_b : b)
        sum = std::accumulate(row_of_b.begin(), row_of_b.end(), sum);
      // all of the result is used, before the clock is looked at again
      const volatile double used = sum;
      (void)used;
      const std::clock_t end = std::clock();
      return static_cast<double>(end - begin) / CLOCKS_PER_SEC;
    }



    double
    power(const double base, const int exponent)
    {
      return std::pow(base, exponent);
    }
  } // namespace



  CostModel::CostModel(const int          dimension,
                       const unsigned int element_degree,
                       const bool         mixed)
    : dim(dimension)
    , degree(element_degree)
    , is_mixed(mixed)
  {}



  double
  CostModel::step(const double occupied_cells,
                  const double points,
                  const double diffusion) const
  {
    const Row   &r = row(dim, degree, is_mixed);
    const double viscous =
      1. + viscous_share * diffusion / (diffusion + viscous_half);
    return 1e-6 * slowness() *
           (r.step + r.cell * viscous * occupied_cells + r.point * points);
  }



  double
  CostModel::start(const double cells) const
  {
    return slowness() * (0.05 + 1e-6 * (dim == 2 ? 7. : 15.) * cells);
  }



  double
  CostModel::output(const double bytes) const
  {
    return slowness() * 4e-8 * bytes;
  }



  double
  CostModel::memory(const double cells,
                    const double occupied_cells,
                    const double points) const
  {
    return base_memory + mesh_memory * cells +
           kib * row(dim, degree, is_mixed).kib * occupied_cells +
           point_memory * points;
  }



  double
  CostModel::point_frame(const double points) const
  {
    return 40. * points;
  }



  double
  CostModel::grid_frame(const double occupied_cells) const
  {
    return (dim == 2 ? 85. : 130.) * power(degree, dim) * occupied_cells;
  }



  double
  CostModel::surface_frame(const double cells) const
  {
    return 3000. + (dim == 2 ? 150. : 600.) * cells;
  }



  double
  CostModel::full_points(const double points) const
  {
    return (dim == 2 ? 104. : 160.) * points;
  }



  double
  slowness()
  {
    constexpr double    reference = 3.2e-4; // [s]
    static const double measured  = [] {
      double best = time_of_products();
      for (unsigned int i = 0; i < 8; ++i)
        best = std::min(best, time_of_products());
      return best;
    }();
    return measured / reference;
  }
} // namespace seiche
