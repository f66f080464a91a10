// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_stabilization_h
#define seiche_formulation_stabilization_h

#include <seiche/grid/time_scheme.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /// Stabilization parameters of one cell, frozen during Newton's iteration.
  struct Tau
  {
    double momentum   = 0.; ///< tau1 [m^4/N]
    double continuity = 0.; ///< tau2 [Pa]
  };

  /**
   * @brief prm entries of the variational multiscale terms (subsection
   * "Formulation").
   */
  struct StabilizationParameters
  {
    std::string stabilization     = "ASGS";
    std::string tau               = "transient";
    double      speed_floor       = 1e-3; // [h/dt], of |v|
    double      inertia_factor    = 1.;   // c_d
    double      viscous_factor    = 4.;   // c_1
    double      continuity_factor = 0.1;  // c_2
    double      continuity_time   = 0.;   // T_c [s], 0: none

    void
    add_parameters(dealii::ParameterHandler &prm);

    bool
    is_active() const
    {
      return stabilization != "none";
    }

    /// True if tau1 is the same in all cells of a size: the pressure block is
    /// then a scaled copy of the Schur complement.
    bool
    tau_is_uniform() const
    {
      return tau == "transient";
    }

    /// 1/tau1 [N/m^4] of the transient choice, also used by the ghost penalty.
    double
    inverse_transient_tau(const StepCoefficients &coefficients,
                          const double            density,
                          const double            viscosity,
                          const double            h,
                          const unsigned int      degree) const;

    /**
     * transient: 1/tau1 = c_d rho C_a + c_1 2 mu c_r k^4/h^2 (Badia and
     * Codina 2009, in displacements). paper: 1/tau1 = c_1 2 mu/(h^2 dt) +
     * c_d rho |v|/(h dt) (founding paper, equation 25), |v| at least
     * speed_floor h/dt, because as printed tau1 is infinite where fluid rests.
     * Both: tau2 = c_2 h^2/tau1 min(1, dt/T_c), which is as many times the
     * viscosity c_2 h^2/(tau1 dt) on div v: without T_c it grows as 1/dt. For
     * a finite bulk modulus kappa 1/tau2 is enlarged by 1/kappa: the terms
     * 1 - tau2/kappa change sign otherwise. All zero without subscales.
     *
     * @p h cell size [m], @p speed at the cell's centre [m/s].
     */
    Tau
    evaluate(const StepCoefficients &coefficients,
             const double            density,
             const double            bulk_modulus,
             const double            viscosity,
             const double            h,
             const unsigned int      degree,
             const double            speed) const;
  };
} // namespace seiche

#endif
