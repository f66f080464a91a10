// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangent of every term, on its own, against central differences of its
// residual.
#include <seiche/formulation/body_force_term.h>
#include <seiche/formulation/bulk_pressure_term.h>
#include <seiche/formulation/inertia_term.h>
#include <seiche/formulation/momentum_subscale_term.h>
#include <seiche/formulation/point_inertia_term.h>
#include <seiche/formulation/pressure_subscale_term.h>
#include <seiche/formulation/pressure_term.h>
#include <seiche/formulation/start_constraint_term.h>
#include <seiche/formulation/term_list.h>
#include <seiche/formulation/volume_constraint_term.h>

#include <iostream>

#include "tangent_error.h"
#include "verdict.h"

namespace
{
  template <int dim, int degree>
  void
  test()
  {
    const VolumeLaw             law{/*bulk_modulus=*/50.};
    const InertiaTerm           inertia;
    const BodyForceTerm         body_force;
    const ViscousTerm           viscosity;
    const PressureTerm          pressure;
    const VolumeConstraintTerm  constraint(law, volume_factors());
    const Material              water = newtonian(0.7);
    const FormulationParameters parameters;
    const auto                  formulation = make_formulation<dim>(parameters,
                                                   FreeSurfaceParameters(),
                                                   law,
                                                   volume_factors());

    CellData<dim, degree> cell;
    const auto            prepare = [&](const double theta) {
      fill_cell(cell, water, theta, /*lumped=*/false);
      cell.extent_inertia = 0.02;
      formulation.set_subscales(cell);
    };
    const auto check = [&](const char          *name,
                           const WeakForm<dim> &term,
                           const bool           has_pressure) {
      std::cout << dim << "D Q" << degree << ' ' << name << ": "
                << verdict(tangent_error(term, has_pressure, cell) < 1e-6)
                << '\n';
    };
    const auto check_displacement = [&](const char *name, const auto &term) {
      check(name, *make_weak_form<dim>(term), /*has_pressure=*/false);
    };
    const auto check_mixed = [&](const char *name, const auto &...terms) {
      check(name, *make_weak_form<dim>(terms...), /*has_pressure=*/true);
    };

    prepare(/*theta=*/0.6);
    check_displacement("inertia", inertia);
    check_displacement("body force", body_force);
    check_displacement("viscosity", viscosity);
    check_displacement("bulk pressure",
                       BulkPressureTerm(law, /*elastic_time=*/0.6));
    check_displacement("point inertia", PointInertiaTerm(/*factor=*/1.));
    check_mixed("pressure", pressure);
    check_mixed("volume constraint", Strong(pressure), constraint);
    check_mixed("momentum subscale",
                Strong(inertia),
                Strong(body_force),
                Strong(viscosity),
                Strong(pressure),
                MomentumSubscaleTerm());
    check_mixed("pressure subscale",
                Strong(pressure),
                Strong(constraint),
                PressureSubscaleTerm(law.bulk_modulus));
    prepare(/*theta=*/0.5);
    cell.coefficients.theta = cell.coefficients.rate = 0.;
    check_mixed("start constraint",
                Strong(pressure),
                StartConstraintTerm(law, /*factor=*/1.));
  }
} // namespace

int
main()
{
  test<2, 1>();
  test<3, 1>();
  test<2, 2>();
  test<3, 2>();
}
