// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/epetra_copy.h>
#include <seiche/solve/schur_complement.h>

#include <EpetraExt_MatrixMatrix.h>
#include <Epetra_Vector.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Symmetric ones with fewer rows are factorised on a single rank:
    /// measured on dam_break_2d and column_collapse_3d (doc/performance.md).
    template <int dim>
    constexpr types::global_dof_index cholesky_below = dim == 2 ? 8000 : 500;

    /// Least volume of a node [(smallest edge/degree)^dim] for the viscous
    /// part of S^-1, which divides by it: a point on a grid line gives nodes
    /// beyond it 1e-50 of one. Measured, doc/performance.md.
    constexpr double least_volume = 0.1;

    /// Share of the diagonal that makes the singular Laplacian of closed
    /// chambers definite.
    constexpr double closed_shift = 1e-7;

    DistributedRows
    rows_of(const Epetra_CrsMatrix &matrix, const int first)
    {
      DistributedRows result;
      result.first = first;
      for (int row = 0; row < matrix.NumMyRows(); ++row)
        {
          int     n;
          double *values;
          int    *columns;
          matrix.ExtractMyRowView(row, n, values, columns);
          result.length.push_back(n);
          for (int k = 0; k < n; ++k)
            {
              result.column.push_back(matrix.GCID(columns[k]));
              result.value.push_back(values[k]);
            }
        }
      return result;
    }
  } // namespace

  template <int dim>
  SchurComplement<dim>::SchurComplement(const MultigridMethod &m)
    : method(m)
  {}

  template <int dim>
  bool
  SchurComplement<dim>::initialize(const BlockMatrix<dim> &system_matrix,
                                   const Assembler<dim>   &assembler,
                                   const Vector           &mass)
  {
    matrix                                = &system_matrix;
    closed                                = assembler.closed_chambers();
    const StepCoefficients &c             = assembler.coefficients();
    const Stabilization    &stabilization = *assembler.formulation.subscales;
    const double            h             = matrix->occupancy.smallest_extent();
    viscous                               = assembler.viscous_stiffness(
      mass, least_volume * std::pow(h / matrix->occupancy.fe.degree, dim));

    // the hierarchy belongs to L/rho = D/(rho tau1); S = (L/rho)/C_a, where
    // the residual's inertia makes C vanish inside the fluid
    const bool scaled =
      stabilization.is_active && assembler.tau_follows_density() &&
      stabilization.residual_parts(/*orthogonal=*/false).inertia;
    factor = scaled ? c.inertia : 1.;
    if (scaled && generation == matrix->generation())
      return true;

    generation = scaled ? matrix->generation() : 0;
    hierarchy.reset();
    cholesky.clear();
    const MPI_Comm communicator = mass.get_mpi_communicator();
    if (!scaled)
      {
        hierarchy =
          method.make(product(stabilization.is_active ? c.inertia : 0., mass),
                      communicator);
        return false;
      }
    const double scale =
      1. / (assembler.materials.largest().density *
            assembler.reference_tau(h, /*force=*/0.).momentum);
    const std::vector<double> surface = surface_term(c.inertia);
    if (method.factorises_small &&
        matrix->occupancy.nodes.n_global() < cholesky_below<dim> &&
        Utilities::MPI::n_mpi_processes(communicator) == 1)
      {
        LowerTriangle L = scaled_triangle(scale, surface);
        if (cholesky.initialize(L, matrix->occupancy.nodes.generation()))
          return false;
      }
    hierarchy = method.make(scaled_rows(scale, surface), communicator);
    return false;
  }

  template <int dim>
  DistributedRows
  SchurComplement<dim>::product(const double inertia, const Vector &mass) const
  {
    const FieldRange displacement = {0, dim}, pressure = {dim, 1};
    const auto       D = epetra_copy(*matrix, pressure, pressure);
    const auto       C = epetra_copy(*matrix, pressure, displacement);
    const auto       G = epetra_copy(*matrix, displacement, pressure);
    Epetra_Vector    scale(G->RowMap());
    for (int i = 0; i < scale.MyLength(); ++i)
      {
        // where tau1 is large, D and C A^-1 G nearly cancel for smooth
        // pressures: the diagonal of a consistent mass is too small then
        const double lumped = inertia * mass.local_element(i / dim);
        scale[i] =
          1. / (lumped > 0. ? lumped : matrix->diagonal(i / dim, i % dim));
      }
    G->LeftScale(scale);
    Epetra_CrsMatrix CG(Copy, D->RowMap(), 0), S(Copy, D->RowMap(), 0);
    EpetraExt::MatrixMatrix::Multiply(*C, false, *G, false, CG);
    Epetra_CrsMatrix *sum = &S;
    EpetraExt::MatrixMatrix::Add(*D, false, 1., CG, false, -1., sum);
    S.FillComplete();
    if (closed != nullptr)
      for (int i = 0; i < S.NumMyRows(); ++i)
        diagonal_entry(S, i) *= 1. + closed_shift;
    return rows_of(S,
                   matrix->occupancy.nodes.partitioner()->local_range().first);
  }

  template <int dim>
  std::vector<double>
  SchurComplement<dim>::surface_term(const double inertia) const
  {
    BlockVector x(2), y(2);
    x.block(0).reinit(matrix->occupancy.nodes.vector_partitioner());
    x.block(1).reinit(matrix->occupancy.nodes.partitioner());
    x.collect_sizes();
    y.reinit(x);
    x.block(1) = 1.;
    matrix->gradient(x.block(0), x.block(1));
    x.block(1)               = 0.;
    const unsigned int n_own = matrix->occupancy.nodes.n_own();
    for (unsigned int node = 0; node < n_own; ++node)
      for (unsigned int i = 0; i < dim; ++i)
        x.block(0).local_element(node * dim + i) /= matrix->diagonal(node, i);
    matrix->vmult(y, x);
    std::vector<double> result(n_own);
    for (unsigned int node = 0; node < n_own; ++node)
      result[node] = inertia * std::max(0., -y.block(1).local_element(node));
    return result;
  }

  template <int dim>
  template <typename Function>
  void
  SchurComplement<dim>::for_each_scaled_entry(const unsigned int node,
                                              const unsigned int first,
                                              const double       scale,
                                              const double       surface,
                                              const Function    &f) const
  {
    const NodePattern<dim> &pattern  = matrix->sparsity();
    const unsigned int      diagonal = pattern.diagonal_of(node);
    f(pattern.column_of(diagonal),
      (scale * matrix->diagonal(node, dim) + surface) *
        (closed != nullptr ? 1. + closed_shift : 1.));
    if (matrix->is_empty(node))
      return;
    for (unsigned int k = first; k < pattern.row_begin(node + 1); ++k)
      if (const double value = matrix->value(k, dim, dim);
          value != 0. && k != diagonal)
        f(pattern.column_of(k), scale * value);
  }

  template <int dim>
  DistributedRows
  SchurComplement<dim>::scaled_rows(const double               scale,
                                    const std::vector<double> &surface) const
  {
    const NodePattern<dim> &pattern = matrix->sparsity();
    DistributedRows         result;
    result.first = matrix->occupancy.nodes.partitioner()->local_range().first;
    result.column.reserve(pattern.row_begin(surface.size()));
    result.value.reserve(pattern.row_begin(surface.size()));
    for (unsigned int node = 0; node < surface.size(); ++node)
      {
        const std::size_t before = result.column.size();
        for_each_scaled_entry(
          node,
          pattern.row_begin(node),
          scale,
          surface[node],
          [&](const unsigned int column, const double value) {
            result.column.push_back(pattern.global_column(column));
            result.value.push_back(value);
          });
        result.length.push_back(result.column.size() - before);
      }
    return result;
  }

  template <int dim>
  LowerTriangle
  SchurComplement<dim>::scaled_triangle(
    const double               scale,
    const std::vector<double> &surface) const
  {
    LowerTriangle result;
    for (unsigned int node = 0; node < surface.size(); ++node)
      {
        for_each_scaled_entry(node,
                              matrix->sparsity().diagonal_of(node) + 1,
                              scale,
                              surface[node],
                              [&](const unsigned int column,
                                  const double       value) {
                                result.row.push_back(column);
                                result.value.push_back(value);
                              });
        result.begin.push_back(result.row.size());
      }
    return result;
  }

  template <int dim>
  void
  SchurComplement<dim>::vmult(Vector &z, Vector &r) const
  {
    if (closed != nullptr)
      closed->remove_constants(r);
    if (hierarchy)
      hierarchy->vmult(z, r);
    else
      cholesky.solve(z.begin(), r.begin());
    z *= factor;
    for (unsigned int i = 0; i < viscous.size(); ++i)
      z.local_element(i) += viscous[i] * r.local_element(i);
    if (closed != nullptr)
      closed->remove_constants(z);
  }

  template class SchurComplement<2>;
  template class SchurComplement<3>;
} // namespace seiche
