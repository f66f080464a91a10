// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_muelu_multigrid_h
#define seiche_solve_muelu_multigrid_h

#include <seiche/solve/multigrid.h>

namespace seiche
{
  /// Smoothed aggregation of Trilinos' MueLu (Berger-Vergiat et al. 2019).
  class MueLuMultigrid : public Multigrid
  {
  public:
    MueLuMultigrid(const DistributedRows &rows, const MPI_Comm communicator);
    ~MueLuMultigrid() override;

    void
    vmult(Vector &dst, const Vector &src) const override;

  private:
    struct Objects; ///< of Trilinos, whose headers only muelu_multigrid.cc
                    ///< needs
    const std::unique_ptr<Objects> objects;
  };
} // namespace seiche

#endif
