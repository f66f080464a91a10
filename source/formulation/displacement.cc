// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/displacement.h>
#include <seiche/formulation/momentum_terms.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim, int degree>
    struct PointState
    {
      Lanes                 volume_t, pressure;
      Lanes                 strain_slope; // VolumeStrain::slope
      Tensor<2, dim, Lanes> velocity_gradient, stress;
      ViscousStress<dim>    viscous;

      PointState(const CellData<dim, degree>        &cell,
                 const PointKinematics<dim, degree> &point,
                 const unsigned int                  q,
                 const Material                     &material,
                 const VolumeLaw                    &volume_law)
      {
        const Lanes J_n = load<Lanes>(&cell.quadrature.volume_ratio[q]);
        volume_t = point.det_t * J_n * load<Lanes>(&cell.quadrature.volume[q]);
        const VolumeStrain<Lanes> strain(volume_law,
                                         cell.coefficients.elastic_time,
                                         J_n,
                                         point.det_1 * J_n);
        strain_slope = strain.slope;
        if (cell.viscosity > 0.)
          {
            velocity_gradient =
              point.gradient(cell.rate_velocity, point.gradient_t);
            viscous.evaluate(*material.law, velocity_gradient);
            stress = viscous.stress();
          }
        pressure = -volume_law.bulk_modulus * strain.value;
        for (unsigned int i = 0; i < dim; ++i)
          stress[i][i] -= pressure;
      }
    };
  } // namespace

  template <int dim>
  bool
  Displacement<dim>::has_pressure() const
  {
    return false;
  }

  template <int dim>
  void
  Displacement<dim>::residual(CellData<dim, 1> &cell) const
  {
    add_residual(cell);
  }

  template <int dim>
  void
  Displacement<dim>::residual(CellData<dim, 2> &cell) const
  {
    add_residual(cell);
  }

  template <int dim>
  template <int degree>
  void
  Displacement<dim>::add_residual(CellData<dim, degree> &cell) const
  {
    PointKinematics<dim, degree> point;
    Lanes residual[dim][CellData<dim, degree>::n_nodes] = {};
    cell.quadrature.for_each_batch(
      [&](const unsigned int q, const unsigned int, const Material &material) {
        point.evaluate(cell, q, /*with_end=*/false);
        const PointState<dim, degree> state(
          cell, point, q, material, this->volume_law);
        MomentumTerms<dim, degree>::add_residual(
          cell,
          point,
          load<Lanes>(&cell.quadrature.mass[q]),
          state.volume_t,
          point.value(cell.acceleration),
          cell.template body_force_at<Lanes>(q),
          state.stress,
          residual);
      });
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < CellData<dim, degree>::n_nodes; ++a)
        cell.residual_u[i][a] = sum(residual[i][a]);
  }

  template <int dim>
  void
  Displacement<dim>::tangent(CellData<dim, 1> &cell) const
  {
    add_tangent(cell);
  }

  template <int dim>
  void
  Displacement<dim>::tangent(CellData<dim, 2> &cell) const
  {
    add_tangent(cell);
  }

  template <int dim>
  template <int degree>
  void
  Displacement<dim>::add_tangent(CellData<dim, degree> &cell) const
  {
    cell.clear_tangent();
    const bool                   is_viscous = this->tangent_is_viscous(cell);
    PointKinematics<dim, degree> point;
    cell.quadrature.for_each_batch([&](const unsigned int q,
                                       const unsigned int n_points,
                                       const Material    &material) {
      point.evaluate(cell, q, /*with_end=*/true);
      const PointState<dim, degree> state(
        cell, point, q, material, this->volume_law);
      MomentumTerms<dim, degree>::add_tangent(
        cell,
        point,
        n_points,
        load<Lanes>(&cell.quadrature.mass[q]),
        state.volume_t,
        is_viscous,
        state.viscous,
        this->volume_law.bulk_modulus * state.strain_slope,
        point.gradient_1,
        state.velocity_gradient,
        state.stress,
        state.pressure);
    });
  }

  template <int dim>
  void
  Displacement<dim>::update_points(PointCloud<dim> &points,
                                   const bool /*volume_from_pressure*/) const
  {
    const double *ratio    = points.data(PointColumn::volume_ratio);
    double       *pressure = points.data(PointColumn::pressure);
    for (std::size_t p = 0; p < points.size(); ++p)
      pressure[p] =
        -this->volume_law.bulk_modulus * this->volume_law.strain(ratio[p]);
  }

  template class Displacement<2>;
  template class Displacement<3>;
} // namespace seiche
