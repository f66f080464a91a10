// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_lanes_h
#define seiche_utilities_lanes_h

#include <deal.II/base/template_constraints.h>
#include <deal.II/base/tensor.h>

#include <array>

#include <experimental/simd>

/**
 * @file
 * Numbers at several quadrature points at once. (deal.II's VectorizedArray is
 * as wide as the registers that deal.II was built for: two numbers in Debian.)
 */

namespace seiche
{
  /// One number a lane, as many as the registers hold. Works in deal.II's
  /// tensors.
  using Lanes = std::experimental::native_simd<double>;

  inline constexpr unsigned int n_lanes_of_register = Lanes::size();

  /// The number(s) that start at @p values.
  template <typename Number>
  Number
  load(const double *values)
  {
    if constexpr (std::is_same_v<Number, Lanes>)
      return Lanes(values, std::experimental::element_aligned);
    else
      return *values;
  }

  /// The nodal values of a cell at once: n numbers that lie side by side.
  template <unsigned int n>
  using Row =
    std::experimental::simd<double,
                            std::experimental::simd_abi::deduce_t<double, n>>;

  template <unsigned int n>
  Row<n>
  load_row(const double (&values)[n])
  {
    return Row<n>(values, std::experimental::element_aligned);
  }

  template <unsigned int n>
  void
  store_row(const Row<n> &row, double (&values)[n])
  {
    row.copy_to(values, std::experimental::element_aligned);
  }

  /// The numbers of the lanes, to be read one by one.
  struct LaneValues
  {
    alignas(64) double values[n_lanes_of_register];

    explicit LaneValues(const Lanes &lanes)
    {
      lanes.copy_to(values, std::experimental::element_aligned);
    }

    double
    operator[](const unsigned int lane) const
    {
      return values[lane];
    }
  };

  /// Nodal values of the points of the lanes, point by point.
  template <unsigned int n_nodes>
  struct PointRows
  {
    alignas(64) double values[n_lanes_of_register][n_nodes];

    explicit PointRows(const Lanes (&lanes)[n_nodes])
    {
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int q = 0; q < n_lanes_of_register; ++q)
          values[q][a] = lanes[a][q];
    }

    Row<n_nodes>
    row(const unsigned int point) const
    {
      return load_row(values[point]);
    }
  };

  template <int dim, unsigned int n_nodes>
  std::array<PointRows<n_nodes>, dim>
  rows_of(const Lanes (&lanes)[dim][n_nodes])
  {
    using Rows = PointRows<n_nodes>;
    if constexpr (dim == 2)
      return {{Rows(lanes[0]), Rows(lanes[1])}};
    else
      return {{Rows(lanes[0]), Rows(lanes[1]), Rows(lanes[2])}};
  }

  /// Sum over the lanes.
  inline double
  sum(const Lanes &values)
  {
    return std::experimental::reduce(values);
  }
} // namespace seiche

namespace dealii
{
  template <>
  struct EnableIfScalar<seiche::Lanes>
  {
    using type = seiche::Lanes;
  };
} // namespace dealii

#endif
