// SPDX-License-Identifier: LGPL-2.1-or-later
// Every tangent against central differences of its residual, block by block,
// at random states of one cell with random quadrature points.
#include <seiche/formulation/formulation.h>
#include <seiche/formulation/point_inertia.h>
#include <seiche/materials/power_law.h>

#include <iostream>
#include <limits>
#include <random>

using namespace seiche;

namespace
{
  constexpr double step = 1e-6;

  std::mt19937 generator(1);

  double
  random(const double scale)
  {
    return scale *
           (2. * (generator() / static_cast<double>(generator.max())) - 1.);
  }

  /// Of the density that the quadrature points have.
  Material
  material_of(const std::shared_ptr<ViscosityLaw> &law, const double viscosity)
  {
    law->scale = viscosity;
    return {"", /*density=*/3., law};
  }

  Material
  newtonian(const double viscosity)
  {
    return material_of(make_viscosity_laws().front().law, viscosity);
  }

  template <int dim, int degree>
  void
  fill_cell(CellData<dim, degree> &cell,
            const Material        &material,
            const double           theta,
            const bool             elastic_middle,
            const bool             lumped)
  {
    const double dt                   = 0.05;
    cell.coefficients                 = StepCoefficients();
    cell.coefficients.dt              = dt;
    cell.coefficients.theta           = theta;
    cell.coefficients.inertia         = 1. / (theta * dt * dt);
    cell.coefficients.rate            = 1. / dt;
    cell.coefficients.jerk_constraint = dt * dt * dt / 12.;
    cell.coefficients.elastic_time    = elastic_middle ? theta : 1.;
    cell.lumped                       = lumped;
    cell.start_speed                  = 1.3;
    cell.density                      = material.density;
    cell.viscosity                    = material.law->viscosity(1.);
    dealii::Point<dim> upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        upper[d]                    = 0.4 + 0.1 * d;
        cell.constant_body_force[d] = -9.81 + d;
      }
    cell.geometry = {dealii::Point<dim>(), upper};
    cell.quadrature.clear();
    cell.quadrature.begin_part(material);
    for (unsigned int q = 0; q < 9; ++q)
      {
        dealii::Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = 0.5 + random(0.5);
        const double volume = 0.01 * (1. + random(0.3));
        cell.quadrature.push_back(x, 3. * volume, volume, 1. + random(0.05));
      }
  }

  /// Unknowns: u component by component, then p.
  template <int dim, int degree>
  void
  set_state(CellData<dim, degree>     &cell,
            const std::vector<double> &x,
            const std::vector<double> &offsets)
  {
    constexpr unsigned int n = CellData<dim, degree>::n_nodes;
    const auto            &c = cell.coefficients;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < n; ++a)
        {
          const double u           = x[i * n + a];
          cell.displacement[i][a]  = u;
          cell.acceleration[i][a]  = c.inertia * u + offsets[i * n + a];
          cell.rate_velocity[i][a] = c.rate * u + 0.1 * offsets[i * n + a];
        }
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int a = 0; a < n; ++a)
          cell.acceleration[i][a] +=
            cell.coriolis[i][k] * cell.rate_velocity[k][a];
    for (unsigned int a = 0; a < n; ++a)
      {
        cell.pressure[a] = x[dim * n + a];
        for (unsigned int i = 0; i < dim; ++i)
          cell.projected_momentum[i][a] = 3. * offsets[i * n + a];
        cell.projected_constraint[a] = 0.01 * offsets[a];
      }
  }

  template <int dim, int degree>
  double
  residual_entry(const CellData<dim, degree> &cell, const unsigned int row)
  {
    constexpr unsigned int n = CellData<dim, degree>::n_nodes;
    return row < dim * n ? cell.residual_u[row / n][row % n] :
                           cell.residual_p[row - dim * n];
  }

  template <int dim, int degree>
  double
  tangent_entry(const CellData<dim, degree> &cell,
                const unsigned int           row,
                const unsigned int           column)
  {
    constexpr unsigned int n     = CellData<dim, degree>::n_nodes;
    const bool             u_row = row < dim * n, u_column = column < dim * n;
    const unsigned int     a = row % n, b = column % n;
    if (u_row && u_column)
      return cell.uu[row / n][column / n][a][b];
    if (u_row)
      return cell.up[row / n][a][b];
    if (u_column)
      return cell.pu[column / n][a][b];
    return cell.pp[a][b];
  }

  /// Largest error of a block over the block's largest entry, over all blocks.
  template <int dim, int degree>
  double
  tangent_error(const Formulation<dim> &formulation,
                CellData<dim, degree>  &cell,
                const double            largest_pressure = 30.,
                const double            largest_offset   = 2.)
  {
    constexpr unsigned int n = CellData<dim, degree>::n_nodes;
    const unsigned int     n_unknowns =
      n * (formulation.has_pressure() ? dim + 1 : dim);
    std::vector<double> x(n * (dim + 1)), offsets(n * dim);
    for (unsigned int i = 0; i < x.size(); ++i)
      x[i] = random(i < dim * n ? 0.02 : largest_pressure);
    for (double &offset : offsets)
      offset = random(largest_offset);

    set_state(cell, x, offsets);
    formulation.tangent(cell);
    PointInertia<dim, degree>::add_tangent(cell);
    double error[2][2] = {}, size[2][2] = {};
    for (unsigned int column = 0; column < n_unknowns; ++column)
      {
        const double        h = column < dim * n ? step : 100. * step;
        std::vector<double> differences(n_unknowns);
        for (const double sign : {1., -1.})
          {
            std::vector<double> moved = x;
            moved[column] += sign * h;
            set_state(cell, moved, offsets);
            formulation.residual(cell);
            PointInertia<dim, degree>::add_residual(cell);
            for (unsigned int row = 0; row < n_unknowns; ++row)
              differences[row] += sign * residual_entry(cell, row) / (2. * h);
          }
        for (unsigned int row = 0; row < n_unknowns; ++row)
          {
            double &e = error[row >= dim * n][column >= dim * n];
            double &s = size[row >= dim * n][column >= dim * n];
            e         = std::max(e,
                         std::abs(differences[row] -
                                  tangent_entry(cell, row, column)));
            s         = std::max(s, std::abs(differences[row]));
          }
      }
    double worst = 0.;
    for (unsigned int r = 0; r < 2; ++r)
      for (unsigned int c = 0; c < 2; ++c)
        if (size[r][c] > 0.)
          worst = std::max(worst, error[r][c] / size[r][c]);
    return worst;
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
                make_formulation<dim>(parameters, {kappa, logarithmic});
              fill_cell(cell, material, theta, logarithmic, lumped);
              cell.orthogonal    = parameters.stabilization.is_orthogonal();
              const double error = tangent_error(*formulation, cell);
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
                    make_formulation<dim>(parameters, {/*bulk_modulus=*/50.});
                  CellData<dim, degree> cell;
                  fill_cell(
                    cell, material, theta, /*elastic_middle=*/false, lumped);
                  cell.orthogonal = parameters.stabilization.is_orthogonal();
                  cell.extent_inertia = 0.02;
                  cell.turns          = true;
                  for (unsigned int i = 0; i < dim; ++i)
                    for (unsigned int k = 0; k < i; ++k)
                      {
                        cell.coriolis[i][k] = 15. + 5. * i - 8. * k;
                        cell.coriolis[k][i] = -cell.coriolis[i][k];
                      }
                  ++n_all;
                  const double error = tangent_error(*formulation, cell);
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
              /*elastic_middle=*/false,
              /*lumped=*/false);
    const StepCoefficients &c = cell.coefficients;
    const double limit = negligible_viscosity * inviscid.density * c.inertia /
                         c.rate *
                         std::pow(cell.geometry.shortest_edge() / degree, 2);
    for (const double share : {0.99, 1.01})
      {
        const auto formulation =
          make_formulation<dim>(FormulationParameters(), VolumeLaw());
        const Material hardly_viscous = newtonian(share * limit);
        fill_cell(cell,
                  hardly_viscous,
                  /*theta=*/0.5,
                  /*elastic_middle=*/false,
                  /*lumped=*/false);
        const double error = tangent_error(*formulation, cell);
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
              make_formulation<dim>(parameters, {/*bulk_modulus=*/50.});
            const Material material =
              material_of(std::make_shared<PowerLaw>(flow_index, 0.1),
                          /*viscosity=*/0.7);
            CellData<dim, degree> cell;
            fill_cell(cell,
                      material,
                      theta,
                      /*elastic_middle=*/false,
                      /*lumped=*/false);
            ++n_all;
            const double error = tangent_error(*formulation, cell);
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
              /*elastic_middle=*/false,
              /*lumped=*/false);
    cell.orthogonal = true;
    FormulationParameters parameters;
    parameters.stabilization.stabilization = "split OSGS";
    const auto   formulation = make_formulation<dim>(parameters, VolumeLaw());
    const double limit =
      formulation->negligible_force(cell, formulation->tau(cell)) *
      cell.geometry.shortest_edge();
    for (const double share : {0.05, 50.})
      {
        const double error =
          tangent_error(*formulation, cell, share * limit, /*offset=*/0.);
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
