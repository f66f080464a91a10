// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_cell_data_h
#define seiche_formulation_cell_data_h

#include <seiche/algebra/cell_matrix.h>
#include <seiche/formulation/stabilization.h>
#include <seiche/quadrature/quadrature.h>
#include <seiche/scene/solid.h>
#include <seiche/space/point_batch.h>

#include <deal.II/base/tensor.h>

#include <algorithm>

namespace seiche
{
  /**
   * @brief Everything a weak form reads and writes of one cell; acceleration
   * and velocity of the step as in doc/theory.md (3.1), (8.7).
   *
   * Allocated once by the assembler. The node index runs fastest in every
   * array, so that loops over nodes fill the vector registers.
   */
  template <int dim, int degree>
  struct CellData : public CellMatrix<dim, degree>
  {
    using Shape = Basis<dim, degree>;
    using CellMatrix<dim, degree>::n_nodes;
    using NodalScalar = double[n_nodes];
    using NodalVector = double[dim][n_nodes];

    // --- input
    StepCoefficients  coefficients;
    CellGeometry<dim> geometry;
    bool              lumped      = false; ///< inertia at the nodes
    bool              is_cut      = false; ///< by the free surface
    double            start_speed = 0.;    ///< |v_0| at the centre [m/s]
    FluidProperties   fluid;    ///< means of the cell at the step's start
    double extent_inertia = 0.; ///< of the points' own extent [kg], see
                                ///< formulation/point_inertia_term.h
    CellQuadrature<dim> quadrature;
    /// Of solids, where there is fluid at it; null: none.
    const std::vector<WallPoint<dim>> *wall = nullptr;
    /// There are but drops in the cell, to which the wall is all of it.
    bool                                 wall_is_dry   = false;
    const std::vector<SolidInStep<dim>> *solids        = nullptr; ///< by number
    const Material                      *wall_material = nullptr; ///< at it
    /// The pressure is known, not up to a constant only: walls of solids whose
    /// condition allows it may be left.
    bool wall_may_be_left = false;

    alignas(64) NodalVector displacement;  ///< u [m]
    alignas(64) NodalVector acceleration;  ///< C_a u + offset, and the
                                           ///< Coriolis acceleration [m/s^2]
    alignas(64) NodalVector rate_velocity; ///< c_r u + offset [m/s]
    alignas(64) NodalScalar pressure;      ///< p [Pa], mixed form only
    alignas(64) NodalScalar old_pressure; ///< at t_n, at walls that may be left

    /// Frozen during Newton's iteration; zero without subscales.
    Tau tau;
    /// What r has beside the pressure gradient, with subscales.
    ResidualParts residual_parts;

    /// Orthogonal subscales: nodal projections of the momentum residual
    /// [N/m^dim] and of the constraint [-].
    bool orthogonal = false;
    alignas(64) NodalVector projected_momentum;
    alignas(64) NodalScalar projected_constraint;

    /// In a tank that turns: of the Coriolis acceleration coriolis v, v the
    /// rate's velocity, which is part of the acceleration [1/s].
    bool                   turns = false;
    dealii::Tensor<2, dim> coriolis;

    /// Body acceleration [m/s^2]: one value, or one per quadrature point.
    dealii::Tensor<1, dim>               constant_body_force;
    std::array<std::vector<double>, dim> body_force; // by component
    bool                                 body_force_varies = false;

    // --- output; pressure rows and columns in the mixed form only
    alignas(64) NodalVector residual_u; ///< [N]
    alignas(64) NodalScalar residual_p; ///< [m^dim]
    std::vector<SolidReaction<dim>> solid_reactions;

    /// Derivative of the acceleration with respect to u, beside that of the
    /// scheme, over C_a: d(acceleration) = C_a (I + this) du [-].
    dealii::Tensor<2, dim>
    coriolis_over_inertia() const
    {
      return coefficients.rate / coefficients.inertia * coriolis;
    }

    /// f(i, k, share) for the entries of coriolis_over_inertia() that are not
    /// zero in every frame.
    template <typename Function>
    void
    for_each_coriolis_share(const Function &f) const
    {
      if (!turns)
        return;
      const dealii::Tensor<2, dim> shares = coriolis_over_inertia();
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          if (i != k)
            f(i, k, shares[i][k]);
    }

    /// At the point q, or at as many as a Number has.
    template <typename Number = double>
    dealii::Tensor<1, dim, Number>
    body_force_at(const unsigned int q) const
    {
      dealii::Tensor<1, dim, Number> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = body_force_varies ? load<Number>(&body_force[d][q]) :
                                        Number(constant_body_force[d]);
      return result;
    }

    /// The largest in the cell [m/s^2].
    double
    largest_body_force() const
    {
      if (!body_force_varies)
        return constant_body_force.norm();
      double square = 0.;
      for (unsigned int q = 0; q < quadrature.size; ++q)
        square = std::max(square, body_force_at(q).norm_square());
      return std::sqrt(square);
    }
  };
} // namespace seiche

#endif
