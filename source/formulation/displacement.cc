// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/body_force_term.h>
#include <seiche/formulation/bulk_pressure_term.h>
#include <seiche/formulation/formulation.h>
#include <seiche/formulation/ghost_terms.h>
#include <seiche/formulation/inertia_term.h>
#include <seiche/formulation/point_inertia_term.h>
#include <seiche/formulation/term_list.h>
#include <seiche/formulation/viscous_term.h>

namespace seiche
{
  template <int dim>
  Formulation<dim>
  make_displacement(const FormulationParameters &parameters,
                    const FreeSurfaceParameters &free_surface,
                    const VolumeLaw             &volume_law,
                    const VolumeFactors         &factors)
  {
    Formulation<dim> result;
    result.volume_law    = volume_law;
    result.lumps_inertia = parameters.lumps_inertia();

    const auto form = [&](const auto &...more) {
      return make_weak_form<dim>(InertiaTerm(),
                                 BodyForceTerm(),
                                 ViscousTerm(),
                                 BulkPressureTerm(volume_law,
                                                  factors.elastic_time),
                                 PointInertiaTerm(free_surface.point_inertia),
                                 GhostAccelerationTerm(free_surface),
                                 more...);
    };
    result.step             = form(GhostVelocityTerm(free_surface));
    result.consistent_start = form();
    return result;
  }

#define INSTANTIATE(dim)                                                     \
  template Formulation<dim> make_displacement(const FormulationParameters &, \
                                              const FreeSurfaceParameters &, \
                                              const VolumeLaw &,             \
                                              const VolumeFactors &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
