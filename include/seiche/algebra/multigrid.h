// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_multigrid_h
#define seiche_algebra_multigrid_h

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <string>
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
   * @brief Algebraic multigrid for a Laplacian-like scalar matrix: a hierarchy,
   * which the constructor builds, and its V-cycle.
   */
  class Multigrid
  {
  public:
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    Multigrid()                  = default;
    virtual ~Multigrid()         = default;
    Multigrid(const Multigrid &) = delete;
    Multigrid &
    operator=(const Multigrid &) = delete;

    /// dst = cycle(src), symmetric and positive; as many own entries as rows.
    /// Collective.
    virtual void
    vmult(Vector &dst, const Vector &src) const = 0;
  };

  /// One row of the table of multigrids.
  struct MultigridMethod
  {
    const char *name;

    /// Small symmetric matrices on one rank are factorised instead.
    bool factorises_small;

    /// The hierarchy of a matrix; a rank may have no rows. Collective.
    std::unique_ptr<Multigrid> (*make)(const DistributedRows &, const MPI_Comm);
    const char *papers; ///< keys of doc/references.bib
    const char *description;
  };

  /// The row of the table with this name.
  const MultigridMethod &
  multigrid_method(const std::string &name);

  const std::vector<MultigridMethod> &
  multigrid_methods();
} // namespace seiche

#endif
