// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_ghost_penalty_h
#define seiche_formulation_ghost_penalty_h

#include <seiche/formulation/formulation.h>
#include <seiche/grid/fill.h>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /// prm entries of subsection "Free surface".
  struct FreeSurfaceParameters
  {
    double acceleration     = 0.1;  // gamma_a
    double pressure         = 0.1;  // gamma_p
    double velocity         = 0.1;  // gamma_v
    double velocity_time    = 0.05; // T_v [s]
    bool   sliver_treatment = true;

    void
    add_parameters(dealii::ParameterHandler &prm);

    bool
    has_ghost_penalty() const
    {
      return acceleration > 0. || pressure > 0. || velocity > 0.;
    }
  };

  /// Coefficients of one ghost face: all terms share its matrix
  /// B = int_F [dn N_a][dn N_b] [m^(dim-3)].
  struct GhostCoefficients
  {
    double acceleration = 0.; ///< gamma_a rho h^3: R_u += . B a
    double velocity     = 0.; ///< gamma_v rho h^3/T_v, thin faces: R_u += . B v
    double pressure     = 0.; ///< gamma_p tau1 h: R_p += . B p
  };

  /**
   * @brief Ghost penalty on the faces of cut cells (Burman 2010; Coombs 2023;
   * doc/theory.md): jumps of normal derivatives of acceleration, pressure and,
   * on thin cells, velocity. Row sums are zero: momentum is conserved.
   */
  template <int dim>
  struct GhostFaceMatrix
  {
    static constexpr unsigned int max_nodes = 2u << dim;

    /// Nodes of the two cells: 3 in the direction of the normal. With hanging
    /// nodes the list is that of one cell and then of the other, and a node
    /// may occur in it twice.
    unsigned int n_nodes = 0;
    unsigned int nodes[max_nodes]; ///< local node indices
    double       B[max_nodes][max_nodes];
    double       h; ///< mean edge length along the normal [m]

    /// Local.
    void
    evaluate(const GhostFace &face, const Occupancy<dim> &occupancy);

  private:
    void
    evaluate_conforming(const GhostFace &face, const Occupancy<dim> &occupancy);
    void
    evaluate_hanging(const GhostFace &face, const Occupancy<dim> &occupancy);
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
