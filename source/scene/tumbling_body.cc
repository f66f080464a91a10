// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/free_body.h>

// The part of FreeBody that turns about all axes of space (doc/theory.md
// (8.12)).
namespace seiche
{
  using namespace dealii;

  template <int dim>
  MatrixJet<dim>
  FreeBody<dim>::turn_until(const double time) const
  {
    std::array<MotionJet, n_rotations<dim>> angles;
    for (unsigned int a = 0; a < angles.size(); ++a)
      angles[a] = jet(dim + a, time);
    return rotation_jet<dim>(angles);
  }

  template <int dim>
  Tensor<1, dim>
  FreeBody<dim>::angular_momentum(const Tensor<2, dim> &R,
                                  const Tensor<1, dim> &w) const
  {
    Tensor<1, dim> of_body = transpose(R) * w;
    for (unsigned int i = 0; i < list.size(); ++i)
      if (list[i].direction.is_angle())
        of_body[list[i].direction.axis()] *= inertia(i);
    return R * of_body;
  }

  template <int dim>
  std::array<double, n_rotations<dim>>
  FreeBody<dim>::angular_momentum_rate() const
  {
    std::array<double, n_rotations<dim>> result{};
    if constexpr (dim == 3)
      {
        const MatrixJet<dim> turn = turn_until(start + size);
        const auto     end_w = axial<dim>(turn.first * transpose(turn.value));
        Tensor<1, dim> w_before, w_after;
        for (const Freedom &freedom : list)
          if (freedom.direction.is_angle())
            w_before[freedom.direction.axis()] = freedom.rate;
        for (unsigned int a = 0; a < dim; ++a)
          w_after[a] = end_w[a];
        const Tensor<1, dim> gain =
          angular_momentum(turn.value * turned, w_after) -
          angular_momentum(turned, w_before);
        for (unsigned int a = 0; a < dim; ++a)
          result[a] = gain[a] / size;
      }
    return result;
  }

  template <int dim>
  void
  FreeBody<dim>::set_turn(const Tensor<2, dim>                       &R,
                          const std::array<double, n_rotations<dim>> &w)
  {
    turned            = R;
    const auto angles = angles_of<dim>(R);
    for (Freedom &freedom : list)
      if (freedom.direction.is_angle())
        {
          freedom.place = angles[freedom.direction.number - dim];
          freedom.rate  = w[freedom.direction.number - dim];
        }
  }

#define INSTANTIATE(dim)                                                 \
  template MatrixJet<dim> FreeBody<dim>::turn_until(const double) const; \
  template Tensor<1, dim> FreeBody<dim>::angular_momentum(               \
    const Tensor<2, dim> &, const Tensor<1, dim> &) const;               \
  template std::array<double, n_rotations<dim>>                          \
                FreeBody<dim>::angular_momentum_rate() const;            \
  template void FreeBody<dim>::set_turn(                                 \
    const Tensor<2, dim> &, const std::array<double, n_rotations<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
