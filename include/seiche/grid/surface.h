// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_surface_h
#define seiche_grid_surface_h

#include <seiche/grid/level_at_walls.h>
#include <seiche/space/cut_cell.h>

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

    /// action(point in the unit cell, share of the cell) on the quadrature
    /// points of the inside of an own cell that it does not fill: of equal
    /// weight where there is no wall.
    template <typename Action>
    void
    for_each_point(const unsigned int cell, const Action &action) const
    {
      if (walls().cuts(cell))
        for (const WeightedPoint<dim> &point : wet_part(cell).points)
          action(point.unit, point.weight);
      else
        for (const dealii::Point<dim> &x : rules[rule_of_cell[cell]])
          action(x, shares[cell] / CutCell<dim>::n_vertices);
    }

    /// The wall of solids at the inside of an own cell, or null.
    const std::vector<WallPoint<dim>> *
    wall(const unsigned int cell) const
    {
      return walls().cuts(cell) && shares[cell] > 0. ? &wet_part(cell).wall :
                                                       nullptr;
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
    /// Correct the level set until the wet part of the inside has this fill.
    /// Collective.
    void
    follow(const Vector &fill);

    /// Shares and rules from the level set; @p at_walls: of what solids leave
    /// of cells, not of whole ones. Collective.
    void
    cut_cells(const bool at_walls);

    /// Nodal fill of the inside, of its wet part; @p at_walls: by the rules of
    /// what solids leave of cells. Collective.
    void
    integrate(const bool at_walls);

    /// Of an own active cell.
    void
    cut_cell(const unsigned int cell);
    void
    cut_at_wall(const unsigned int cell);

    /// Move the level set at the nodes of cut cells by what the fill of its
    /// inside lacks. Collective.
    void
    correct(const Vector &nodal_fill);

    /// Nodal fill of whole hats from that of their wet part: the level set
    /// continues the fluid into solids (surface_at_walls.cc). Collective.
    Vector
    continued_fill(const Vector &wet_fill);

    /// The level set from the fill of whole hats. Collective.
    void
    set_level(const Vector &fill);

    /// Integral of a node's hat, solids included [m^dim].
    double
    whole_volume(const unsigned int node) const
    {
      return walls().exist() ? occupancy.mesh_nodes.full_volume(
                                 occupancy.nodes.in_mesh()[node]) :
                               occupancy.nodes.volume(node);
    }

    /// Share of a node's hat that is wet; 1 where no vertex lies.
    double
    wet_share(const unsigned int node) const
    {
      const double whole = whole_volume(node);
      return whole > 0. ? occupancy.nodes.volume(node) / whole : 1.;
    }

    const CutWalls<dim> &
    walls() const
    {
      return occupancy.mesh_nodes.cut_walls;
    }

    /// Of an own cell that the wall of a solid cuts.
    const WetPart<dim> &
    wet_part(const unsigned int cell) const
    {
      const unsigned int part = rule_of_cell[cell];
      return part == whole ? walls().whole(cell) : wet_parts[part];
    }

    /// In rule_of_cell: the fluid fills what the wall leaves of the cell.
    static constexpr unsigned int whole =
      dealii::numbers::invalid_unsigned_int - 1;

    const Occupancy<dim>     &occupancy;
    Vector                    level, inside_fill, represented;
    std::vector<double>       shares;
    std::vector<unsigned int> rule_of_cell; // of rules, or of wet_parts
    std::vector<Rule>         rules;
    std::vector<WetPart<dim>> wet_parts;
    LevelAtWalls<dim>         level_at_walls;
  };
} // namespace seiche

#endif
