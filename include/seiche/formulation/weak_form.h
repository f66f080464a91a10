// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_weak_form_h
#define seiche_formulation_weak_form_h

#include <seiche/formulation/cell_data.h>

namespace seiche
{
  /// A face of a cut cell, as ghost penalties see it.
  struct GhostFaceData
  {
    double h;           ///< mean edge length along the normal [m]
    double mass;        ///< c rho h^3, c = GhostFace::fluid [kg]
    double tau;         ///< c times transient tau1 [m^4/N], with a pressure
    bool   is_fragment; ///< GhostFace::fragment
  };

  /**
   * @brief Sums of the terms on a ghost face, which all are multiples of its
   * matrix B (GhostFaceMatrix; doc/theory.md (6.1), (6.2)).
   */
  struct GhostCoefficients
  {
    double acceleration = 0.; ///< R_u += . B a
    double velocity     = 0.; ///< R_u += . B v
    double pressure     = 0.; ///< R_p += . B p
  };

  /**
   * @brief A sum of terms: residual and tangent of one cell.
   *
   * One virtual call a cell; the loops over quadrature points and nodes are
   * inside.
   */
  template <int dim>
  class WeakForm
  {
  public:
    WeakForm(const bool has_body_force,
             const bool is_viscous,
             const bool acts_on_faces)
      : has_body_force(has_body_force)
      , is_viscous(is_viscous)
      , acts_on_faces(acts_on_faces)
    {}

    virtual ~WeakForm() = default;

    /// residual_u (and residual_p) of the cell.
    virtual void
    residual(CellData<dim, 1> &cell) const = 0;
    virtual void
    residual(CellData<dim, 2> &cell) const = 0;

    /// The blocks uu (up, pu, pp): derivative of residual().
    virtual void
    tangent(CellData<dim, 1> &cell) const = 0;
    virtual void
    tangent(CellData<dim, 2> &cell) const = 0;

    /// What is to be added on a ghost face.
    virtual GhostCoefficients
    ghost_coefficients(const GhostFaceData &face) const = 0;

    const bool has_body_force;
    const bool is_viscous;
    const bool acts_on_faces; ///< ghost_coefficients() are not all zero
  };
} // namespace seiche

#endif
