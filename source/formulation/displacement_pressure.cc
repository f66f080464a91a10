// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/body_force_term.h>
#include <seiche/formulation/formulation.h>
#include <seiche/formulation/ghost_terms.h>
#include <seiche/formulation/inertia_term.h>
#include <seiche/formulation/momentum_subscale_term.h>
#include <seiche/formulation/point_inertia_term.h>
#include <seiche/formulation/pressure_subscale_term.h>
#include <seiche/formulation/pressure_term.h>
#include <seiche/formulation/residual_moments_term.h>
#include <seiche/formulation/start_constraint_term.h>
#include <seiche/formulation/term_list.h>
#include <seiche/formulation/viscous_term.h>
#include <seiche/formulation/volume_constraint_term.h>
#include <seiche/formulation/wall_drag_term.h>
#include <seiche/formulation/wall_friction_term.h>
#include <seiche/formulation/wall_term.h>

namespace seiche
{
  namespace
  {
    /// What orthogonal subscales project.
    template <int dim>
    auto
    make_residual_moments(const StabilizationParameters &stabilization,
                          const VolumeConstraintTerm    &constraint)
    {
      return make_weak_form<dim>(Strong(InertiaTerm()),
                                 Strong(BodyForceTerm()),
                                 Strong(ViscousTerm()),
                                 Strong(PressureTerm()),
                                 Strong(constraint),
                                 ResidualMomentsTerm(
                                   stabilization.projects_lumped()));
    }
  } // namespace

  template <int dim>
  Formulation<dim>
  make_displacement_pressure(const FormulationParameters &parameters,
                             const FreeSurfaceParameters &free_surface,
                             const VolumeLaw             &volume_law,
                             const VolumeFactors         &factors)
  {
    Formulation<dim> result;
    result.volume_law    = volume_law;
    result.lumps_inertia = parameters.lumps_inertia();
    result.subscales =
      std::make_shared<const Stabilization>(parameters.stabilization);

    const InertiaTerm           inertia;
    const BodyForceTerm         body_force;
    const ViscousTerm           viscous;
    const PressureTerm          pressure;
    const VolumeConstraintTerm  constraint(volume_law, factors);
    const MomentumSubscaleTerm  momentum_subscale;
    const PressureSubscaleTerm  pressure_subscale(volume_law.bulk_modulus);
    const PointInertiaTerm      point_inertia(free_surface.point_inertia);
    const WallTerm              walls;
    const WallDragTerm          wall_drag;
    const WallFrictionTerm      wall_friction;
    const GhostAccelerationTerm ghost_acceleration(free_surface);
    const GhostPressureTerm     ghost_pressure(free_surface);

    result.step = make_weak_form<dim>(inertia,
                                      body_force,
                                      viscous,
                                      pressure,
                                      constraint,
                                      momentum_subscale,
                                      pressure_subscale,
                                      point_inertia,
                                      walls,
                                      wall_drag,
                                      wall_friction,
                                      ghost_acceleration,
                                      ghost_pressure,
                                      GhostVelocityTerm(free_surface));

    result.projection =
      make_weak_form<dim>(inertia,
                          pressure,
                          StartConstraintTerm(volume_law,
                                              factors.start_divergence),
                          momentum_subscale,
                          pressure_subscale,
                          point_inertia,
                          WallTerm(/*old_pressure_presses=*/true),
                          ghost_acceleration,
                          ghost_pressure);

    result.consistent_start =
      make_weak_form<dim>(inertia,
                          body_force,
                          viscous,
                          pressure,
                          StartConstraintTerm(volume_law, /*factor=*/1.),
                          momentum_subscale,
                          pressure_subscale,
                          point_inertia,
                          ghost_acceleration,
                          ghost_pressure);

    if (parameters.stabilization.is_orthogonal())
      result.residual_moments =
        make_residual_moments<dim>(parameters.stabilization, constraint);
    return result;
  }

#define INSTANTIATE(dim)                                \
  template Formulation<dim> make_displacement_pressure( \
    const FormulationParameters &,                      \
    const FreeSurfaceParameters &,                      \
    const VolumeLaw &,                                  \
    const VolumeFactors &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
