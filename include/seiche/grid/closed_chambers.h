// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_closed_chambers_h
#define seiche_grid_closed_chambers_h

#include <seiche/scene/chambers.h>
#include <seiche/space/occupancy.h>

#include <functional>
#include <vector>

namespace seiche
{
  /**
   * @brief Chambers that fluid fills: no free surface, no open side.
   *
   * There the pressure of an incompressible fluid is known up to a constant,
   * one for each, and the rows of its volume add up to zero (doc/theory.md
   * (10.7)).
   */
  template <int dim>
  class ClosedChambers
  {
  public:
    using Vector = typename Occupancy<dim>::Vector;

    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    /// @p occupancy must outlive the object.
    explicit ClosedChambers(const Occupancy<dim> &occupancy);

    /// Find them, and their nodes. @p fluid_fills: is an own cell full?
    /// Collective.
    void
    update(const std::function<bool(const unsigned int)> &fluid_fills);

    bool
    any() const
    {
      return n_closed > 0;
    }

    bool
    is_closed(const unsigned int chamber) const
    {
      return closed[chamber];
    }

    /// True if an own cell lies in one of them.
    bool
    holds_cell(const unsigned int cell) const
    {
      return any() &&
             closed[chambers.index(occupancy.locator.cells.iterator(cell))];
    }

    /// True if an own node lies in one of them.
    bool
    holds_node(const unsigned int node) const
    {
      return any() && of_node[node] != none;
    }

    /// In each, take a multiple of the nodal mass from the rows of the volume,
    /// so that these add up to zero. Own nodes, as below. Collective.
    void
    balance_rows(Vector &rows, const Vector &mass) const;

    /// Give pressures a mean of zero over the volume of each. Collective.
    void
    level_pressure(Vector &pressure) const;

    /// Leave out what is constant in each: the mean of the nodal values.
    /// Collective.
    void
    remove_constants(Vector &values) const;

    /// A vertex of each: its node, global numbers. Collective.
    std::vector<dealii::types::global_dof_index>
    first_nodes() const;

    const Chambers<dim> chambers;

  private:
    /// values -= shape sum(weight values)/sum(weight shape), in each.
    template <typename Weight, typename Shape>
    void
    subtract(Vector &values, const Weight &weight, const Shape &shape) const;

    const Occupancy<dim>     &occupancy;
    std::vector<char>         closed; ///< by chamber
    unsigned int              n_closed = 0;
    std::vector<unsigned int> of_node; ///< own nodes: the chamber, or none
  };
} // namespace seiche

#endif
