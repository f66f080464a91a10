// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_scene_scales_h
#define seiche_simulation_scene_scales_h

#include <seiche/scene/scene_map.h>
#include <seiche/simulation/scene.h>

#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief Scales of a scene at its start, by which slips of units show: mass
   * and depth H of the fluid, gravity g, sqrt(g H), rho g H, Froude and
   * Reynolds numbers, cells that a step crosses.
   */
  class SceneScales
  {
  public:
    /// Of nothing.
    SceneScales() = default;

    /// InputError where the body force or a velocity is no number in the
    /// fluid. @p finest_edge: of the cells [m]. Local.
    template <int dim>
    SceneScales(const Scene<dim>                    &scene,
                const std::vector<FluidBody<dim>>   &bodies,
                const std::vector<SampledBody<dim>> &samples,
                const BodyForce<dim>                &body_force,
                const double                         finest_edge);

    double speed = 0.; ///< of the fastest point [m/s]
    double walls = 0.; ///< largest_wall_speed() [m/s]

    /// One line. Local.
    std::string
    text() const;

    /// What is hardly meant: gravity upwards or (3D) to a side, angles of the
    /// tank in degrees, tracked points outside of the fluid, a bulk modulus
    /// below 5 rho g H, speeds above 20 sqrt(g H), steps in which nothing
    /// moves, sound that crosses more than 10 cells in a step of the
    /// irreducible form. Local.
    std::vector<std::string>
    doubts() const;

    /// True if the fluid moves so little in a step that round-off is all that
    /// is left: of the volumes, or of the strains of a very viscous fluid.
    /// Local.
    bool
    step_is_round_off() const;

    /// Where step_is_round_off(): the entry that ends it, "Time/Step = 3".
    /// Local.
    std::string
    entry_for_motion() const;

    /// The step asked for, or if it is smaller that in which the fastest point
    /// or wave crosses a cell [s]. Local.
    double
    expected_step() const;

  private:
    /// Mass, extent, force and speed of the bodies at the start.
    template <int dim>
    void
    measure_fluid(const Scene<dim>                    &scene,
                  const std::vector<FluidBody<dim>>   &bodies,
                  const std::vector<SampledBody<dim>> &samples,
                  const BodyForce<dim>                &body_force);

    template <int dim>
    void
    note_thickness(const FluidBody<dim> &body);

    double
    wave_speed() const;

    /// rho g of this height of fluid [Pa].
    double
    pressure_under(const double height) const;

    /// Of the fluid at the start, of waves and of walls [m/s].
    double
    fastest() const;

    /// rho g H^2 / mu, at which a viscous fluid creeps [m/s].
    double
    creep_speed() const;

    /// Cells that the fluid goes in a step of this size [s], at most.
    double
    cells_in(const double time) const;

    /// Cells that sound crosses in a step, and what may help; empty if they
    /// are few.
    std::string
    doubt_of_sound() const;

    FluidProperties fluid;                  ///< largest of the materials
    double          modulus         = 0.;   ///< kappa [Pa], infinity allowed
    bool            is_mixed        = true; ///< or the irreducible form
    double          step            = 0.;   ///< [s]
    bool            is_fixed        = true; ///< or the largest step
    double          end_time        = 0.;   ///< [s]
    double          smallest_cell   = 0.;   ///< edge [m]
    double          smallest_height = 0.;   ///< smallest vertical edge [m]

    double mass           = 0.; ///< [kg]
    bool   mass_is_exact  = true;
    double depth          = 0.; ///< H [m]
    bool   depth_is_exact = true;
    double tallest_body   = 0.; ///< height [m]
    double gravity        = 0.; ///< g, root mean square over the fluid [m/s^2]
    double upwards        = 0.; ///< mean vertical part of the force [m/s^2]
    double sideways       = 0.; ///< the same, horizontal, between walls
    double turn           = 0.; ///< largest angle of the tank [rad]
    double thinnest =
      std::numeric_limits<double>::infinity(); ///< part of a body [m]
    std::string              thinnest_place;   ///< body and coordinates
    std::vector<std::string> lost_tracks;      ///< tracked points without fluid
  };
} // namespace seiche

#endif
