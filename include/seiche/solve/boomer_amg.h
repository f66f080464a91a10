// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_boomer_amg_h
#define seiche_solve_boomer_amg_h

#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

// of HYPRE, whose headers only boomer_amg.cc needs
struct hypre_Solver_struct;
struct hypre_IJMatrix_struct;
struct hypre_IJVector_struct;

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

    /// Build the hierarchy; a rank may have no rows. Collective.
    void
    initialize(const DistributedRows &rows, const MPI_Comm communicator);

    void
    clear();

    /// dst = cycle(src), as many own entries as rows. Collective.
    void
    vmult(Vector &dst, const Vector &src) const;

  private:
    hypre_Solver_struct   *solver          = nullptr;
    hypre_IJMatrix_struct *matrix          = nullptr;
    hypre_IJVector_struct *right_hand_side = nullptr;
    hypre_IJVector_struct *solution        = nullptr;
    unsigned int           n_rows          = 0;
  };
} // namespace seiche

#endif
