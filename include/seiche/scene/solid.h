// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_solid_h
#define seiche_scene_solid_h

#include <seiche/scene/mooring.h>
#include <seiche/scene/rigid_motion.h>
#include <seiche/scene/shape_parameters.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief A wall of any shape, whose surface cuts through cells, as it lies at
   * some time.
   */
  template <int dim>
  struct Solid
  {
    std::string      name;
    SharedShape<dim> shape;               ///< where there is no fluid
    double           friction    = 0.;    ///< c_f [-]
    bool             may_be_left = false; ///< unilateral: by the fluid
    /// Of Navier's law, zero if the fluid sticks, infinite if it slips [m].
    double slip_length = std::numeric_limits<double>::infinity();

    /// Of a free one from others and from walls, at which it is stopped; zero:
    /// as small as the cells allow [m].
    double stop_distance = 0.;
    double restitution   = 0.; ///< rate after over before a stop [-]

    std::vector<Mooring<dim>> moorings; ///< of a free one

    std::shared_ptr<RigidMotion<dim>> motion; ///< null: at rest
    SharedShape<dim>                  shape_at_start;
    double                            time = 0.; ///< of the place [s]

    /// True if the fluid moves it.
    bool
    is_free() const
    {
      return motion != nullptr && motion->body() != nullptr;
    }

    /// The solid at another time of the run [s].
    Solid
    at(const double other_time) const;

    /// The way of its places in a step of size @p dt [s], as of way_between().
    RigidWay<dim>
    way(const double dt, const double theta) const;

    /// Velocities, as ways in a second.
    RigidWay<dim>
    velocity() const;
  };

  /// What the wall of a solid does to the fluid in a step.
  template <int dim>
  struct SolidInStep
  {
    RigidWay<dim> way; ///< of its places [m]
    double        friction    = 0.;
    double        slip_length = std::numeric_limits<double>::infinity();
    bool          may_be_left = false; ///< by the fluid
  };

  /// Tie solids down. InputError for what holds none.
  template <int dim>
  void
  add_moorings(const std::vector<MooringParameters<dim>> &moorings,
               const InputFile                           &input,
               std::vector<Solid<dim>>                   &solids);

  /// True if one of them moves.
  template <int dim>
  bool
  any_moves(const std::vector<Solid<dim>> &solids);

  /// True if the fluid may leave one of them.
  template <int dim>
  bool
  any_may_be_left(const std::vector<Solid<dim>> &solids);

  /// True if the fluid moves one of them.
  template <int dim>
  bool
  any_is_free(const std::vector<Solid<dim>> &solids);

  /// The most that a place of the box @p domain moves with one of the solids
  /// in a step of size @p dt [m].
  template <int dim>
  double
  largest_way(const std::vector<Solid<dim>>  &solids,
              const dealii::BoundingBox<dim> &domain,
              const double                    dt);

  /// The solid that a place is nearest to, or farthest in; null without any.
  template <int dim>
  const Solid<dim> *
  nearest_solid(const std::vector<Solid<dim>> &solids,
                const dealii::Point<dim>      &x);

  /// Distance from the nearest one [m], negative in it; infinite without any.
  template <int dim>
  double
  distance_from(const std::vector<Solid<dim>> &solids,
                const dealii::Point<dim>      &x);

  /// prm entries of "Solid NAME".
  template <int dim>
  struct SolidParameters
  {
    static constexpr const char *kind = "Solid";

    explicit SolidParameters(const std::string &solid_name)
      : name(solid_name)
      , shape(std::string(kind) + " " + solid_name)
    {
      motion.names           = {"Motion displacement",
                                "Motion rotation",
                                "Motion centre"};
      motion.body.what       = "solid";
      motion.body.section    = section();
      motion.body.centre     = motion.names.centre;
      motion.body.may_tumble = true;
      motion.body.of_weight  = "; its weight by Body force is added";
    }

    std::string                name;
    ShapeParameters<dim>       shape;
    std::string                side          = "outside";
    std::string                condition     = "slip";
    double                     slip_length   = 0.; // [m]
    double                     friction      = 0.;
    double                     stop_distance = 0.; // [m]
    double                     restitution   = 0.;
    RigidMotionParameters<dim> motion;

    std::string
    section() const
    {
      return std::string(kind) + " " + name;
    }

    /// Enters the subsection.
    void
    add_parameters(dealii::ParameterHandler &prm);

    void
    check(const InputFile &input) const;
  };

  /// InputError with place for what makes no sense. @p domain and @p named as
  /// of ShapeParameters::make(), @p end_time and @p step as of RigidMotion; @p
  /// input must outlive the solids.
  template <int dim>
  std::vector<Solid<dim>>
  make_solids(const std::vector<SolidParameters<dim>> &solids,
              const InputFile                         &input,
              const dealii::BoundingBox<dim>          &domain,
              const std::vector<ShapeParameters<dim>> &named,
              const double                             end_time,
              const double                             step);
} // namespace seiche

#endif
