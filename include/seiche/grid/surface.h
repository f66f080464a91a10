// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_surface_h
#define seiche_grid_surface_h

#include <seiche/grid/cut_cell.h>
#include <seiche/space/occupancy.h>

#include <vector>

namespace seiche
{
  /**
   * @brief The free surface: where a multilinear level set vanishes that
   * follows from the nodal fill of the points (doc/theory.md (5.0b) to (5.0e)).
   *
   * The level set is a distance in cells, negative inside the fluid. The inside
   * has the nodal fill of the points, up to what a few corrections leave;
   * points that it does not represent (drops, thin sheets) are loose.
   */
  template <int dim>
  class Surface
  {
  public:
    using Vector = typename Occupancy<dim>::Vector;
    using Rule   = std::array<dealii::Point<dim>, CutCell<dim>::n_vertices>;

    /// @p occupancy must outlive the object.
    explicit Surface(const Occupancy<dim> &occupancy);

    /// Follow the nodal fill (sum N_I V0 over the node's volume; own and ghost
    /// nodes). Collective.
    void
    update(const Vector &nodal_fill);

    /// Share of a cell that is inside [0,1]; own and ghost cells.
    double
    inside_share(const unsigned int cell) const
    {
      return shares[cell];
    }

    /// Quadrature points in the unit cell of the inside of an own cell that is
    /// cut, of equal weight inside_share()/2^dim.
    const Rule &
    rule(const unsigned int cell) const
    {
      return rules[rule_of_cell[cell]];
    }

    /// Share of a point at @p unit in an own cell that the inside does not
    /// represent [0,1]; positive where the cell has no inside.
    double
    loose_share(const unsigned int cell, const dealii::Point<dim> &unit) const;

    /// Nodal fill of the inside; own and ghost nodes.
    const Vector &
    nodal_fill() const
    {
      return inside_fill;
    }

    /// The level set [cells]; own and ghost nodes.
    const Vector &
    level_set() const
    {
      return level;
    }

    /// The level set at the vertices of an own active cell [cells].
    VertexValues<dim>
    level_in(const unsigned int cell) const;

  private:
    /// Shares and rules from the level set. Collective.
    void
    cut_cells();

    /// Nodal fill of the inside. Collective.
    void
    integrate();

    /// Move the level set at the nodes of cut cells by what the fill of its
    /// inside lacks. Collective.
    void
    correct(const Vector &nodal_fill);

    const Occupancy<dim>     &occupancy;
    Vector                    level, inside_fill, represented;
    std::vector<double>       shares;
    std::vector<unsigned int> rule_of_cell;
    std::vector<Rule>         rules;
  };
} // namespace seiche

#endif
