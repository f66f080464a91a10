// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_tank_body_h
#define seiche_scene_tank_body_h

#include <seiche/scene/expression.h>

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class StateArchive;

  /// A function of time and its first two derivatives.
  struct MotionJet
  {
    double value = 0., first = 0., second = 0.;
  };

  /// A way in which a tank may move: along a direction of space [m] or by an
  /// angle [rad]; a force is one [N] or a moment [N m], an inertia a mass [kg]
  /// or a moment of inertia [kg m^2], in 2D per metre.
  template <int dim>
  struct TankDirection
  {
    static constexpr unsigned int n_angles = (dim == 2 ? 1 : 3);
    static constexpr unsigned int n_all    = dim + n_angles;

    unsigned int number; ///< the coordinates, then the angles

    bool
    is_angle() const
    {
      return number >= dim;
    }

    /// Coordinate along which it moves or about which it turns.
    unsigned int
    axis() const
    {
      return is_angle() ? number - dim + (dim == 2 ? 2 : 0) : number;
    }

    /// x, y[, z]; rotation in 2D, roll, pitch, yaw in 3D.
    const char *
    name() const;

    /// Columns of results: its rate, and what the fluid does to it.
    std::array<std::string, 2>
    columns() const;
  };

  /// The entries of "Tank motion" about a tank that the fluid moves.
  template <int dim>
  struct TankBodyParameters
  {
    std::string free, inertia, load, start, start_rate;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Entries without effect; TankBody looks at the others.
    void
    check(const InputFile &input) const;

    bool
    any() const
    {
      return !free.empty();
    }

    bool
    turns() const;

    /// InputError for what is none, or named twice.
    std::vector<TankDirection<dim>>
    directions(const InputFile &input) const;
  };

  /**
   * @brief A tank that is free to move in some directions, beside what motion
   * is given: in each the inertia times the acceleration is the load (springs,
   * dampers, weight) and what the fluid does (doc/theory.md (8.8)).
   *
   * The acceleration is constant within a step; the load is that of the step's
   * mean place and rate.
   */
  template <int dim>
  class TankBody
  {
  public:
    /// @p input must outlive the object. InputError for entries that make no
    /// body up to @p end_time [s].
    TankBody(const TankBodyParameters<dim> &parameters,
             const InputFile               &input,
             const double                   end_time);

    /// One free direction; columns of results have its numbers.
    struct Freedom
    {
      TankDirection<dim> direction{0};
      double             place = 0., rate = 0.;            ///< at t_n
      double             acceleration = 0., previous = 0.; ///< in steps
      double             fluid = 0.; ///< force or moment of the fluid
    };

    const std::vector<Freedom> &
    freedoms() const
    {
      return list;
    }

    /// How it moves beside the given motion; at the end of the step beyond it.
    MotionJet
    jet(const unsigned int direction, const double time) const;

    /// An attempt at the step from @p time of size @p step [s].
    void
    begin(const double time, const double step);

    /// The acceleration within this step.
    void
    set_acceleration(const unsigned int freedom, const double acceleration);

    /// Inertia and load in the middle of the step.
    double
    inertia(const unsigned int freedom) const;
    double
    load(const unsigned int freedom) const;

    void
    set_fluid_load(const unsigned int freedom, const double force)
    {
      list[freedom].fluid = force;
    }

    /// The step is done.
    void
    accept();

    /// Changes with all that jet() depends on.
    unsigned int
    version() const
    {
      return changes;
    }

    void
    save_or_load(StateArchive &archive);

  private:
    std::vector<Freedom> list;
    Expression<dim>      inertias, loads;
    double               start = 0., size = 0.; ///< of the step [s]
    unsigned int         changes = 0;
  };
} // namespace seiche

#endif
