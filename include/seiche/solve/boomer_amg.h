// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_boomer_amg_h
#define seiche_solve_boomer_amg_h

#include <deal.II/lac/la_parallel_vector.h>

#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>

#include <vector>

namespace seiche
{
  /// Own rows of a distributed sparse matrix: the ranks own runs of rows, one
  /// after the other.
  struct DistributedRows
  {
    int                 first = 0; ///< number of the first row
    std::vector<int>    length;    ///< [row] number of entries
    std::vector<int>    column;    ///< of each entry, global
    std::vector<double> value;
  };

  /**
   * @brief One V-cycle of HYPRE's algebraic multigrid (BoomerAMG: Henson and
   * Yang 2002) for Laplacian-like scalar matrices.
   */
  class BoomerAMG
  {
  public:
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    BoomerAMG();
    ~BoomerAMG();
    BoomerAMG(const BoomerAMG &) = delete;
    BoomerAMG &
    operator=(const BoomerAMG &) = delete;

    /// Build the hierarchy. Collective.
    void
    initialize(const DistributedRows &rows, const MPI_Comm communicator);

    bool
    is_empty() const
    {
      return solver == nullptr;
    }
    void
    clear();

    /// dst = cycle(src), as many own entries as rows. Collective.
    void
    vmult(Vector &dst, const Vector &src) const;

  private:
    HYPRE_Solver   solver          = nullptr;
    HYPRE_IJMatrix matrix          = nullptr;
    HYPRE_IJVector right_hand_side = nullptr, solution = nullptr;
    int            n_rows = 0;
  };
} // namespace seiche

#endif
