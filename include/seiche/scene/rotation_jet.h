// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_rotation_jet_h
#define seiche_scene_rotation_jet_h

#include <seiche/utilities/moment.h>

#include <deal.II/base/tensor.h>

#include <array>

namespace seiche
{
  /// A function of time and its first two derivatives.
  struct MotionJet
  {
    double value = 0., first = 0., second = 0.;
  };

  /// A matrix that depends on time and its first two derivatives.
  template <int dim>
  struct MatrixJet
  {
    dealii::Tensor<2, dim> value, first, second;
  };

  /// The turn by angles about the axes of space, one after the other: in 2D
  /// about z, in 3D about x, y, z.
  template <int dim>
  MatrixJet<dim>
  rotation_jet(const std::array<MotionJet, n_rotations<dim>> &angles);

  /// Those of a rotation, the second within a quarter turn, the others within a
  /// half: inverse of rotation_jet().
  template <int dim>
  std::array<double, n_rotations<dim>>
  angles_of(const dealii::Tensor<2, dim> &rotation);

  /// Of a skew tensor: its vector in 3D, E v = vector x v; its number in 2D.
  template <int dim>
  std::array<double, n_rotations<dim>>
  axial(const dealii::Tensor<2, dim> &skew);
} // namespace seiche

#endif
