// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_tangent_error_h
#define tests_unit_tangent_error_h

#include <seiche/formulation/formulation.h>

#include <random>

// A weak form's tangent against central differences of its residual, block by
// block, at random states of one cell with random quadrature points.
namespace
{
  using namespace seiche;

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

  /// With the pressure of second order.
  VolumeFactors
  volume_factors(const double elastic_time = 1.)
  {
    return {/*start_divergence=*/0., /*jerk=*/1. / 12., elastic_time};
  }

  template <int dim, int degree>
  void
  fill_cell(CellData<dim, degree> &cell,
            const Material        &material,
            const double           theta,
            const bool             lumped)
  {
    const double dt           = 0.05;
    cell.coefficients         = StepCoefficients();
    cell.coefficients.dt      = dt;
    cell.coefficients.theta   = theta;
    cell.coefficients.inertia = 1. / (theta * dt * dt);
    cell.coefficients.rate    = 1. / dt;
    cell.lumped               = lumped;
    cell.start_speed          = 1.3;
    cell.fluid                = material.properties(1.);
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
  tangent_error(const WeakForm<dim>   &weak_form,
                const bool             has_pressure,
                CellData<dim, degree> &cell,
                const double           largest_pressure = 30.,
                const double           largest_offset   = 2.)
  {
    constexpr unsigned int n          = CellData<dim, degree>::n_nodes;
    const unsigned int     n_unknowns = n * (has_pressure ? dim + 1 : dim);
    std::vector<double>    x(n * (dim + 1)), offsets(n * dim);
    for (unsigned int i = 0; i < x.size(); ++i)
      x[i] = random(i < dim * n ? 0.02 : largest_pressure);
    for (double &offset : offsets)
      offset = random(largest_offset);

    set_state(cell, x, offsets);
    weak_form.tangent(cell);
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
            weak_form.residual(cell);
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
} // namespace

#endif
