// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_linear_cells_h
#define seiche_space_linear_cells_h

#include <seiche/space/hanging_nodes.h>

#include <array>
#include <cstdint>
#include <map>

namespace seiche
{
  /**
   * @brief Cells of FE_Q(2) on which fields are multilinear, and what follows
   * for their neighbours.
   *
   * A node that is no vertex is no unknown if a multilinear cell has it: its
   * value is the mean over the vertices of the edge, face or cell in whose
   * middle it lies. This holds for all cells at the node, so that fields stay
   * continuous. The matrix of a cell (NodeMatrix) then is that of its hanging
   * nodes times that of these means (doc/theory.md (4.8)).
   */
  template <int dim>
  class LinearCells
  {
  public:
    /// After each change of the mesh; FE_Q(2) only. @p hanging must outlive
    /// this. Collective.
    void
    reinit(const dealii::DoFHandler<dim> &dof_handler,
           const CellLocator<dim>        &locator,
           const NodeMasters<dim>        &masters,
           const HangingNodes<dim>       &hanging);

    /// True if the unknown at this place of a cell's list lies in the middle
    /// of an edge, a face or a cell.
    bool
    is_middle(const unsigned int cell, const unsigned int a) const
    {
      return !rule(cell).is_free(a);
    }

    /// The unknowns of a cell on which fields are multilinear.
    struct Vertices
    {
      static constexpr unsigned int n = 1u << dim;
      std::array<std::uint8_t, n>   places; ///< in the cell's list
      const NodeMatrix *matrix; ///< values at vertices from those, or null
    };

    const Vertices &
    vertices(const unsigned int cell) const
    {
      return vertices_of_cell[cell] < 0 ?
               plain_vertices :
               other_vertices[vertices_of_cell[cell]];
    }

    /// C of a cell in whose list the unknowns marked by @p means (bit a) are
    /// such means; null if it is the identity.
    const NodeMatrix *
    matrix(const unsigned int cell, const unsigned int means);

  private:
    using Parents =
      std::vector<std::pair<dealii::types::global_dof_index, double>>;

    const NodeMatrix &
    rule(const unsigned int cell) const
    {
      return rule_of_cell[cell] != nullptr ? *rule_of_cell[cell] : *plain_rule;
    }

    /// Means of an own cell with hanging nodes.
    void
    resolve(const unsigned int                                        cell,
            const std::map<dealii::types::global_dof_index, Parents> &parents);
    /// Of ghost cells with hanging nodes, from their owners. Collective.
    void
    exchange(const CellLocator<dim> &locator);

    const HangingNodes<dim> *hanging = nullptr;
    /// Each unknown of the list as a mean of others in it; null: no node of
    /// the cell hangs.
    std::vector<const NodeMatrix *> rule_of_cell;
    const NodeMatrix               *plain_rule = nullptr;
    NodeMatrices                    rules, matrices;
    /// Places of the vertices' unknowns in a cell with hanging nodes.
    void
    find_vertices(const unsigned int cell);

    Vertices              plain_vertices;
    std::vector<Vertices> other_vertices;
    std::vector<int>      vertices_of_cell; // or -1
    /// By hanging nodes, means and marks.
    std::map<std::tuple<const NodeMatrix *, const NodeMatrix *, unsigned int>,
             const NodeMatrix *>
      known;
  };
} // namespace seiche

#endif
