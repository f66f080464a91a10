// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/epetra_copy.h>
#include <seiche/solve/block_preconditioner.h>

#include <array>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Above this ratio of stiffness to inertia A is no mass matrix any more:
    /// measured with large tau2 and with viscosity (doc/performance.md).
    constexpr double mass_dominated_below = 12.;

    /// Factors serve another matrix whose stiffness over inertia, plus one, is
    /// within this ratio of that of their own.
    constexpr double alike_within = 4.;

    /// Factors of the diagonal before ILU(0), tried in this order: the ghost
    /// penalty is no M-matrix, and without a stronger diagonal the factors of
    /// spray can be unstable (applied to diag(A) they should give about 1).
    /// The first saves iterations besides.
    constexpr std::array<double, 3> ilu_diagonal_factors = {{1.05, 1.2, 1.5}};
    constexpr double                ilu_unstable_above   = 1e4;
  } // namespace

  template <int dim>
  BlockPreconditioner<dim>::BlockPreconditioner(
    const MultigridMethod &multigrid)
    : schur(multigrid)
  {}

  template <int dim>
  void
  BlockPreconditioner<dim>::reset()
  {
    schur.reset();
    velocity_generation = 0;
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::initialize(const BlockMatrix<dim> &system_matrix,
                                       const Assembler<dim>   &assembler,
                                       const Vector           &mass)
  {
    matrix                            = &system_matrix;
    kept                              = false;
    const StepCoefficients &c         = assembler.coefficients();
    const Occupancy<dim>   &occupancy = matrix->occupancy;
    const FluidProperties  &fluid     = assembler.materials.largest();
    const double            h         = occupancy.smallest_extent();
    const double            bulk =
      matrix->has_pressure() ?
                   assembler.reference_tau(h, assembler.body_force_scale()).continuity :
                   assembler.formulation.volume_law.bulk_modulus;
    initialize_velocity((fluid.stiffness(c.rate) + bulk) /
                          (fluid.inertia(c.inertia) * h * h),
                        c.inertia);
    if (!matrix->has_pressure())
      return;

    if (schur.initialize(*matrix, assembler, mass))
      kept = true;
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::initialize_velocity(const double stiffness,
                                                const double inertia)
  {
    velocity_factor    = 1.;
    const bool by_mass = stiffness < mass_dominated_below;
    const bool is_like =
      (1. + stiffness) < alike_within * (1. + velocity_stiffness) &&
      (1. + velocity_stiffness) < alike_within * (1. + stiffness);
    if (velocity_generation == matrix->generation() &&
        by_mass == mass_dominated && is_like)
      {
        velocity_factor = velocity_inertia / inertia;
        kept            = true;
        return;
      }
    velocity_amg.reset();
    mass_dominated = by_mass;
    if (mass_dominated)
      make_ilu();
    else
      make_velocity_amg();
    velocity_generation = matrix->generation();
    velocity_inertia    = inertia;
    velocity_stiffness  = stiffness;
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::make_ilu()
  {
    const ForeignRows<dim> foreign(*matrix);
    for (const double factor : ilu_diagonal_factors)
      {
        ilu.initialize(*matrix, foreign, factor);
        if (ilu.growth(*matrix) < ilu_unstable_above)
          return;
      }
    make_velocity_amg();
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::make_velocity_amg()
  {
    const FieldRange displacement = {0, dim};
    velocity_matrix      = epetra_copy(*matrix, displacement, displacement);
    const unsigned int n = velocity_matrix->NumMyRows();
    TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.smoother_sweeps       = 2;
    data.aggregation_threshold = 1e-4;
    data.constant_modes.assign(dim, std::vector<bool>(n, false));
    for (unsigned int i = 0; i < n; ++i)
      data.constant_modes[i % dim][i] = true;
    velocity_amg = std::make_unique<TrilinosWrappers::PreconditionAMG>();
    velocity_amg->initialize(*velocity_matrix, data);
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::apply_to_velocity(Vector &z, const Vector &r) const
  {
    if (velocity_amg)
      velocity_amg->vmult(z, r);
    else
      ilu.vmult(z, r);
    if (velocity_factor != 1.)
      z *= velocity_factor;
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::vmult(BlockVector &z, const BlockVector &r) const
  {
    if (!matrix->has_pressure())
      {
        apply_to_velocity(z.block(0), r.block(0));
        return;
      }

    scratch_p.reinit(r.block(1), /*omit_zeroing=*/true);
    scratch_p.equ(1. / pressure_row_scale, r.block(1));
    schur.vmult(z.block(1), scratch_p);

    scratch_u.reinit(r.block(0), /*omit_zeroing=*/true);
    matrix->gradient(scratch_u, z.block(1));
    scratch_u.sadd(-1., 1., r.block(0));
    apply_to_velocity(z.block(0), scratch_u);
  }

  template class BlockPreconditioner<2>;
  template class BlockPreconditioner<3>;
} // namespace seiche
