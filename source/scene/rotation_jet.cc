// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/rotation_jet.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

// Turns about the axes of space and their derivatives.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    MatrixJet<dim>
    operator*(const MatrixJet<dim> &a, const MatrixJet<dim> &b)
    {
      return {a.value * b.value,
              a.first * b.value + a.value * b.first,
              a.second * b.value + 2. * (a.first * b.first) +
                a.value * b.second};
    }

    /// Turn by an angle about the axis (in 2D about z): I + sin E + (1 - cos)
    /// E^2 with E v = axis x v (Rodrigues).
    template <int dim>
    MatrixJet<dim>
    turn(const unsigned int axis, const MotionJet &angle)
    {
      const unsigned int i = dim == 2 ? 0 : (axis + 1) % dim,
                         j = dim == 2 ? 1 : (axis + 2) % dim;
      Tensor<2, dim> E;
      E[j][i]                     = 1.;
      E[i][j]                     = -1.;
      const Tensor<2, dim> square = E * E;
      const double         s = std::sin(angle.value), c = std::cos(angle.value);
      MatrixJet<dim>       result;
      // 1 - cos without cancellation
      result.value = unit_symmetric_tensor<dim>();
      result.value +=
        s * E + 2. * std::pow(std::sin(0.5 * angle.value), 2) * square;
      const Tensor<2, dim> slope     = c * E + s * square,
                           curvature = c * square - s * E;
      result.first                   = angle.first * slope;
      result.second =
        angle.second * slope + angle.first * angle.first * curvature;
      return result;
    }
  } // namespace

  template <int dim>
  MatrixJet<dim>
  rotation_jet(const std::array<MotionJet, n_rotations<dim>> &angles)
  {
    MatrixJet<dim> R;
    R.value = unit_symmetric_tensor<dim>();
    for (unsigned int a = 0; a < angles.size(); ++a)
      R = turn<dim>(a, angles[a]) * R;
    return R;
  }

  template <int dim>
  std::array<double, n_rotations<dim>>
  angles_of(const Tensor<2, dim> &R)
  {
    if constexpr (dim == 2)
      return {{std::atan2(R[1][0], R[0][0])}};
    else // R = R_z R_y R_x
      return {{std::atan2(R[2][1], R[2][2]),
               -std::asin(std::clamp(R[2][0], -1., 1.)),
               std::atan2(R[1][0], R[0][0])}};
  }

  template <int dim>
  std::array<double, n_rotations<dim>>
  axial(const Tensor<2, dim> &skew)
  {
    if constexpr (dim == 2)
      return {{skew[1][0]}};
    else
      return {{skew[2][1], skew[0][2], skew[1][0]}};
  }

  template MatrixJet<2>
  rotation_jet<2>(const std::array<MotionJet, n_rotations<2>> &);
  template MatrixJet<3>
  rotation_jet<3>(const std::array<MotionJet, n_rotations<3>> &);
  template std::array<double, 1>
  angles_of<2>(const Tensor<2, 2> &);
  template std::array<double, 3>
  angles_of<3>(const Tensor<2, 3> &);
  template std::array<double, 1>
  axial<2>(const Tensor<2, 2> &);
  template std::array<double, 3>
  axial<3>(const Tensor<2, 3> &);
} // namespace seiche
