// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_dual_number_h
#define seiche_utilities_dual_number_h

#include <deal.II/base/template_constraints.h>

#include <array>
#include <cmath>

namespace seiche
{
  /**
   * @brief A number and its derivatives by n inputs: forward differentiation
   * for dealii::Tensor, whose products know no expression templates, as those
   * of Sacado are.
   */
  template <unsigned int n>
  struct DualNumber
  {
    double                value = 0.;
    std::array<double, n> slope{};

    DualNumber() = default;

    /// A constant.
    DualNumber(const double x)
      : value(x)
    {}

    /// The input of that number.
    DualNumber(const double x, const unsigned int input)
      : value(x)
    {
      slope[input] = 1.;
    }

    DualNumber &
    operator+=(const DualNumber &x)
    {
      value += x.value;
      for (unsigned int i = 0; i < n; ++i)
        slope[i] += x.slope[i];
      return *this;
    }

    DualNumber &
    operator-=(const DualNumber &x)
    {
      value -= x.value;
      for (unsigned int i = 0; i < n; ++i)
        slope[i] -= x.slope[i];
      return *this;
    }

    DualNumber &
    operator*=(const DualNumber &x)
    {
      for (unsigned int i = 0; i < n; ++i)
        slope[i] = slope[i] * x.value + value * x.slope[i];
      value *= x.value;
      return *this;
    }

    DualNumber &
    operator/=(const DualNumber &x)
    {
      value /= x.value;
      for (unsigned int i = 0; i < n; ++i)
        slope[i] = (slope[i] - value * x.slope[i]) / x.value;
      return *this;
    }

    friend DualNumber
    operator+(DualNumber x, const DualNumber &y)
    {
      return x += y;
    }
    friend DualNumber
    operator-(DualNumber x, const DualNumber &y)
    {
      return x -= y;
    }
    friend DualNumber
    operator*(DualNumber x, const DualNumber &y)
    {
      return x *= y;
    }
    friend DualNumber
    operator/(DualNumber x, const DualNumber &y)
    {
      return x /= y;
    }
    friend DualNumber
    operator-(const DualNumber &x)
    {
      return DualNumber() - x;
    }

    /// Of what is greater than zero.
    friend DualNumber
    sqrt(const DualNumber &x)
    {
      DualNumber result(std::sqrt(x.value));
      for (unsigned int i = 0; i < n; ++i)
        result.slope[i] = 0.5 * x.slope[i] / result.value;
      return result;
    }
  };
} // namespace seiche

namespace dealii
{
  template <unsigned int n>
  struct EnableIfScalar<seiche::DualNumber<n>>
  {
    using type = seiche::DualNumber<n>;
  };
} // namespace dealii

#endif
