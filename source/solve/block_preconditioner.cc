// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/block_preconditioner.h>
#include <seiche/solve/epetra_copy.h>

#include <EpetraExt_MatrixMatrix.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include <array>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Above this ratio of stiffness to inertia A is no mass matrix any more:
    /// measured with large tau2 and with viscosity (doc/performance.md).
    constexpr double mass_dominated_below = 12.;

    /// Factors of the diagonal before ILU(0), tried in this order: the ghost
    /// penalty is no M-matrix, and without a stronger diagonal the factors of
    /// spray can be unstable (applied to diag(A), which should give about 1,
    /// they gave 5e27). The first saves iterations besides.
    constexpr std::array<double, 3> ilu_diagonal_factors = {{1.05, 1.2, 1.5}};
    constexpr double                ilu_unstable_above   = 1e4;

    /// Schur complements with fewer rows (all ranks) are factorised: measured
    /// on dam_break_2d and column_collapse_3d (doc/performance.md).
    template <int dim>
    constexpr types::global_dof_index schur_direct_below =
      dim == 2 ? 2000 : 1000;

    /// The same for those that are symmetric, on a single rank.
    template <int dim>
    constexpr types::global_dof_index schur_cholesky_below =
      dim == 2 ? 8000 : 1500;

    /// Least volume of a node [(smallest edge/degree)^dim] for the viscous
    /// part of S^-1, which divides by it: a point on a grid line gives nodes
    /// beyond it 1e-50 of one. Measured, doc/performance.md.
    constexpr double least_volume = 0.1;

    /// A shift that makes the singular Laplacian of a closed box definite.
    constexpr double closed_shift = 1e-7;

    /// Settings of both hierarchies, in deal.II's terms.
    TrilinosWrappers::PreconditionAMG::AdditionalData
    amg_settings()
    {
      TrilinosWrappers::PreconditionAMG::AdditionalData data;
      data.elliptic              = true;
      data.smoother_sweeps       = 2;
      data.aggregation_threshold = 1e-4;
      return data;
    }
  } // namespace

  template <int dim>
  void
  BlockPreconditioner<dim>::reset()
  {
    schur_generation    = 0;
    velocity_generation = 0;
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::initialize(const BlockMatrix<dim>  &system_matrix,
                                       const Assembler<dim>    &assembler,
                                       const MaterialConstants &material,
                                       const Vector            &mass,
                                       const bool               is_closed)
  {
    matrix                            = &system_matrix;
    kept                              = false;
    closed                            = is_closed;
    const StepCoefficients &c         = assembler.coefficients();
    const Occupancy<dim>   &occupancy = matrix->occupancy;
    const double            viscosity = material.viscosity(c);
    const double            inertia   = material.density * c.inertia;
    const double            h         = occupancy.smallest_extent();
    const double            bulk      = matrix->has_pressure() ?
                                          assembler.reference_tau(h).continuity :
                                          material.bulk_modulus;
    initialize_velocity((2. * viscosity * c.rate + bulk) / (inertia * h * h),
                        c.inertia);
    if (!matrix->has_pressure())
      return;

    initialize_schur(assembler, material, mass);
    viscous_factor = 2. * viscosity * c.rate;
    if (viscous_factor > 0.)
      {
        volume.reinit(mass, /*omit_zeroing=*/true);
        const double least =
          least_volume * std::pow(h / occupancy.fe.degree, dim);
        for (unsigned int i = 0; i < occupancy.n_own_nodes(); ++i)
          volume.local_element(i) =
            std::max(mass.local_element(i) / material.density, least);
      }
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::initialize_velocity(const double stiffness,
                                                const double inertia)
  {
    velocity_factor = 1.;
    if (velocity_generation == matrix->generation() &&
        (velocity_amg != nullptr) == (stiffness >= mass_dominated_below))
      {
        velocity_factor = velocity_inertia / inertia;
        kept            = true;
        return;
      }
    velocity_amg.reset();
    if (stiffness < mass_dominated_below)
      make_ilu();
    else
      make_velocity_amg();
    velocity_generation = matrix->generation();
    velocity_inertia    = inertia;
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::make_ilu()
  {
    for (const double factor : ilu_diagonal_factors)
      {
        ilu.initialize(*matrix, factor);
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
    velocity_matrix         = epetra_copy(*matrix, displacement, displacement);
    const unsigned int n    = velocity_matrix->NumMyRows();
    auto               data = amg_settings();
    data.constant_modes.assign(dim, std::vector<bool>(n, false));
    for (unsigned int i = 0; i < n; ++i)
      data.constant_modes[i % dim][i] = true;
    velocity_amg = std::make_unique<TrilinosWrappers::PreconditionAMG>();
    velocity_amg->initialize(*velocity_matrix, data);
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::initialize_schur(const Assembler<dim>    &assembler,
                                             const MaterialConstants &material,
                                             const Vector            &mass)
  {
    const StepCoefficients        &c = assembler.coefficients();
    const StabilizationParameters &stabilization =
      assembler.formulation.stabilization;
    const FieldRange displacement = {0, dim}, pressure = {dim, 1};
    const bool       scaled_block =
      stabilization.is_active() && stabilization.tau_is_uniform();
    // the hierarchy belongs to L/rho = D/(rho tau1); S = (L/rho)/C_a
    const double tau1 =
      scaled_block ?
        assembler.reference_tau(matrix->occupancy.smallest_extent()).momentum :
        1.;
    schur_factor = scaled_block ? c.inertia : 1.;
    if (scaled_block && schur_generation == matrix->generation())
      {
        kept = true;
        return;
      }

    schur_amg.reset(); // its smoothers refer to the old matrix
    schur_cholesky.clear();
    schur_generation                      = matrix->generation();
    const types::global_dof_index n_nodes = matrix->occupancy.n_global_nodes();
    const double                  shift   = closed ? closed_shift : 0.;
    if (scaled_block)
      {
        const double              scale   = 1. / (material.density * tau1);
        const std::vector<double> surface = surface_term(c.inertia);
        if (n_nodes < schur_cholesky_below<dim> &&
            Utilities::MPI::n_mpi_processes(mass.get_mpi_communicator()) == 1)
          {
            LowerTriangle L = pressure_triangle(scale, surface, shift);
            if (schur_cholesky.initialize(L, matrix->occupancy.generation()))
              return;
          }
        schur = epetra_copy(*matrix, pressure, pressure, scale);
        for (unsigned int node = 0; node < surface.size(); ++node)
          diagonal_entry(*schur, node) += surface[node];
      }
    else
      {
        const auto    D = epetra_copy(*matrix, pressure, pressure);
        const auto    C = epetra_copy(*matrix, pressure, displacement);
        const auto    G = epetra_copy(*matrix, displacement, pressure);
        Epetra_Vector scale(G->RowMap());
        for (int i = 0; i < scale.MyLength(); ++i)
          {
            // where tau1 is large, D and C A^-1 G nearly cancel for smooth
            // pressures: the diagonal of a consistent mass is too small then
            const double inertia = c.inertia * mass.local_element(i / dim);
            scale[i] = 1. / (stabilization.is_active() && inertia > 0. ?
                               inertia :
                               matrix->diagonal(i / dim, i % dim));
          }
        G->LeftScale(scale);
        Epetra_CrsMatrix product(Copy, D->RowMap(), 0);
        EpetraExt::MatrixMatrix::Multiply(*C, false, *G, false, product);
        schur = std::make_unique<Epetra_CrsMatrix>(Copy, D->RowMap(), 0);
        Epetra_CrsMatrix *sum = schur.get();
        EpetraExt::MatrixMatrix::Add(*D, false, 1., product, false, -1., sum);
        schur->FillComplete();
      }
    if (closed)
      for (int i = 0; i < schur->NumMyRows(); ++i)
        diagonal_entry(*schur, i) *= 1. + shift;
    if (n_nodes < schur_direct_below<dim> && schur_factors.initialize(*schur))
      return;
    schur_amg = std::make_unique<TrilinosWrappers::PreconditionAMG>();
    // measured (doc/performance.md): fewer iterations than with Chebyshev
    Teuchos::ParameterList              settings;
    std::unique_ptr<Epetra_MultiVector> constant_modes;
    amg_settings().set_parameters(settings, constant_modes, *schur);
    settings.set("smoother: type", "symmetric Gauss-Seidel");
    settings.set("smoother: sweeps", 1);
    settings.set("eigen-analysis: type", "Anorm");
    schur_amg->initialize(*schur, settings);
  }

  template <int dim>
  std::vector<double>
  BlockPreconditioner<dim>::surface_term(const double factor) const
  {
    BlockVector x(2), y(2);
    x.block(0).reinit(matrix->occupancy.vector_partitioner());
    x.block(1).reinit(matrix->occupancy.scalar_partitioner());
    x.collect_sizes();
    y.reinit(x);
    x.block(1) = 1.;
    matrix->gradient(x.block(0), x.block(1));
    x.block(1)               = 0.;
    const unsigned int n_own = matrix->occupancy.n_own_nodes();
    for (unsigned int node = 0; node < n_own; ++node)
      for (unsigned int i = 0; i < dim; ++i)
        x.block(0).local_element(node * dim + i) /= matrix->diagonal(node, i);
    matrix->vmult(y, x);
    std::vector<double> result(n_own);
    for (unsigned int node = 0; node < n_own; ++node)
      result[node] = factor * std::max(0., -y.block(1).local_element(node));
    return result;
  }

  template <int dim>
  LowerTriangle
  BlockPreconditioner<dim>::pressure_triangle(
    const double               scale,
    const std::vector<double> &diagonal_term,
    const double               shift) const
  {
    const NodePattern<dim> &pattern = matrix->sparsity();
    LowerTriangle           result;
    for (unsigned int node = 0; node < diagonal_term.size(); ++node)
      {
        result.row.push_back(node);
        result.value.push_back(
          (scale * matrix->diagonal(node, dim) + diagonal_term[node]) *
          (1. + shift));
        if (!matrix->is_empty(node))
          for (unsigned int k = pattern.diagonal_of(node) + 1;
               k < pattern.row_begin(node + 1);
               ++k)
            if (const double value = matrix->value(k, dim, dim); value != 0.)
              {
                result.row.push_back(pattern.column_of(k));
                result.value.push_back(scale * value);
              }
        result.begin.push_back(result.row.size());
      }
    return result;
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
  BlockPreconditioner<dim>::apply_to_pressure(Vector &z, const Vector &r) const
  {
    if (schur_amg)
      schur_amg->vmult(z, r);
    else if (!schur_cholesky.is_empty())
      schur_cholesky.solve(z.begin(), r.begin());
    else
      {
        std::copy(r.begin(), r.end(), schur_factors.right_hand_side().Values());
        schur_factors.solve();
        const Epetra_Vector &x = schur_factors.solution();
        std::copy_n(x.Values(), x.MyLength(), z.begin());
      }
    z *= schur_factor;
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
    if (closed)
      scratch_p.add(-scratch_p.mean_value());
    apply_to_pressure(z.block(1), scratch_p);
    if (viscous_factor > 0.)
      for (unsigned int i = 0; i < volume.locally_owned_size(); ++i)
        z.block(1).local_element(i) +=
          viscous_factor * scratch_p.local_element(i) / volume.local_element(i);
    if (closed)
      z.block(1).add(-z.block(1).mean_value());

    scratch_u.reinit(r.block(0), /*omit_zeroing=*/true);
    matrix->gradient(scratch_u, z.block(1));
    scratch_u.sadd(-1., 1., r.block(0));
    apply_to_velocity(z.block(0), scratch_u);
  }

  template class BlockPreconditioner<2>;
  template class BlockPreconditioner<3>;
} // namespace seiche
