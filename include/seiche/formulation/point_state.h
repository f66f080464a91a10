// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_point_state_h
#define seiche_formulation_point_state_h

#include <seiche/formulation/point_kinematics.h>
#include <seiche/materials/viscous_stress.h>

namespace seiche
{
  /**
   * @brief Fields at several quadrature points that terms share; what only some
   * lists of terms have is left zero by the others.
   */
  template <int dim, int degree>
  struct PointState
  {
    static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    using Vector                          = dealii::Tensor<1, dim, Lanes>;
    using Matrix                          = dealii::Tensor<2, dim, Lanes>;

    const CellData<dim, degree>  &cell;
    PointKinematics<dim, degree> &point;
    const unsigned int            q;        ///< the first point
    const unsigned int            n_points; ///< lanes that count
    const Material               &material;

    const Lanes mass;     ///< [kg], with the weight
    const Lanes volume;   ///< V0 [m^dim], with the weight, as the next
    const Lanes J_n;      ///< [-] that counts
    const Lanes volume_t; ///< in the configuration t
    const Lanes rho_t;    ///< [kg/m^3]

    Vector acceleration;      ///< [m/s^2]
    Lanes  pressure = 0.;     ///< p [Pa]
    Vector pressure_gradient; ///< grad_t p [N/m^dim]
    Matrix velocity_gradient; ///< l [1/s], if a term needs it

    // of the residuals r [N/m^dim] and g [-], doc/theory.md (4.4)
    Vector r;
    Lanes  g                     = 0.;
    Lanes  r_inertia             = 0.; ///< dr = -this du [N/m^(dim+1)]
    Lanes  g_slope[dim][n_nodes] = {}; ///< dg/du without the pressure [1/m]

    // of the terms that have them
    Matrix             acceleration_gradient;
    Lanes              strain_slope = 0.; ///< dphi(J) = this div_1 du
    ViscousStress<dim> viscous;
    Vector             projected;            ///< Pi r
    Vector             stress_divergence;    ///< div s, zero for FE_Q(1)
    dealii::Tensor<3, dim, Lanes> curvature; ///< v_i,jk, for FE_Q(2)

    PointState(const CellData<dim, degree>  &cell_data,
               PointKinematics<dim, degree> &kinematics,
               const unsigned int            first_point,
               const unsigned int            number,
               const Material               &point_material,
               const Lanes                   volume_ratio)
      : cell(cell_data)
      , point(kinematics)
      , q(first_point)
      , n_points(number)
      , material(point_material)
      , mass(load<Lanes>(&cell.quadrature.mass[q]))
      , volume(load<Lanes>(&cell.quadrature.volume[q]))
      , J_n(volume_ratio)
      , volume_t(point.det_t * J_n * volume)
      , rho_t(mass / volume_t)
    {}

    void
    evaluate_pressure()
    {
      pressure          = point.value(cell.pressure);
      pressure_gradient = point.gradient(cell.pressure, point.gradient_t);
    }
  };
} // namespace seiche

#endif
