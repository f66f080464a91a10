// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_ghost_terms_h
#define seiche_formulation_ghost_terms_h

#include <seiche/formulation/free_surface_parameters.h>
#include <seiche/formulation/term.h>

namespace seiche
{
  // Ghost penalties on jumps of normal derivatives across the faces of cut
  // cells (Burman 2010; Coombs 2023; doc/theory.md (6.1), (6.2)).

  struct GhostTerm : Term
  {
    double gamma; ///< [-]

    explicit GhostTerm(const double gamma)
      : gamma(gamma)
    {}

    bool
    acts_on_faces() const
    {
      return gamma > 0.;
    }
  };

  /// Of the acceleration: gamma_a c rho h^3.
  struct GhostAccelerationTerm : GhostTerm
  {
    explicit GhostAccelerationTerm(const FreeSurfaceParameters &parameters)
      : GhostTerm(parameters.acceleration)
    {}

    void
    add_ghost(const GhostFaceData &face, GhostCoefficients &sums) const
    {
      sums.acceleration += gamma * face.mass;
    }
  };

  /// Of the pressure: gamma_p c tau1 h.
  struct GhostPressureTerm : GhostTerm
  {
    explicit GhostPressureTerm(const FreeSurfaceParameters &parameters)
      : GhostTerm(parameters.pressure)
    {}

    void
    add_ghost(const GhostFaceData &face, GhostCoefficients &sums) const
    {
      sums.pressure += gamma * face.tau * face.h;
    }
  };

  /// Of the velocity, at fragments: gamma_v c rho h^3/T_v.
  struct GhostVelocityTerm : GhostTerm
  {
    double time; ///< [s]

    explicit GhostVelocityTerm(const FreeSurfaceParameters &parameters)
      : GhostTerm(parameters.velocity)
      , time(parameters.velocity_time)
    {}

    void
    add_ghost(const GhostFaceData &face, GhostCoefficients &sums) const
    {
      if (face.is_fragment)
        sums.velocity += gamma * face.mass / time;
    }
  };
} // namespace seiche

#endif
