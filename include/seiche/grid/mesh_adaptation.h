// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_mesh_adaptation_h
#define seiche_grid_mesh_adaptation_h

#include <seiche/mesh/cell_locator.h>
#include <seiche/points/point_cloud.h>
#include <seiche/scene/background_grid.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Lets the mesh follow the fluid, and shares it out among the ranks.
   *
   * The grid carries nothing from step to step, so there is no field to
   * transfer: only the points find their new cells. Cells are refined where a
   * criterion (RefinementCriterion) asks for it and coarsened where none does;
   * p4est keeps neighbours, also across vertices, within one level. Distances
   * count in cells of the wanted level, so that refining and coarsening agree
   * and a mesh that fits does not change.
   */
  template <int dim>
  class MeshAdaptation
  {
  public:
    /// Adapts the mesh to the points as they are and shares it out. References
    /// must outlive the object. @p gauss_in_full_cells: cut cells. Collective.
    MeshAdaptation(BackgroundGrid<dim> &grid,
                   CellLocator<dim>    &locator,
                   PointCloud<dim>     &points,
                   const bool           gauss_in_full_cells);

    /// Adapt in one pass and share out if step number @p step asks for it, or
    /// at once if the free surface has come to fluid coarser than its level.
    /// (What one pass leaves to do, the next step's does: a pass costs as much
    /// as a Newton iteration.) True if the mesh or the owners have changed.
    /// Collective.
    bool
    update(const unsigned int step);

    /// Cells per rank by weight, as the points are now: largest share over the
    /// mean. Collective.
    double
    imbalance();

  private:
    /// One pass of refinement and coarsening; false if nothing changed, not
    /// even owners.
    bool
    adapt();
    /// Until nothing changes, sharing out.
    void
    adapt_fully();
    bool
    surface_left_its_level() const;
    /// If the shares differ by more than a tenth, or @p at_once. Families of
    /// cells are then whole again. True if cells have moved.
    bool
    share_out(const bool at_once = false);

    void
    find_fluid();
    /// Raise wanted_level of the cells that a criterion claims.
    void
    claim(const RefinementCriterion<dim> &criterion);
    /// ... that lie less than @p layers cells of the level from a seed.
    void
    claim_around(const std::vector<char> &seeds,
                 const double             level,
                 const unsigned int       layers);
    /// Raise wanted_level so that neighbours differ by one at most: then the
    /// forest does as it is told.
    void
    grade();
    /// The levels that a pass is to lead to.
    void
    choose_levels();
    /// True if cells to coarsen have siblings that another rank owns.
    bool
    a_family_is_shared() const;
    /// What a pass makes of wanted_level: one level up or down. A family
    /// coarsens as a whole, and not beside a cell that stays too fine for it;
    /// flags that the forest refuses would cost as much as those it obeys.
    void
    choose_next_levels();
    bool
    may_coarsen(const unsigned int cell) const;
    bool
    siblings_are_own(const unsigned int cell) const;

    /// imbalance() with the fluid as find_fluid() saw it last. Collective.
    double
    imbalance_of_weights() const;

    /// Work in a cell, for the forest to share out.
    unsigned int
    weight(const unsigned int cell) const;

    /// Nodes of an own cell with fluid, each shared with the cells around it
    /// that have fluid too; an estimate from their number.
    double
    nodes(const unsigned int cell) const;

    BackgroundGrid<dim>             &grid;
    CellLocator<dim>                &locator;
    PointCloud<dim>                 &points;
    const RefinementParameters<dim> &parameters;
    const bool                       gauss_in_full_cells;
    const MPI_Comm                   communicator;

    // own cells and ghosts (at_surface: own cells)
    std::vector<char>   holds_fluid, at_surface;
    std::vector<double> wanted_level; // forest level; for the exchange double
    std::vector<double> next_level;   // after the pass
  };
} // namespace seiche

#endif
