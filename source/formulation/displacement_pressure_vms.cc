// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/displacement_pressure_vms.h>
#include <seiche/formulation/momentum_terms.h>
#include <seiche/formulation/pressure_terms.h>
#include <seiche/formulation/vms_point_state.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// grad p + Pi r - div s [N/m^dim]
    template <int dim, int degree>
    Tensor<1, dim, Lanes>
    resisting_force(const VMSPointState<dim, degree> &state)
    {
      return state.pressure_gradient + state.projected -
             state.stress_divergence;
    }

    /// True if none of the forces that PressureTerms::add_turns() multiplies
    /// exceeds @p limit [N/m^dim] at any of the points.
    template <int dim, int degree>
    bool
    turns_little(const VMSPointState<dim, degree> &state, const double limit)
    {
      const Tensor<1, dim, Lanes> f = resisting_force(state);
      const Lanes p = state.pressure_gradient * state.pressure_gradient,
                  r = state.momentum_residual * state.momentum_residual;
      return !std::experimental::any_of(max(max(p, r), f * f) > limit * limit);
    }
  } // namespace

  template <int dim>
  void
  DisplacementPressureVMS<dim>::update_points(
    PointCloud<dim> &points,
    const bool       volume_from_pressure) const
  {
    if (!volume_from_pressure)
      return;
    const double *pressure = points.data(PointColumn::pressure);
    double       *ratio    = points.data(PointColumn::volume_ratio);
    for (std::size_t p = 0; p < points.size(); ++p)
      ratio[p] =
        this->volume_law.ratio(-pressure[p] / this->volume_law.bulk_modulus);
  }

  template <int dim>
  bool
  DisplacementPressureVMS<dim>::has_pressure() const
  {
    return true;
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::residual(CellData<dim, 1> &cell) const
  {
    add_residual(cell);
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::residual(CellData<dim, 2> &cell) const
  {
    add_residual(cell);
  }

  template <int dim>
  template <int degree>
  void
  DisplacementPressureVMS<dim>::add_residual(CellData<dim, degree> &cell) const
  {
    constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    const Tau              tau     = this->tau(cell);
    const ResidualParts    parts =
      this->stabilization.residual_parts(cell.orthogonal);
    PointKinematics<dim, degree> point;
    Lanes residual_u[dim][n_nodes] = {}, residual_p[n_nodes] = {};
    cell.quadrature.for_each_batch(
      [&](const unsigned int q, const unsigned int, const Material &material) {
        point.evaluate(cell, q, /*with_end=*/false);
        const VMSPointState<dim, degree> state(
          cell, point, q, material, this->volume_law, tau, parts);
        MomentumTerms<dim, degree>::add_residual(
          cell,
          point,
          load<Lanes>(&cell.quadrature.mass[q]),
          state.volume_t,
          state.acceleration,
          cell.template body_force_at<Lanes>(q),
          state.stress,
          residual_u);

        const Lanes coarse =
          load<Lanes>(&cell.quadrature.volume[q]) *
          (state.constraint +
           state.fine_pressure * (1. / this->volume_law.bulk_modulus));
        for (unsigned int a = 0; a < n_nodes; ++a)
          residual_p[a] += coarse * point.N[a];
        for (unsigned int i = 0; i < dim; ++i)
          {
            const Lanes fine =
              state.volume_t * tau.momentum * state.momentum_residual[i];
            for (unsigned int a = 0; a < n_nodes; ++a)
              residual_p[a] -= fine * point.gradient_t[i][a];
          }
      });
    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        for (unsigned int i = 0; i < dim; ++i)
          cell.residual_u[i][a] = sum(residual_u[i][a]);
        cell.residual_p[a] = sum(residual_p[a]);
      }
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::tangent(CellData<dim, 1> &cell) const
  {
    add_tangent(cell);
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::tangent(CellData<dim, 2> &cell) const
  {
    add_tangent(cell);
  }

  template <int dim>
  template <int degree>
  void
  DisplacementPressureVMS<dim>::add_tangent(CellData<dim, degree> &cell) const
  {
    constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    cell.clear_tangent();
    const Tau           tau        = this->tau(cell);
    const bool          is_viscous = this->tangent_is_viscous(cell);
    const double        theta      = cell.coefficients.theta;
    const double        kappa      = this->volume_law.bulk_modulus;
    const double        weight_g   = 1. - tau.continuity / kappa;
    const ResidualParts parts =
      this->stabilization.residual_parts(cell.orthogonal);
    const double negligible_force = this->negligible_force(cell, tau);
    PointKinematics<dim, degree> point;
    cell.quadrature.for_each_batch([&](const unsigned int q,
                                       const unsigned int n_points,
                                       const Material    &material) {
      point.evaluate(cell, q, /*with_end=*/true);
      const VMSPointState<dim, degree> state(
        cell, point, q, material, this->volume_law, tau, parts);
      Lanes h[dim][n_nodes]; // d(constraint)/du
      state.constraint_slope(cell, point, h);
      MomentumTerms<dim, degree>::add_tangent(cell,
                                              point,
                                              n_points,
                                              load<Lanes>(
                                                &cell.quadrature.mass[q]),
                                              state.volume_t,
                                              is_viscous,
                                              state.viscous,
                                              Lanes(tau.continuity),
                                              h,
                                              state.velocity_gradient,
                                              state.stress,
                                              state.pressure);

      const Lanes fine   = state.volume_t * tau.momentum;
      const Lanes weight = weight_g * load<Lanes>(&cell.quadrature.volume[q]);
      Lanes       inertia[n_nodes]; // rho C_a of the momentum residual
      for (unsigned int a = 0; a < n_nodes; ++a)
        inertia[a] = parts.inertia ? fine * state.rho_t *
                                       cell.coefficients.inertia * point.N[a] :
                                     Lanes(0.);
      PressureTerms<dim, degree>::add_couplings(
        cell, point, n_points, -weight_g * state.volume_t, weight, h, inertia);
      if (cell.turns && parts.inertia)
        PressureTerms<dim, degree>::add_coriolis(cell,
                                                 point,
                                                 n_points,
                                                 inertia);
      PressureTerms<dim, degree>::add_diagonal(
        cell, point, n_points, weight / kappa, fine);
      if (!turns_little(state, negligible_force))
        PressureTerms<dim, degree>::add_turns(cell,
                                              point,
                                              n_points,
                                              theta * fine,
                                              resisting_force(state),
                                              state.pressure_gradient,
                                              state.momentum_residual);
      if constexpr (degree > 1)
        if (is_viscous && parts.force)
          {
            Lanes derivative[dim][dim][n_nodes];
            state.stress_divergence_derivative(cell,
                                               point,
                                               fine * cell.viscosity,
                                               derivative);
            for (unsigned int k = 0; k < dim; ++k)
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int a = 0; a < n_nodes; ++a)
                  for (unsigned int b = 0; b < n_nodes; ++b)
                    cell.pu[k][a][b] -=
                      sum(point.gradient_t[i][a] * derivative[i][k][b]);
          }
    });
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::projected_terms(CellData<dim, 1> &cell) const
  {
    add_projected_terms(cell);
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::projected_terms(CellData<dim, 2> &cell) const
  {
    add_projected_terms(cell);
  }

  template <int dim>
  template <int degree>
  void
  DisplacementPressureVMS<dim>::add_projected_terms(
    CellData<dim, degree> &cell) const
  {
    cell.clear_residual();
    const Tau           tau = this->tau(cell);
    const ResidualParts parts =
      this->stabilization.residual_parts(cell.orthogonal);
    const bool                   lumped = this->stabilization.projects_lumped;
    PointKinematics<dim, degree> point;
    cell.quadrature.for_each_batch(
      [&](const unsigned int q, const unsigned int, const Material &material) {
        point.evaluate(cell, q, /*with_end=*/false);
        const VMSPointState<dim, degree> state(
          cell, point, q, material, this->volume_law, tau, parts);
        for (unsigned int a = 0; a < cell.n_nodes; ++a)
          {
            const Lanes weight = load<Lanes>(&cell.quadrature.volume[q]) *
                                 (lumped ? point.weight(a) : point.N[a]);
            for (unsigned int i = 0; i < dim; ++i)
              cell.residual_u[i][a] +=
                sum(weight * (state.momentum_residual[i] + state.projected[i]));
            cell.residual_p[a] += sum(weight * state.constraint);
          }
      });
  }

  template class DisplacementPressureVMS<2>;
  template class DisplacementPressureVMS<3>;
} // namespace seiche
