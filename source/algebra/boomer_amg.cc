// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/boomer_amg.h>

#include <deal.II/base/exceptions.h>

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>

#include <numeric>

namespace seiche
{
  namespace
  {
    // HYPRE's numbers (HYPRE_BoomerAMGSetCoarsenType and so on)
    constexpr int hmis = 10, extended_i = 6, l1_symmetric_gauss_seidel = 8;

    template <typename Object>
    Object
    object_of(HYPRE_IJMatrix matrix)
    {
      void *object;
      HYPRE_IJMatrixGetObject(matrix, &object);
      return static_cast<Object>(object);
    }

    HYPRE_ParVector
    object_of(HYPRE_IJVector vector)
    {
      void *object;
      HYPRE_IJVectorGetObject(vector, &object);
      return static_cast<HYPRE_ParVector>(object);
    }

    HYPRE_IJVector
    make_vector(const MPI_Comm communicator, const int first, const int last)
    {
      HYPRE_IJVector result;
      HYPRE_IJVectorCreate(communicator, first, last, &result);
      HYPRE_IJVectorSetObjectType(result, HYPRE_PARCSR);
      HYPRE_IJVectorInitialize(result);
      HYPRE_IJVectorAssemble(result);
      return result;
    }
  } // namespace

  BoomerAMG::BoomerAMG(const DistributedRows &rows, const MPI_Comm communicator)
    : n_rows(rows.length.size())
  {
    static const int initialized = HYPRE_Init();
    (void)initialized;
    HYPRE_ClearAllErrors();
    const int last = rows.first + n_rows - 1;
    HYPRE_IJMatrixCreate(
      communicator, rows.first, last, rows.first, last, &matrix);
    HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
    HYPRE_IJMatrixSetRowSizes(matrix, rows.length.data());
    HYPRE_IJMatrixSetMaxOffProcElmts(matrix, 0);
    HYPRE_IJMatrixInitialize(matrix);
    std::vector<int> numbers(n_rows), lengths(rows.length);
    std::iota(numbers.begin(), numbers.end(), rows.first);
    HYPRE_IJMatrixSetValues(matrix,
                            n_rows,
                            lengths.data(),
                            numbers.data(),
                            rows.column.data(),
                            rows.value.data());
    HYPRE_IJMatrixAssemble(matrix);
    right_hand_side = make_vector(communicator, rows.first, last);
    solution        = make_vector(communicator, rows.first, last);

    // measured: doc/performance.md, linear systems
    HYPRE_BoomerAMGCreate(&solver);
    HYPRE_BoomerAMGSetMaxIter(solver, 1);
    HYPRE_BoomerAMGSetTol(solver, 0.);
    HYPRE_BoomerAMGSetPrintLevel(solver, 0);
    HYPRE_BoomerAMGSetCoarsenType(solver, hmis);
    HYPRE_BoomerAMGSetInterpType(solver, extended_i);
    HYPRE_BoomerAMGSetPMaxElmts(solver, 4);
    HYPRE_BoomerAMGSetAggNumLevels(solver, 1);
    HYPRE_BoomerAMGSetStrongThreshold(solver, 0.5);
    HYPRE_BoomerAMGSetRelaxType(solver, l1_symmetric_gauss_seidel);
    HYPRE_BoomerAMGSetMaxCoarseSize(solver, 100);
    HYPRE_BoomerAMGSetup(solver,
                         object_of<HYPRE_ParCSRMatrix>(matrix),
                         object_of(right_hand_side),
                         object_of(solution));
    AssertThrow(HYPRE_GetError() == 0,
                dealii::ExcMessage("HYPRE could not build a hierarchy"));
  }

  BoomerAMG::~BoomerAMG()
  {
    HYPRE_BoomerAMGDestroy(solver);
    HYPRE_IJMatrixDestroy(matrix);
    HYPRE_IJVectorDestroy(right_hand_side);
    HYPRE_IJVectorDestroy(solution);
  }

  void
  BoomerAMG::vmult(Vector &dst, const Vector &src) const
  {
    AssertDimension(src.locally_owned_size(), n_rows);
    AssertDimension(dst.locally_owned_size(), n_rows);
    HYPRE_IJVectorSetValues(right_hand_side, n_rows, nullptr, src.begin());
    HYPRE_ParVectorSetConstantValues(object_of(solution), 0.);
    HYPRE_BoomerAMGSolve(solver,
                         object_of<HYPRE_ParCSRMatrix>(matrix),
                         object_of(right_hand_side),
                         object_of(solution));
    HYPRE_IJVectorGetValues(solution, n_rows, nullptr, dst.begin());
  }
} // namespace seiche
