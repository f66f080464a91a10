// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/direct_solver.h>
#include <seiche/algebra/epetra_copy.h>
#include <seiche/algebra/sparse_factors.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  bool
  solve_directly(const BlockMatrix<dim>                       &matrix,
                 const ClosedChambers<dim>                    *closed,
                 typename BlockMatrix<dim>::BlockVector       &solution,
                 const typename BlockMatrix<dim>::BlockVector &right_hand_side)
  {
    const unsigned int n_fields = matrix.n_fields();
    const FieldRange   all      = {0, n_fields};
    const auto         system   = epetra_copy(matrix, all, all);
    const Epetra_Map  &map      = system->RowMap();
    if (closed != nullptr)
      for (const types::global_dof_index node : closed->first_nodes())
        if (const int gid = static_cast<int>(node * n_fields + dim);
            map.MyGID(gid))
          {
            // any positive number: the pinned value is then zero
            double &entry = diagonal_entry(*system, map.LID(gid));
            entry         = entry != 0. ? 2. * entry : 1.;
          }

    // entry i of a block: which row of the system
    const auto row = [&](const unsigned int block, const unsigned int i) {
      return block == 0 ? i / dim * n_fields + i % dim : i * n_fields + dim;
    };
    SparseFactors factors;
    if (!factors.initialize(*system))
      return false;
    Epetra_Vector &b = factors.right_hand_side();
    for (unsigned int block = 0; block < right_hand_side.n_blocks(); ++block)
      for (unsigned int i = 0;
           i < right_hand_side.block(block).locally_owned_size();
           ++i)
        b[row(block, i)] = right_hand_side.block(block).local_element(i);

    if (!factors.solve())
      return false;
    const Epetra_Vector &x = factors.solution();
    for (unsigned int block = 0; block < solution.n_blocks(); ++block)
      for (unsigned int i = 0; i < solution.block(block).locally_owned_size();
           ++i)
        solution.block(block).local_element(i) = x[row(block, i)];
    return true;
  }

#define INSTANTIATE(dim)                      \
  template bool solve_directly<dim>(          \
    const BlockMatrix<dim> &,                 \
    const ClosedChambers<dim> *,              \
    typename BlockMatrix<dim>::BlockVector &, \
    const typename BlockMatrix<dim>::BlockVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
