// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_compatibility_h
#define seiche_utilities_compatibility_h

/**
 * @file
 * The one place for differences between deal.II 9.4.1 and 9.6.
 */

#include <deal.II/base/config.h>

#include <deal.II/base/index_set.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

namespace seiche
{
  namespace compatibility
  {
    /// Key in doc/references.bib of the paper on this version of deal.II.
#if DEAL_II_VERSION_GTE(9, 6, 0)
    inline constexpr const char *dealii_paper = "dealii2024";
#else
    inline constexpr const char *dealii_paper = "dealii2022";
#endif

    /// Degrees of freedom on own and ghost cells of this rank. Local.
    template <int dim>
    dealii::IndexSet
    locally_relevant_dofs(const dealii::DoFHandler<dim> &dof_handler)
    {
#if DEAL_II_VERSION_GTE(9, 5, 0)
      return dealii::DoFTools::extract_locally_relevant_dofs(dof_handler);
#else
      dealii::IndexSet result;
      dealii::DoFTools::extract_locally_relevant_dofs(dof_handler, result);
      return result;
#endif
    }
  } // namespace compatibility
} // namespace seiche

#endif
