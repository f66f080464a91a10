// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_node_masters_h
#define seiche_space_node_masters_h

#include <seiche/mesh/cell_locator.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace seiche
{
  /**
   * @brief Which nodes of the full numbering are no unknowns, and what stands
   * for them.
   *
   * A hanging node is a sum over masters, nodes of the coarser neighbour: rows
   * of C in doc/theory.md (9.1).
   * Nodes that coincide across a seam (periodic sides) are one: the lowest
   * number among them stands for all, and if one of them hangs, all hang. The
   * mesh is balanced also across seams and corners, so that masters never hang.
   *
   * Only this class knows that nodes coincide.
   */
  template <int dim>
  class NodeMasters
  {
  public:
    using Node    = dealii::types::global_dof_index;
    using Weights = std::vector<std::pair<Node, double>>;

    /// Of the nodes of own and ghost cells; complete for those of own cells.
    /// Collective.
    NodeMasters(const dealii::DoFHandler<dim> &dof_handler,
                const CellLocator<dim>        &locator);

    /// True if some node hangs that this rank knows.
    bool
    any_hanging() const
    {
      return hanging.n_constraints() > 0;
    }

    bool
    hangs(const Node node) const
    {
      return hanging.is_constrained(hanging_twin(node));
    }

    /// The unknown that stands for a node that does not hang.
    Node
    unknown(const Node node) const
    {
      const auto found = seam.find(node);
      return found == seam.end() ? node : found->second.unknown;
    }

    /// Unknowns and weights of a node that hangs.
    Weights
    masters(const Node node) const;

  private:
    /// Of a node that coincides with others.
    struct Twins
    {
      Node unknown; ///< the lowest number
      Node hanging; ///< one of them that hangs, or itself
    };

    Node
    hanging_twin(const Node node) const
    {
      const auto found = seam.find(node);
      return found == seam.end() ? node : found->second.hanging;
    }

    /// Of nodes on a face at a seam whose cell across is coarser.
    void
    add_hanging_at_seam(const dealii::DoFHandler<dim> &dof_handler,
                        const CellLocator<dim>        &locator);
    void
    find_twins(const dealii::DoFHandler<dim> &dof_handler,
               const CellLocator<dim>        &locator);
    /// The lowest numbers, from the owners, who see all cells at their nodes.
    void
    share_unknowns(const dealii::DoFHandler<dim> &dof_handler,
                   const CellLocator<dim>        &locator);

    dealii::AffineConstraints<double> hanging;
    std::map<Node, Twins>             seam;
  };

  /// Nodes of a cell in the full numbering, lexicographic.
  template <int dim>
  void
  get_nodes(const dealii::DoFHandler<dim>                &dof_handler,
            const CellLocator<dim>                       &locator,
            const unsigned int                            cell,
            std::vector<dealii::types::global_dof_index> &nodes);
} // namespace seiche

#endif
