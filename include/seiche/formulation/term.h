// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_term_h
#define seiche_formulation_term_h

#include <seiche/formulation/nodal_sums.h>
#include <seiche/formulation/point_state.h>
#include <seiche/formulation/tangent_sums.h>
#include <seiche/formulation/weak_form.h>

namespace seiche
{
  /**
   * @brief A term of a weak form: nothing yet. A term is a struct derived from
   * this that hides what it has of the functions below; TermList calls them of
   * all its terms, in this order, at each batch of points, then on the cell.
   */
  struct Term
  {
    // what the list needs at the points and from the cell
    static constexpr bool has_pressure   = false;
    static constexpr bool has_body_force = false;
    static constexpr bool is_viscous     = false;

    /// True if evaluate() reads PointState::velocity_gradient.
    template <int dim, int degree>
    bool
    needs_velocity_gradient(const CellData<dim, degree> &) const
    {
      return false;
    }

    /// J_n that counts, if any but 1.
    template <int dim, int degree>
    Lanes
    volume_ratio(const CellData<dim, degree> &, const unsigned int) const
    {
      return 1.;
    }

    /// Fields at the points that it alone knows, and its parts of the
    /// residuals r and g that subscales see (doc/theory.md (4.4)).
    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &) const
    {}

    /// Derivatives of r and g with respect to u.
    template <int dim, int degree>
    void
    linearize(PointState<dim, degree> &) const
    {}

    /// To what the test functions multiply.
    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &, PointForces<dim> &) const
    {}

    /// To the nodes themselves, if that is no product with N or grad N.
    template <int dim, int degree>
    void
    add_nodal_residual(const PointState<dim, degree> &,
                       NodalSums<dim, degree> &) const
    {}

    /// The derivative of both: to the products that terms share, or to the
    /// cell's matrices. Of the lanes PointState::n_points count.
    template <int dim, int degree>
    void
    add_tangent(const PointState<dim, degree> &,
                TangentSums<dim, degree> &,
                CellData<dim, degree> &) const
    {}

    /// Of a term that is no sum over points.
    template <int dim, int degree>
    void
    add_cell_residual(CellData<dim, degree> &) const
    {}
    template <int dim, int degree>
    void
    add_cell_tangent(CellData<dim, degree> &) const
    {}

    /// False if add_ghost() adds nothing on any face.
    bool
    acts_on_faces() const
    {
      return false;
    }
    void
    add_ghost(const GhostFaceData &, GhostCoefficients &) const
    {}
  };

  /// Of a term only what subscales see of it, r and g.
  template <typename FullTerm>
  struct Strong : Term
  {
    static constexpr bool has_pressure   = FullTerm::has_pressure;
    static constexpr bool has_body_force = FullTerm::has_body_force;
    static constexpr bool is_viscous     = FullTerm::is_viscous;

    explicit Strong(const FullTerm &full_term)
      : term(full_term)
    {}

    template <int dim, int degree>
    bool
    needs_velocity_gradient(const CellData<dim, degree> &cell) const
    {
      return term.needs_velocity_gradient(cell);
    }
    template <int dim, int degree>
    Lanes
    volume_ratio(const CellData<dim, degree> &cell, const unsigned int q) const
    {
      return term.volume_ratio(cell, q);
    }
    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      term.evaluate(state);
    }
    template <int dim, int degree>
    void
    linearize(PointState<dim, degree> &state) const
    {
      term.linearize(state);
    }

  private:
    const FullTerm term;
  };
} // namespace seiche

#endif
