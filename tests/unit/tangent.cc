// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangent of every formulation against central differences of its residual.
#include <seiche/formulation/fluid_at_wall.h>
#include <seiche/formulation/momentum_subscale_term.h>
#include <seiche/materials/power_law.h>

#include <iostream>
#include <limits>

#include "tangent_error.h"

namespace
{
  template <int dim, int degree>
  double
  step_error(const Formulation<dim> &formulation,
             CellData<dim, degree>  &cell,
             const double            largest_pressure = 30.,
             const double            largest_offset   = 2.)
  {
    formulation.set_subscales(cell);
    return tangent_error(*formulation.step,
                         formulation.has_pressure(),
                         cell,
                         largest_pressure,
                         largest_offset);
  }

  /// Over viscosities, moduli, schemes, mass matrices and volume laws; the
  /// wrong ones are named.
  template <int dim, int degree>
  unsigned int
  n_exact_tangents(const FormulationParameters &parameters)
  {
    const double          infinite = std::numeric_limits<double>::infinity();
    unsigned int          n_exact  = 0;
    CellData<dim, degree> cell;
    for (const Material &material : {newtonian(0.), newtonian(0.7)})
      for (const double kappa : {50., infinite})
        for (const double theta : {0.5, 0.6, 1.})
          for (const auto &[logarithmic, lumped] :
               {std::pair(false, false), {false, true}, {true, true}})
            {
              if (!parameters.is_mixed() && std::isinf(kappa))
                continue;
              const auto formulation =
                make_formulation<dim>(parameters,
                                      FreeSurfaceParameters(),
                                      {kappa, logarithmic},
                                      volume_factors(logarithmic ? theta : 1.));
              fill_cell(cell, material, theta, lumped);
              cell.orthogonal    = parameters.stabilization.is_orthogonal();
              const double error = step_error(formulation, cell);
              if (error < 1e-6)
                ++n_exact;
              else
                std::cout << "mu " << material.law->scale << " kappa " << kappa
                          << " theta " << theta << (lumped ? " lumped" : "")
                          << (logarithmic ? " logarithmic, J at theta" : "")
                          << ": WRONG, relative error " << error << '\n';
            }
    return n_exact;
  }

  template <int dim, int degree>
  void
  test()
  {
    for (const char *name : {"displacement-pressure", "displacement"})
      for (const char *stabilization : {"ASGS", "none", "OSGS", "split OSGS"})
        for (const char *residual : {"whole", "without inertia"})
          for (const char *tau : {"transient", "paper", "root of squares"})
            {
              FormulationParameters parameters;
              parameters.name                            = name;
              parameters.stabilization.stabilization     = stabilization;
              parameters.stabilization.tau               = tau;
              parameters.stabilization.subscale_residual = residual;
              const bool has_choice = parameters.is_mixed() &&
                                      (stabilization == std::string("ASGS") ||
                                       stabilization == std::string("OSGS"));
              if (residual != std::string("whole") && !has_choice)
                continue;
              if (tau != std::string("transient") &&
                  stabilization != std::string("ASGS"))
                continue; // tau is a number to the weak form
              std::cout << dim << "D Q" << degree << ' ' << name << ' '
                        << stabilization << ", residual " << residual << ", "
                        << tau << ": "
                        << n_exact_tangents<dim, degree>(parameters)
                        << " exact\n";
            }
  }

