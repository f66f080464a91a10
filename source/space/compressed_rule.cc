// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/compressed_rule.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Pivots below it [of monomials on [-1,1]] are round-off.
    constexpr double dependent = 1e-9;

    using Row = std::vector<double>;

    /// The monomials up to a degree at a place.
    template <int dim>
    Row
    monomials(const Point<dim> &x, const unsigned int degree)
    {
      Row    result;
      double x_i = 1.;
      for (unsigned int i = 0; i <= degree; ++i, x_i *= x[0])
        {
          double x_ij = x_i;
          for (unsigned int j = 0; i + j <= degree; ++j, x_ij *= x[1])
            {
              double x_ijk = x_ij;
              for (unsigned int k = 0; k <= (dim == 3 ? degree - i - j : 0);
                   ++k, x_ijk *= x[dim - 1])
                result.push_back(x_ijk);
            }
        }
      return result;
    }

    /// Points of one place are one: neighbouring simplices share theirs.
    template <int dim>
    std::vector<WeightedPoint<dim>>
    merged(const std::vector<WeightedPoint<dim>> &points)
    {
      constexpr double per_unit = 1e9; // closer is the same
      struct Place
      {
        std::array<long, dim> x;
        unsigned int          point;

        bool
        operator<(const Place &other) const
        {
          return std::tie(x, point) < std::tie(other.x, other.point);
        }
      };
      std::vector<Place> places(points.size());
      for (unsigned int p = 0; p < points.size(); ++p)
        {
          places[p].point = p;
          for (unsigned int d = 0; d < dim; ++d)
            places[p].x[d] = std::lround(points[p].unit[d] * per_unit);
        }
      std::sort(places.begin(), places.end());
      std::vector<WeightedPoint<dim>> result;
      for (unsigned int p = 0; p < places.size(); ++p)
        if (p > 0 && places[p].x == places[p - 1].x)
          result.back().weight += points[places[p].point].weight;
        else
          result.push_back(points[places[p].point]);
      return result;
    }

    /// Weights that change no moment: the null space of the matrix whose
    /// columns these are, by Gauss-Jordan elimination with complete pivoting.
    std::vector<Row>
    null_space(const std::vector<Row> &columns)
    {
      const unsigned int n_rows = columns[0].size(), n = columns.size();
      std::vector<Row>   A(n_rows, Row(n));
      for (unsigned int i = 0; i < n_rows; ++i)
        for (unsigned int j = 0; j < n; ++j)
          A[i][j] = columns[j][i];
      std::vector<unsigned int> pivots; // column of each row
      std::vector<char>         is_pivot(n, 0);
      for (unsigned int row = 0; row < n_rows; ++row)
        {
          unsigned int best_i = row, best_j = n;
          double       best = dependent;
          for (unsigned int i = row; i < n_rows; ++i)
            for (unsigned int j = 0; j < n; ++j)
              if (!is_pivot[j] && std::abs(A[i][j]) > best)
                {
                  best   = std::abs(A[i][j]);
                  best_i = i;
                  best_j = j;
                }
          if (best_j == n)
            break;
          std::swap(A[row], A[best_i]);
          const double inverse = 1. / A[row][best_j];
          for (double &entry : A[row])
            entry *= inverse;
          for (unsigned int i = 0; i < n_rows; ++i)
            if (const double factor = A[i][best_j]; i != row && factor != 0.)
              for (unsigned int j = 0; j < n; ++j)
                A[i][j] -= factor * A[row][j];
          is_pivot[best_j] = 1;
          pivots.push_back(best_j);
        }
      std::vector<Row> result;
      for (unsigned int j = 0; j < n; ++j)
        if (!is_pivot[j])
          {
            Row null(n, 0.);
            null[j] = 1.;
            for (unsigned int row = 0; row < pivots.size(); ++row)
              null[pivots[row]] = -A[row][j];
            result.push_back(std::move(null));
          }
      return result;
    }

    /// Take as many points out as the null space has dimensions: along each of
    /// its vectors to where the first weight is zero.
    template <int dim>
    void
    take_out(std::vector<WeightedPoint<dim>> &points, std::vector<Row> &columns)
    {
      std::vector<Row>  nulls = null_space(columns);
      std::vector<char> is_out(points.size(), 0);
      for (; !nulls.empty(); nulls.pop_back())
        {
          const Row   &null = nulls.back();
          double       step = 0.;
          unsigned int out  = points.size();
          for (unsigned int j = 0; j < points.size(); ++j)
            if (null[j] > dependent && !is_out[j] &&
                (out == points.size() || points[j].weight < step * null[j]))
              {
                step = points[j].weight / null[j];
                out  = j;
              }
          if (out == points.size())
            continue;
          for (unsigned int j = 0; j < points.size(); ++j)
            points[j].weight = std::max(0., points[j].weight - step * null[j]);
          is_out[out] = 1;
          for (unsigned int k = 0; k + 1 < nulls.size(); ++k)
            {
              const double factor = nulls[k][out] / null[out];
              for (unsigned int j = 0; j < points.size(); ++j)
                nulls[k][j] -= factor * null[j];
              nulls[k][out] = 0.;
            }
        }
      unsigned int kept = 0;
      for (unsigned int j = 0; j < points.size(); ++j)
        if (!is_out[j] && points[j].weight > 0.)
          {
            points[kept]  = points[j];
            columns[kept] = columns[j];
            ++kept;
          }
      points.resize(kept);
      columns.resize(kept);
    }
  } // namespace

  template <int dim>
  std::vector<WeightedPoint<dim>>
  compressed_rule(const std::vector<WeightedPoint<dim>> &points,
                  const unsigned int                     degree)
  {
    // about the middle of the points, in units of their extent
    Point<dim> lower = points[0].unit, upper = lower;
    for (const auto &point : points)
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = std::min(lower[d], point.unit[d]);
          upper[d] = std::max(upper[d], point.unit[d]);
        }
    const auto scaled = [&](Point<dim> x) {
      for (unsigned int d = 0; d < dim; ++d)
        if (upper[d] > lower[d])
          x[d] = 2. * (x[d] - lower[d]) / (upper[d] - lower[d]) - 1.;
      return x;
    };

    std::vector<WeightedPoint<dim>> result;
    std::vector<Row>                columns;
    for (const WeightedPoint<dim> &point : merged(points))
      {
        result.push_back(point);
        columns.push_back(monomials(scaled(point.unit), degree));
        if (result.size() == 2 * columns[0].size())
          take_out<dim>(result, columns);
      }
    take_out<dim>(result, columns);
    return result;
  }

  template std::vector<WeightedPoint<2>>
  compressed_rule<2>(const std::vector<WeightedPoint<2>> &, const unsigned int);
  template std::vector<WeightedPoint<3>>
  compressed_rule<3>(const std::vector<WeightedPoint<3>> &, const unsigned int);
} // namespace seiche
