// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_residual_moments_term_h
#define seiche_formulation_residual_moments_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /// V0 r.w + V0 g q, what orthogonal subscales project (doc/theory.md (4.5a)),
  /// with the weights of a lumped mass in place of w and q if it is one: in the
  /// residual's place, [N] and [m^dim].
  struct ResidualMomentsTerm : Term
  {
    bool lumped;

    explicit ResidualMomentsTerm(const bool lumped)
      : lumped(lumped)
    {}

    template <int dim, int degree>
    void
    add_nodal_residual(const PointState<dim, degree> &state,
                       NodalSums<dim, degree>        &sums) const
    {
      const auto &point = state.point;
      for (unsigned int a = 0; a < sums.n_nodes; ++a)
        {
          const Lanes weight =
            state.volume * (lumped ? point.weight(a) : point.N[a]);
          for (unsigned int i = 0; i < dim; ++i)
            sums.u[i][a] += weight * state.r[i];
          sums.p[a] += weight * state.g;
        }
    }
  };
} // namespace seiche

#endif
