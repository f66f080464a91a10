// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/block_preconditioner.h>

#include <EpetraExt_MatrixMatrix.h>
#include <Epetra_Vector.h>

#include <array>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Chebyshev sweeps on the velocity block: the interval of D^-1 A is
    /// [largest/ratio, largest] with Gershgorin's bound for the largest.
    constexpr unsigned int chebyshev_degree = 2;
    constexpr double       chebyshev_ratio  = 12.;

    /// Above this ratio of stiffness to inertia A is no mass matrix any more.
    constexpr double mass_dominated_below = 4.;

    /// A solve with more iterations than this calls for ILU(0) in 3D too.
    constexpr unsigned int slow_solve = 30;

    /// Factors of the diagonal before ILU(0), tried in this order: the ghost
    /// penalty is no M-matrix, and without a stronger diagonal the factors of
    /// spray can be unstable (applied to diag(A), which should give about 1,
    /// they gave 5e27). The first saves iterations besides.
    constexpr std::array<double, 3> ilu_diagonal_factors = {{1.05, 1.2, 1.5}};
    constexpr double                ilu_unstable_above   = 1e4;

    /// A shift that makes the singular Laplacian of a closed box definite.
    constexpr double closed_shift = 1e-7;

    /// Largest row sum of |D^-1 A|.
    double
    gershgorin_bound(const Epetra_CrsMatrix &matrix)
    {
      double local = 0.;
      for (int i = 0; i < matrix.NumMyRows(); ++i)
        {
          int     n;
          double *values;
          int    *columns;
          matrix.ExtractMyRowView(i, n, values, columns);
          double sum = 0.;
          for (int k = 0; k < n; ++k)
            sum += std::abs(values[k]);
          local = std::max(local, sum / std::abs(diagonal_entry(matrix, i)));
        }
      double global = 0.;
      matrix.Comm().MaxAll(&local, &global, 1);
      return global;
    }
  } // namespace

  template <int dim>
  void
  BlockPreconditioner<dim>::reset()
  {
    schur_amg.reset();
    velocity_generation = 0;
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::report(const unsigned int iterations)
  {
    if (iterations > slow_solve)
      use_ilu = true;
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

    initialize_schur(assembler, material);
    viscous_factor = 2. * viscosity * c.rate;
    if (viscous_factor > 0.)
      {
        volume.reinit(mass, /*omit_zeroing=*/true);
        for (unsigned int i = 0; i < occupancy.n_own_nodes(); ++i)
          volume.local_element(i) = mass.local_element(i) / material.density;
      }
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::initialize_velocity(const double stiffness,
                                                const double inertia)
  {
    velocity_factor = 1.;
    if (stiffness < mass_dominated_below && !use_ilu)
      {
        ilu.reset();
        velocity_amg.reset();
        make_chebyshev(); // cheap: nothing to keep
        return;
      }
    if (velocity_generation == matrix->generation() &&
        (velocity_amg != nullptr) == (stiffness >= mass_dominated_below))
      {
        velocity_factor = velocity_inertia / inertia;
        return;
      }
    chebyshev.reset();
    ilu.reset();
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
  BlockPreconditioner<dim>::make_chebyshev()
  {
    const Epetra_CrsMatrix &A = matrix->block(BlockMatrix<dim>::uu);
    chebyshev                 = std::make_unique<Ifpack_Chebyshev>(&A);
    Teuchos::ParameterList list;
    const double           largest = gershgorin_bound(A);
    list.set("chebyshev: degree", static_cast<int>(chebyshev_degree));
    list.set("chebyshev: max eigenvalue", largest);
    list.set("chebyshev: ratio eigenvalue", chebyshev_ratio);
    list.set("chebyshev: min eigenvalue", largest / chebyshev_ratio);
    list.set("chebyshev: zero starting solution", true);
    chebyshev->SetParameters(list);
    chebyshev->Initialize();
    chebyshev->Compute();
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::make_ilu()
  {
    const Epetra_CrsMatrix &A = matrix->block(BlockMatrix<dim>::uu);
    Epetra_Vector           diagonal(A.RowMap()), result(A.RowMap());
    A.ExtractDiagonalCopy(diagonal);
    for (const double factor : ilu_diagonal_factors)
      {
        // Ifpack's interface wants a matrix that it may change, but does not
        ilu = std::make_unique<Ifpack_ILU>(const_cast<Epetra_CrsMatrix *>(&A));
        Teuchos::ParameterList list;
        list.set("fact: level-of-fill", 0);
        list.set("fact: relative threshold", factor);
        ilu->SetParameters(list);
        ilu->Initialize();
        ilu->Compute();
        ilu->ApplyInverse(diagonal, result);
        double largest = 0.;
        result.NormInf(&largest);
        if (largest < ilu_unstable_above)
          return;
      }
    ilu.reset();
    make_chebyshev();
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::make_velocity_amg()
  {
    const Epetra_CrsMatrix &A = matrix->block(BlockMatrix<dim>::uu);
    TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.smoother_sweeps       = 2;
    data.aggregation_threshold = 1e-4;
    const unsigned int n       = A.NumMyRows();
    data.constant_modes.assign(dim, std::vector<bool>(n, false));
    for (unsigned int i = 0; i < n; ++i)
      data.constant_modes[i % dim][i] = true;
    velocity_amg = std::make_unique<TrilinosWrappers::PreconditionAMG>();
    velocity_amg->initialize(A, data);
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::initialize_schur(const Assembler<dim>    &assembler,
                                             const MaterialConstants &material)
  {
    const StepCoefficients        &c = assembler.coefficients();
    const StabilizationParameters &stabilization =
      assembler.formulation.stabilization;
    const Epetra_CrsMatrix &D = matrix->block(BlockMatrix<dim>::pp);
    const bool              scaled_block =
      stabilization.is_active() && stabilization.tau_is_uniform();
    // the hierarchy belongs to L/rho = D/(rho tau1); S = (L/rho)/C_a
    const double tau1 =
      scaled_block ?
        assembler.reference_tau(matrix->occupancy.smallest_extent()).momentum :
        1.;
    schur_factor = scaled_block ? c.inertia : 1.;
    if (scaled_block && schur_amg && schur_generation == matrix->generation())
      return;

    if (scaled_block)
      {
        schur = std::make_unique<Epetra_CrsMatrix>(D);
        schur->Scale(1. / (material.density * tau1));
        add_surface_term(c.inertia);
      }
    else
      {
        Epetra_Vector diagonal(matrix->block(BlockMatrix<dim>::uu).RowMap());
        matrix->block(BlockMatrix<dim>::uu).ExtractDiagonalCopy(diagonal);
        diagonal.Reciprocal(diagonal);
        Epetra_CrsMatrix G(matrix->block(BlockMatrix<dim>::up));
        G.LeftScale(diagonal);
        auto product = std::make_unique<Epetra_CrsMatrix>(Copy, D.RowMap(), 0);
        EpetraExt::MatrixMatrix::Multiply(
          matrix->block(BlockMatrix<dim>::pu), false, G, false, *product);
        schur = std::make_unique<Epetra_CrsMatrix>(Copy, D.RowMap(), 0);
        Epetra_CrsMatrix *sum = schur.get();
        EpetraExt::MatrixMatrix::Add(D, false, 1., *product, false, -1., sum);
        schur->FillComplete();
      }
    if (closed)
      {
        for (int i = 0; i < schur->NumMyRows(); ++i)
          diagonal_entry(*schur, i) *= 1. + closed_shift;
      }
    TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.smoother_sweeps       = 2;
    data.aggregation_threshold = 1e-4;
    schur_amg = std::make_unique<TrilinosWrappers::PreconditionAMG>();
    schur_amg->initialize(*schur, data);
    schur_generation = matrix->generation();
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::add_surface_term(const double factor)
  {
    const Epetra_CrsMatrix &A = matrix->block(BlockMatrix<dim>::uu);
    const Epetra_CrsMatrix &G = matrix->block(BlockMatrix<dim>::up);
    const Epetra_CrsMatrix &C = matrix->block(BlockMatrix<dim>::pu);
    Epetra_Vector           ones(G.DomainMap()), force(G.RangeMap());
    Epetra_Vector           flux(C.RangeMap());
    ones.PutScalar(1.);
    G.Multiply(false, ones, force);
    for (int i = 0; i < force.MyLength(); ++i)
      force[i] /= diagonal_entry(A, i);
    C.Multiply(false, force, flux);
    for (int i = 0; i < flux.MyLength(); ++i)
      diagonal_entry(*schur, i) += factor * std::max(0., -flux[i]);
  }

  template <int dim>
  void
  BlockPreconditioner<dim>::vmult(BlockVector &z, const BlockVector &r) const
  {
    const auto apply_to_velocity = [&](Vector &dst, const Vector &src) {
      const Epetra_Map   &map = matrix->block(BlockMatrix<dim>::uu).RowMap();
      const Epetra_Vector source(View, map, const_cast<double *>(src.begin()));
      Epetra_Vector       target(View, map, dst.begin());
      if (velocity_amg)
        velocity_amg->vmult(dst, src);
      else if (ilu)
        ilu->ApplyInverse(source, target);
      else
        chebyshev->ApplyInverse(source, target);
      if (velocity_factor != 1.)
        dst *= velocity_factor;
    };
    if (!matrix->has_pressure())
      {
        apply_to_velocity(z.block(0), r.block(0));
        return;
      }

    scratch_p.reinit(r.block(1), /*omit_zeroing=*/true);
    scratch_p.equ(1. / pressure_row_scale, r.block(1));
    if (closed)
      scratch_p.add(-scratch_p.mean_value());
    schur_amg->vmult(z.block(1), scratch_p);
    z.block(1) *= schur_factor;
    if (viscous_factor > 0.)
      for (unsigned int i = 0; i < volume.locally_owned_size(); ++i)
        if (volume.local_element(i) > 0.)
          z.block(1).local_element(i) += viscous_factor *
                                         scratch_p.local_element(i) /
                                         volume.local_element(i);
    if (closed)
      z.block(1).add(-z.block(1).mean_value());

    scratch_u.reinit(r.block(0), /*omit_zeroing=*/true);
    const Epetra_CrsMatrix &G = matrix->block(BlockMatrix<dim>::up);
    const Epetra_Vector     pressure(View, G.DomainMap(), z.block(1).begin());
    Epetra_Vector           force(View, G.RangeMap(), scratch_u.begin());
    G.Multiply(false, pressure, force);
    scratch_u.sadd(-1., 1., r.block(0));
    apply_to_velocity(z.block(0), scratch_u);
  }

  template class BlockPreconditioner<2>;
  template class BlockPreconditioner<3>;
} // namespace seiche