  template <int dim, int degree>
  void
  add_coriolis(CellData<dim, degree> &cell)
  {
    cell.turns = true;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int k = 0; k < i; ++k)
        {
          cell.coriolis[i][k] = 15. + 5. * i - 8. * k;
          cell.coriolis[k][i] = -cell.coriolis[i][k];
        }
  }

  /// In a tank that turns: a Coriolis acceleration as large as the inertia, the
  /// points' own extent too.
  template <int dim, int degree>
  void
  test_coriolis()
  {
    unsigned int n_exact = 0, n_all = 0;
    for (const char *name : {"displacement-pressure", "displacement"})
      for (const char *stabilization : {"ASGS", "OSGS", "split OSGS"})
        for (const char *residual : {"whole", "without inertia"})
          for (const Material &material : {newtonian(0.), newtonian(0.7)})
            for (const double theta : {0.5, 1.})
              for (const bool lumped : {false, true})
                {
                  FormulationParameters parameters;
                  parameters.name                            = name;
                  parameters.stabilization.stabilization     = stabilization;
                  parameters.stabilization.subscale_residual = residual;
                  const auto formulation =
                    make_formulation<dim>(parameters,
                                          FreeSurfaceParameters(),
                                          {/*bulk_modulus=*/50.},
                                          volume_factors());
                  CellData<dim, degree> cell;
                  fill_cell(cell, material, theta, lumped);
                  cell.orthogonal = parameters.stabilization.is_orthogonal();
                  cell.extent_inertia = 0.02;
                  add_coriolis(cell);
                  ++n_all;
                  const double error = step_error(formulation, cell);
                  if (error < 1e-6)
                    ++n_exact;
                  else
                    std::cout << name << ' ' << stabilization << ' ' << residual
                              << " mu " << material.law->scale << " theta "
                              << theta << (lumped ? " lumped" : "")
                              << ": WRONG, relative error " << error << '\n';
                }
    std::cout << dim << "D Q" << degree << " Coriolis: " << n_exact << " of "
              << n_all << " exact\n";
  }

  /// With walls of a solid in the cell.
  template <int dim, int degree>
  void
  test_walls()
  {
    unsigned int   n_exact = 0, n_all = 0, n_left = 0;
    const Material water   = newtonian(0.7),
                   thinner = material_of(std::make_shared<PowerLaw>(0.4, 0.1),
                                         /*viscosity=*/0.7);
    for (const auto &[fluid, theta, turns] : {std::tuple(water, 0., false),
                                              {water, 0.5, false},
                                              {water, 1., false},
                                              {thinner, 0.5, false},
                                              {water, 0.5, true}})
      {
        FormulationParameters parameters;
        const auto            formulation = make_formulation<dim>(parameters,
                                                       FreeSurfaceParameters(),
                                                       {/*bulk_modulus=*/50.},
                                                       volume_factors());
        CellData<dim, degree> cell;
        std::vector<WallPoint<dim>> wall(5);
        for (unsigned int q = 0; q < wall.size(); ++q)
          for (unsigned int d = 0; d < dim; ++d)
            {
              wall[q].unit[d] = 0.2 + 0.15 * q - 0.1 * d;
              wall[q].area[d] = 0.3 - 0.2 * d + 0.1 * q;
            }
        fill_cell(cell, fluid, theta, /*lumped=*/false);
        std::vector<SolidInStep<dim>> solids(wall.size());
        for (unsigned int s = 0; s < solids.size(); ++s)
          {
            // slips with friction, sticks, between both, holds fluid that
            // might leave, is left
            wall[s].solid         = s;
            wall[s].normal[0]     = 0.6;
            wall[s].normal[1]     = -0.8;
            solids[s].may_be_left = s >= 3;
            if (s == 1 || s == 2)
              solids[s].slip_length = 0.3 * (s - 1.);
            else
              solids[s].friction = 0.4;
            for (unsigned int i = 0; i < dim; ++i)
              {
                solids[s].way.shift[i] = 0.02 - 0.01 * s + 0.01 * i;
                for (unsigned int k = 0; k < dim; ++k)
                  solids[s].way.turn[i][k] = 0.03 * (i + 1.) - 0.02 * k * s;
              }
            if (solids[s].may_be_left)
              solids[s].way.shift += (s == 3 ? -1. : 1.) * wall[s].normal;
          }
        cell.wall             = &wall;
        cell.solids           = &solids;
        cell.wall_material    = &fluid;
        cell.wall_may_be_left = true;
        if (turns)
          add_coriolis(cell);
        ++n_all;
        const double error = step_error(formulation, cell);
        for (const unsigned int s : {3, 4})
          n_left += fluid_leaves(cell, wall[s]);
        if (error < 1e-6)
          ++n_exact;
        else
          std::cout << "theta " << theta << ": WRONG, relative error " << error
                    << '\n';
      }
    std::cout << dim << "D Q" << degree << " walls of solids: " << n_exact
              << " of " << n_all << " exact, " << n_left << " left\n";
  }

  /// Viscous terms are in the tangent unless they are negligible.
  template <int dim, int degree>
  void
  test_small_viscosity()
  {
    CellData<dim, degree> cell;
    const Material        inviscid = newtonian(0.);
    fill_cell(cell,
              inviscid,
              /*theta=*/0.5,
              /*lumped=*/false);
    const StepCoefficients &c     = cell.coefficients;
    const double            limit = ViscousTerm::negligible * inviscid.density *
                         c.inertia / c.rate *
                         std::pow(cell.geometry.shortest_edge() / degree, 2);
    for (const double share : {0.99, 1.01})
      {
        const auto formulation = make_formulation<dim>(FormulationParameters(),
                                                       FreeSurfaceParameters(),
                                                       VolumeLaw(),
                                                       volume_factors());
        const Material hardly_viscous = newtonian(share * limit);
        fill_cell(cell,
                  hardly_viscous,
                  /*theta=*/0.5,
                  /*lumped=*/false);
        const double error = step_error(formulation, cell);
        std::cout << dim << "D Q" << degree << " viscosity " << share
                  << " of the limit: "
                  << (error < 1e-6 ? "exact" :
                      error < 1e-2 ? "left out" :
                                     "WRONG")
                  << '\n';
      }
  }

  /// Fluids that thin and thicken with the shear rate.
  template <int dim, int degree>
  void
  test_power_law()
  {
    unsigned int n_exact = 0, n_all = 0;
    for (const char *name : {"displacement-pressure", "displacement"})
      for (const double flow_index : {0.4, 1.7})
        for (const double theta : {0.5, 1.})
          {
            FormulationParameters parameters;
            parameters.name = name;
            const auto formulation =
              make_formulation<dim>(parameters,
                                    FreeSurfaceParameters(),
                                    {/*bulk_modulus=*/50.},
                                    volume_factors());
            const Material material =
              material_of(std::make_shared<PowerLaw>(flow_index, 0.1),
                          /*viscosity=*/0.7);
            CellData<dim, degree> cell;
            fill_cell(cell,
                      material,
                      theta,
                      /*lumped=*/false);
            ++n_all;
            const double error = step_error(formulation, cell);
            if (error < 1e-6)
              ++n_exact;
            else
              std::cout << name << " n " << flow_index << " theta " << theta
                        << ": WRONG, relative error " << error << '\n';
          }
    std::cout << dim << "D Q" << degree << " power law: " << n_exact << " of "
              << n_all << " exact\n";
  }

  /// That the subscale's gradients turn is in the tangent unless its force is
  /// small. Split orthogonal subscales: the force is the pressure's gradient.
  template <int dim, int degree>
  void
  test_small_turn()
  {
    CellData<dim, degree> cell;
    const Material        inviscid = newtonian(0.);
    fill_cell(cell,
              inviscid,
              /*theta=*/0.5,
              /*lumped=*/false);
    cell.orthogonal = true;
    FormulationParameters parameters;
    parameters.stabilization.stabilization = "split OSGS";
    const auto formulation                 = make_formulation<dim>(parameters,
                                                   FreeSurfaceParameters(),
                                                   VolumeLaw(),
                                                   volume_factors());
    formulation.set_subscales(cell);
    const double limit =
      cell.geometry.shortest_edge() / MomentumSubscaleTerm::turn_by_force(cell);
    for (const double share : {0.05, 50.})
      {
        const double error =
          step_error(formulation, cell, share * limit, /*offset=*/0.);
        std::cout << dim << "D Q" << degree << " force " << share
                  << " of the limit: "
                  << (error < 1e-6 ? "exact" :
                      error < 1e-2 ? "left out" :
                                     "WRONG")
                  << '\n';
        if (!(error < 1e-2))
          std::cout << "  relative error " << error << '\n';
      }
  }
} // namespace

int
main()
{
  test_walls<2, 1>();
  test_walls<3, 1>();
  test_walls<2, 2>();
  test_walls<3, 2>();
  test_coriolis<2, 1>();
  test_coriolis<3, 1>();
  test_coriolis<2, 2>();
  test_coriolis<3, 2>();
  test_power_law<2, 1>();
  test_power_law<3, 1>();
  test_power_law<2, 2>();
  test_power_law<3, 2>();
  test_small_turn<2, 1>();
  test_small_turn<3, 1>();
  test_small_turn<2, 2>();
  test_small_turn<3, 2>();
  test_small_viscosity<2, 1>();
  test_small_viscosity<3, 1>();
  test_small_viscosity<2, 2>();
  test_small_viscosity<3, 2>();
  test<2, 1>();
  test<3, 1>();
  test<2, 2>();
  test<3, 2>();
}
