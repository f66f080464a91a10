// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_shifting_h
#define seiche_grid_shifting_h

#include <seiche/grid/fill.h>

namespace seiche
{
  /**
   * @brief Moves points from where they crowd to where they are few.
   *
   * Fickian shifting (Lind, Xu, Stansby and Rogers 2012; doc/theory.md (5.3))
   * with the fill over that of the surface's inside as the concentration: in
   * the coordinates of the cell delta_d = -C s (df/dxi_d + 0.2 dc/dxi_d), f the
   * difference of the nodal fills with the functions of FE_Q(1), c that of the
   * cells' fills with differences to the face neighbours that are linear
   * between opposite faces, s = 1 away from the free surface and 0 on it. The
   * first term is a step of steepest descent for sum_I V_I f_I^2, the error of
   * the points as a quadrature. It does not see full and empty cells that
   * alternate: f is zero everywhere. The second term does; it has a small share
   * because c jumps whenever a row of points crosses a face. A sweep multiplies
   * the shortest waves by 1 - 4 C (of f) and 1 - 0.8 dim C (of c): stable for C
   * <= 0.3.
   *
   * The velocity follows by Taylor, v + C_p delta with the gradient that the
   * point carries, so that a linear field stays what it is.
   */
  template <int dim>
  class Shifting
  {
  public:
    /// @p strength: C. @p grid_fill must outlive the object.
    Shifting(const Fill<dim> &grid_fill, const double strength);

    /// Move the points; Fill and the points' cells must be up to date, and are
    /// not afterwards. No point moves by more than a quarter of its cell in a
    /// direction, or through a wall. Collective.
    void
    sweep(PointCloud<dim> &points);

  private:
    const Fill<dim>      &fill;
    const Occupancy<dim> &occupancy;
    const double          strength;
    std::vector<double>   excess; ///< c of own and ghost cells
  };
} // namespace seiche

#endif
