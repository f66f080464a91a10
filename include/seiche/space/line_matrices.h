// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_line_matrices_h
#define seiche_space_line_matrices_h

namespace seiche
{
  /// int N_a N_b over a line of unit length, by degree - 1.
  inline constexpr double line_mass[2][3][3] = {
    {{1. / 3., 1. / 6.}, {1. / 6., 1. / 3.}},
    {{4. / 30., 2. / 30., -1. / 30.},
     {2. / 30., 16. / 30., 2. / 30.},
     {-1. / 30., 2. / 30., 4. / 30.}}};

  /// int N_a' N_b' over it.
  inline constexpr double line_stiffness[2][3][3] = {
    {{1., -1.}, {-1., 1.}},
    {{7. / 3., -8. / 3., 1. / 3.},
     {-8. / 3., 16. / 3., -8. / 3.},
     {1. / 3., -8. / 3., 7. / 3.}}};
} // namespace seiche

#endif
