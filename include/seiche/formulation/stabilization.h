// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_stabilization_h
#define seiche_formulation_stabilization_h

#include <seiche/grid/time_scheme.h>
#include <seiche/materials/material.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// Stabilization parameters of one cell, frozen during Newton's iteration.
  struct Tau
  {
    double momentum   = 0.; ///< tau1 [m^4/N]
    double continuity = 0.; ///< tau2 [Pa]
  };

  /// What the stabilization parameters of a cell depend on.
  struct TauArguments
  {
    const StepCoefficients &step;
    FluidProperties         fluid;
    double                  bulk_modulus; ///< [Pa]
    double                  h;            ///< cell size [m]
    unsigned int            degree;
    double                  speed;      ///< at the cell's centre [m/s]
    double                  body_force; ///< largest in the cell [m/s^2]
  };

  /// What the momentum's subscale sees beside the pressure gradient.
  struct ResidualParts
  {
    bool force   = false; ///< body force and viscous force
    bool inertia = false;
  };

  /**
   * @brief prm entries of the variational multiscale terms (subsection
   * "Formulation").
   */
  struct StabilizationParameters
  {
    std::string  stabilization      = "ASGS";
    std::string  subscale_residual  = "whole";
    unsigned int projection_updates = 6;
    std::string  projection_mass    = "lumped";
    std::string  tau                = "transient";
    double       speed_floor        = 1.;  // [h/dt], of |v|
    double       inertia_factor     = 1.;  // c_d
    double       viscous_factor     = 4.;  // c_1
    double       continuity_factor  = 0.1; // c_2
    double       continuity_modulus = 0.;  // K_num [Pa]
    double       continuity_time    = 0.;  // T_c [s], 0: none

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const bool is_mixed) const;

    /// True if there are subscales.
    bool
    is_active() const
    {
      return stabilization != "none";
    }

    /// True if the momentum's subscale sees inertia.
    bool
    has_inertia() const
    {
      return subscale_residual == "whole";
    }

    /// True if tau1 is that of equation 25, without inertia.
    bool
    is_quasi_static() const;

    /// True if the subscales are orthogonal to the finite elements.
    bool
    is_orthogonal() const
    {
      return stabilization == "OSGS" || is_split();
    }

    /// True if the momentum's subscale has the pressure gradient only.
    bool
    is_split() const
    {
      return stabilization == "split OSGS";
    }

    /// True if the mass matrix of their projection is lumped.
    bool
    projects_lumped() const
    {
      return projection_mass == "lumped";
    }

  private:
    void
    add_tau_parameters(dealii::ParameterHandler &prm);
  };

  /**
   * @brief The variational multiscale terms as chosen, for the weak forms: no
   * name is looked up in a cell.
   */
  class Stabilization
  {
  public:
    explicit Stabilization(const StabilizationParameters &parameters);

    const StabilizationParameters parameters;

    const bool is_active;       ///< there are subscales
    const bool projects_lumped; ///< StabilizationParameters::projects_lumped()

    /// Of the weak forms; @p orthogonal: in Newton's iteration with orthogonal
    /// subscales, where the split ones see the pressure gradient alone.
    ResidualParts
    residual_parts(const bool orthogonal) const
    {
      return orthogonal && is_split ? ResidualParts{false, false} :
                                      ResidualParts{true, has_inertia};
    }

    /// tau1 is the same in all cells of a size: the pressure block is then a
    /// scaled copy of the Schur complement.
    const bool tau_is_uniform;

    /// 1/tau1 [N/m^4] of the transient choice, also used by the ghost penalty.
    double
    inverse_transient_tau(const TauArguments &cell) const;

    /**
     * tau1 by the table of doc/theory.md, "Stabilization parameters"; (4.5):
     * tau2 = c_2 h^2 max(1/tau1, 20 rho C_a dt^2 b/h) min(1, dt/T_c)
     * + min(K_num, 2 h^2/tau1). The first part is as many times the viscosity
     * c_2 h^2/(tau1 dt) on div v: without T_c it grows as 1/dt. With the body
     * force b it is that of a step of sqrt(h/(20 b)) at most: with less of it
     * calm water becomes restless in larger steps (the paper's tau is left as
     * it is). For a finite bulk modulus kappa 1/tau2 is enlarged by 1/kappa:
     * the terms 1 - tau2/kappa change sign otherwise. All zero without
     * subscales.
     */
    Tau
    evaluate(const TauArguments &cell) const;

  private:
    const bool bears_weight; ///< the term with b; not with the paper's tau
    const bool is_split;
    const bool has_inertia; ///< of the subscale's residual
    double (&inverse_tau)(const StabilizationParameters &,
                          const TauArguments &); ///< 1/tau1 [N/m^4]
  };
} // namespace seiche

#endif
