// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_boomer_amg_h
#define seiche_algebra_boomer_amg_h

#include <seiche/algebra/multigrid.h>

// of HYPRE, whose headers only boomer_amg.cc needs
struct hypre_Solver_struct;
struct hypre_IJMatrix_struct;
struct hypre_IJVector_struct;

namespace seiche
{
  /// HYPRE's algebraic multigrid (BoomerAMG: Henson and Yang 2002).
  class BoomerAMG : public Multigrid
  {
  public:
    BoomerAMG(const DistributedRows &rows, const MPI_Comm communicator);
    ~BoomerAMG() override;

    void
    vmult(Vector &dst, const Vector &src) const override;

  private:
    const unsigned int     n_rows;
    hypre_Solver_struct   *solver          = nullptr;
    hypre_IJMatrix_struct *matrix          = nullptr;
    hypre_IJVector_struct *right_hand_side = nullptr;
    hypre_IJVector_struct *solution        = nullptr;
  };
} // namespace seiche

#endif
