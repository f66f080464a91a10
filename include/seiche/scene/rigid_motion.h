// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_rigid_motion_h
#define seiche_scene_rigid_motion_h

#include <seiche/scene/free_body.h>
#include <seiche/shapes/composed_shapes.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /// prm entries of a motion that is given or free.
  template <int dim>
  struct RigidMotionParameters
  {
    /// Of what is in a subsection of its own, or beside others' entries.
    struct Names
    {
      std::string displacement = "Displacement", rotation = "Rotation",
                  centre = "Centre";
    };
    Names names;

    std::string             displacement; // expressions [m], or empty
    std::string             rotation;     // expressions [rad], or empty
    std::string             centre = (dim == 2 ? "0, 0" : "0, 0, 0"); // [m]
    FreeBodyParameters<dim> body;

    /// What the manual says @p of_displacement.
    void
    add_parameters(dealii::ParameterHandler &prm,
                   const std::string        &of_displacement);

    /// Entries without effect and what cannot be; RigidMotion looks at the
    /// others.
    void
    check(const InputFile &input) const;

    bool
    any() const
    {
      return !displacement.empty() || !rotation.empty() || body.any();
    }

    bool
    turns() const
    {
      return !rotation.empty() || body.turns();
    }
  };

  /// The way of places of a rigid body: shift + turn y, y where they are.
  template <int dim>
  struct RigidWay
  {
    dealii::Tensor<1, dim> shift;
    dealii::Tensor<2, dim> turn;

    /// [m]
    dealii::Tensor<1, dim>
    at(const dealii::Point<dim> &y) const
    {
      return shift + turn * dealii::Tensor<1, dim>(y);
    }

    RigidWay &
    operator*=(const double factor)
    {
      shift *= factor;
      turn *= factor;
      return *this;
    }
  };

  /// From one placement to another one; y lies at the share @p theta of the
  /// straight way between both.
  template <int dim>
  RigidWay<dim>
  way_between(const Placement<dim> &start,
              const Placement<dim> &end,
              const double          theta);
  /**
   * @brief A motion that is given, or that of a free body beside it: X = c + d +
   * R (x - c) takes a place x of the start to time t, c the centre
   * (doc/theory.md (8.5)).
   */
  template <int dim>
  class RigidMotion
  {
  public:
    /// Something as large as @p domain moves until @p end_time [s] in steps of
    /// at most @p step [s]. InputError for what is no expression of t, jumps,
    /// or ends before. @p input must outlive the object.
    RigidMotion(const RigidMotionParameters<dim> &parameters,
                const InputFile                  &input,
                const dealii::BoundingBox<dim>   &domain,
                const double                      end_time,
                const double                      step);

    bool
    any() const
    {
      return displacement || rotation || free_body;
    }

    /// What the fluid moves; null if there is only the motion that is given.
    const FreeBody<dim> *
    body() const
    {
      return free_body.get();
    }

    /// The same, to be moved: all else follows.
    FreeBody<dim> &
    body_to_move()
    {
      return *free_body;
    }

    /// In a direction of BodyDirection at a time of the run [s]; angles of a
    /// body that tumbles are those since the start of the step.
    MotionJet
    jet(const unsigned int direction, const double time) const;

    /// Displacement [m] or angle [rad] since the start of the run.
    double
    place(const unsigned int direction, const double time) const;

    /// Of a free body: rate at which its momentum grows along a freedom in the
    /// step of which @p middle [s] is the middle [N, N m].
    double
    momentum_rate(const unsigned int freedom, const double middle) const;

    /// At a time of the run [s].
    Placement<dim>
    at(const double time) const;

    /// Velocities at a time of the run, as ways in a second.
    RigidWay<dim>
    velocity(const double time) const;

    const dealii::Point<dim> centre;   ///< [m]
    const double             end_time; ///< [s]

  private:
    /// What moves in a direction; not given: null.
    const Expression<dim> *
    expression(const unsigned int direction) const;
    MatrixJet<dim>
    rotation_at(const double time) const;

    std::optional<Expression<dim>> displacement, rotation;
    std::unique_ptr<FreeBody<dim>> free_body;
    const double                   spacing; // of differences in time [s]
  };
} // namespace seiche

#endif
