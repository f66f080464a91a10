// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_ghost_penalty_h
#define seiche_formulation_ghost_penalty_h

#include <seiche/formulation/formulation.h>
#include <seiche/grid/ghost_face_matrix.h>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of subsection "Free surface".
  struct FreeSurfaceParameters
  {
    double acceleration  = 0.1;  // gamma_a
    double pressure      = 0.1;  // gamma_p
    double velocity      = 0.1;  // gamma_v
    double velocity_time = 0.05; // T_v [s]
    double point_inertia = 1.;   // of the points' own extent

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const bool is_mixed) const;

    bool
    has_ghost_penalty() const
    {
      return acceleration > 0. || pressure > 0. || velocity > 0.;
    }
  };

  /**
   * @brief Coefficients of the ghost penalty on one face of a cut cell (Burman
   * 2010; Coombs 2023; doc/theory.md (6.1), (6.2)): jumps of normal derivatives
   * of acceleration, pressure and, at fragments, velocity. All terms share the
   * face's matrix B (GhostFaceMatrix).
   */
  struct GhostCoefficients
  {
    double acceleration = 0.; ///< gamma_a rho h^3: R_u += . B a
    double velocity     = 0.; ///< gamma_v rho h^3/T_v, fragments: R_u += . B v
    double pressure     = 0.; ///< gamma_p tau1 h: R_p += . B p
  };

  /// @p damping false leaves out the velocity term (projection of v_0).
  GhostCoefficients
  ghost_coefficients(const FreeSurfaceParameters &parameters,
                     const GhostFace             &face,
                     const double                 h,
                     const double                 density,
                     const double                 tau_momentum,
                     const bool                   damping);
} // namespace seiche

#endif
