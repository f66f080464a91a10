// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_free_body_h
#define seiche_scene_free_body_h

#include <seiche/scene/expression.h>
#include <seiche/scene/rotation_jet.h>

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

  /// A way in which a body may move: along a direction of space [m] or by an
  /// angle [rad]; a force is one [N] or a moment [N m], an inertia a mass [kg]
  /// or a moment of inertia [kg m^2], in 2D per metre.
  template <int dim>
  struct BodyDirection
  {
    static constexpr unsigned int n_all = dim + n_rotations<dim>;

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

    /// Columns of results: the displacement or angle of a body,
    std::string
    column_of_place(const std::string &body) const;

    /// its rate, and what the fluid does to the body,
    std::array<std::string, 2>
    columns(const std::string &body) const;

    /// what stops do.
    std::string
    column_of_stop(const std::string &body) const;
  };

  /// prm entries of a body that the fluid moves: the tank, a solid.
  template <int dim>
  struct FreeBodyParameters
  {
    std::string what       = "tank";        ///< as the manual calls it
    std::string section    = "Tank motion"; ///< of the entries
    std::string centre     = "Centre";      ///< entry: about what it turns
    std::string of_weight  = ", weight";    ///< among the loads, if it is one
    bool        may_tumble = false;         ///< turn about all axes
    std::string free, inertia, load, start, start_rate;

    void
    add_parameters(dealii::ParameterHandler &prm);

    std::string
    path(const std::string &entry) const
    {
      return section + "/" + entry;
    }

    /// Entries without effect; FreeBody looks at the others.
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
    std::vector<BodyDirection<dim>>
    directions(const InputFile &input) const;
  };

  /**
   * @brief A tank or solid that is free to move in some directions, beside what
   * motion is given: in each the inertia times the acceleration is the load
   * (springs, dampers, weight) and what the fluid does (doc/theory.md (8.8)).
   *
   * The acceleration is constant within a step; the load is that of the step's
   * mean place and rate. A body that turns about all axes of space tumbles: its
   * angles are those since the start of a step, about the axes of space, and
   * its angular momentum L = R J R^T w grows by the moments, J its inertia at
   * the start of the run, R how it has turned since.
   */
  template <int dim>
  class FreeBody
  {
  public:
    /// @p input must outlive the object. InputError for entries that make no
    /// body up to @p end_time [s].
    FreeBody(const FreeBodyParameters<dim> &parameters,
             const InputFile               &input,
             const double                   end_time);

    /// One free direction; columns of results have its numbers.
    struct Freedom
    {
      BodyDirection<dim> direction{0};
      double             place = 0., rate = 0.; ///< at t_n; of
                                                ///< one that tumbles
                                                ///< w_i
      double acceleration = 0., previous = 0.;  ///< in steps
      double fluid = 0.; ///< force or moment of the fluid
      double stop  = 0.; ///< of stops
    };

    const std::vector<Freedom> &
    freedoms() const
    {
      return list;
    }

    /// True if it turns about all axes of space.
    bool
    tumbles() const
    {
      return is_tumbling;
    }

    /// How it has turned until the step, if it tumbles.
    const dealii::Tensor<2, dim> &
    orientation() const
    {
      return turned;
    }

    /// How it moves beside the given motion; at the end of the step beyond it.
    /// Angles of a body that tumbles start in each step.
    MotionJet
    jet(const unsigned int direction, const double time) const;

    /// An attempt at the step from @p time of size @p step [s].
    void
    begin(const double time, const double step);

    /// The acceleration within this step.
    void
    set_acceleration(const unsigned int freedom, const double acceleration);

    /// Of one that tumbles: what its angular momentum gains in a second of the
    /// step, by axes of space [N m].
    std::array<double, n_rotations<dim>>
    angular_momentum_rate() const;

    /// Inertia and load in the middle of the step.
    double
    inertia(const unsigned int freedom) const;
    double
    load(const unsigned int freedom) const;

    void
    set_loads(const unsigned int freedom, const double fluid, const double stop)
    {
      list[freedom].fluid = fluid;
      list[freedom].stop  = stop;
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
    bool
    restarts_in_steps(const Freedom &freedom) const
    {
      return is_tumbling && freedom.direction.is_angle();
    }

    /// How it turns in the step until a time, by jet().
    MatrixJet<dim>
    turn_until(const double time) const;

    /// R J R^T w, by axes of space [N m s].
    dealii::Tensor<1, dim>
    angular_momentum(const dealii::Tensor<2, dim> &R,
                     const dealii::Tensor<1, dim> &w) const;

    /// Angles and rates for how it has turned, and w.
    void
    set_turn(const dealii::Tensor<2, dim>               &R,
             const std::array<double, n_rotations<dim>> &w);

    std::vector<Freedom>   list;
    Expression<dim>        inertias, loads;
    bool                   is_tumbling = false;
    dealii::Tensor<2, dim> turned;                ///< until t_n
    double                 start = 0., size = 0.; ///< of the step [s]
    unsigned int           changes = 0;
  };
} // namespace seiche

#endif
