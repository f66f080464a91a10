// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/boomer_amg.h>
#include <seiche/algebra/ml_multigrid.h>

#include <deal.II/base/exceptions.h>

namespace seiche
{
  namespace
  {
    template <typename Type>
    std::unique_ptr<Multigrid>
    make(const DistributedRows &rows, const MPI_Comm communicator)
    {
      return std::make_unique<Type>(rows, communicator);
    }
  } // namespace

  const std::vector<MultigridMethod> &
  multigrid_methods()
  {
    static const std::vector<MultigridMethod> table = {
      {"automatic",
       true,
       make<BoomerAMG>,
       "henson2002 chen2008",
       "factors of a small symmetric one on one rank, else BoomerAMG"},
      {"BoomerAMG",
       false,
       make<BoomerAMG>,
       "henson2002",
       "HYPRE's, classical coarsening"},
      {"ML",
       false,
       make<MLMultigrid>,
       "vanek1996",
       "Trilinos', smoothed aggregation"}};
    return table;
  }

  const MultigridMethod &
  multigrid_method(const std::string &name)
  {
    for (const MultigridMethod &method : multigrid_methods())
      if (name == method.name)
        return method;
    // the pattern refuses other names
    AssertThrow(false, dealii::ExcInternalError());
    return multigrid_methods().front();
  }
} // namespace seiche
