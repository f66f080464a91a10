// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_cell_locator_h
#define seiche_mesh_cell_locator_h

#include <seiche/mesh/cells.h>

namespace seiche
{
  /**
   * @brief Finds the cell, own or ghost, that holds a position.
   *
   * All cells are axis-parallel boxes, so a position is located in closed form:
   * segment and index on the finest lattice per direction, then the cell whose
   * lattice box holds the index. Cells are half-open, [lower, upper); only the
   * upper sides of the domain belong to their cell. The result depends on the
   * position alone, never on the rank count. A position on a wall up to
   * wall_tolerance cells belongs to the cell inside, one beyond a periodic side
   * to where Periods::wrapped() takes it.
   */
  template <int dim>
  class CellLocator
  {
  public:
    static constexpr unsigned int invalid = Cells<dim>::invalid;

    /// @p background_grid must outlive the locator.
    explicit CellLocator(const BackgroundGrid<dim> &background_grid);

    /// Rebuild the tables after a change of the mesh. Local.
    void
    reinit();

    /// Move the grid lines, now and for meshes to come (GridLines::move()); the
    /// triangulation stays as it is. Points have to be located anew. Local.
    void
    move(const GridMotion<dim> &motion, const double time);

    /// Move the solids to where they are at a time [s]. Local.
    void
    move_solids(const double time);

    /// Cell that holds @p x (wrapped) among own and ghost cells, or invalid. @p
    /// hint is tried first, then its neighbours. Local.
    unsigned int
    find(const dealii::Point<dim> &x, const unsigned int hint = invalid) const;

    /// @p x moved by periods so that it is nearest to the cell.
    dealii::Point<dim>
    image(const dealii::Point<dim> &x, const unsigned int cell) const
    {
      return periods.image(x, cells.geometry(cell));
    }

    /// The wall through which a position outside left: the one that it is
    /// farthest behind; null for a position in the fluid domain.
    const Wall<dim> *
    wall_beyond(const dealii::Point<dim> &x) const;

    const BackgroundGrid<dim> &grid;
    std::vector<Solid<dim>>    solids; ///< as they lie now

    GridLines<dim>   lines;
    Periods<dim>     periods;
    CellLattice<dim> lattice;
    Cells<dim>       cells;

  private:
    using Index = typename GridLines<dim>::Index;

    /// Index on the finest lattice; false if outside the box.
    bool
    lattice_position(const dealii::Point<dim> &x, Index &index) const;
    /// A position that is in no lattice cell but perhaps on a wall.
    unsigned int
    find_at_wall(const dealii::Point<dim> &x) const;
  };
} // namespace seiche

#endif
