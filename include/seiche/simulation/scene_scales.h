// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_scene_scales_h
#define seiche_simulation_scene_scales_h

#include <seiche/points/point_cloud.h>
#include <seiche/scene/body_force.h>

#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief Scales of a scene at its start, by which slips of units show: depth
   * H of the fluid, gravity g, sqrt(g H), rho g H, Froude and Reynolds numbers,
   * cells that a step crosses.
   */
  class SceneScales
  {
  public:
    /// Depth, body force and speeds of the points. @p half_spacing: of the
    /// points [m]. Collective.
    template <int dim>
    SceneScales(const PointCloud<dim> &points,
                const BodyForce<dim>  &body_force,
                const double           half_spacing);

    double density   = 0.;   ///< [kg/m^3]
    double viscosity = 0.;   ///< [Pa s]
    double modulus   = 0.;   ///< kappa of the irreducible form, else 0 [Pa]
    double step      = 0.;   ///< [s]
    bool   is_fixed  = true; ///< or the largest step
    double walls     = 0.;   ///< largest_wall_speed() [m/s]

    /// One line. Local.
    std::string
    text() const;

    /// What is hardly meant: gravity upwards, speeds above 20 sqrt(g H), sound
    /// that crosses more than 10 cells in a step of the irreducible form.
    /// Local.
    std::vector<std::string>
    doubts() const;

    /// True if a point moves by no more in a step than what is lost in the
    /// round-off of a volume. Local.
    bool
    step_is_round_off() const;

    /// A step in which the fastest point or wave crosses half a cell [s].
    /// Local.
    double
    ordinary_step() const;

    /// The step asked for, or if it is smaller that in which the fastest point
    /// or wave crosses a cell [s]. Local.
    double
    expected_step() const;

  private:
    double
    wave_speed() const;

    /// Of the fluid at the start, of waves and of walls [m/s].
    double
    fastest() const;

    /// Cells that sound crosses in a step, and what may help; empty if they
    /// are few.
    std::string
    doubt_of_sound() const;

    double depth         = 0.; ///< H [m]
    double gravity       = 0.; ///< g [m/s^2]
    double upwards       = 0.; ///< vertical part of the body force [m/s^2]
    double speed         = 0.; ///< of the fastest point [m/s]
    double smallest_cell = 0.; ///< edge [m]
  };
} // namespace seiche

#endif
