// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_cells_h
#define seiche_mesh_cells_h

#include <seiche/mesh/cell_lattice.h>
#include <seiche/mesh/solid_distances.h>

#include <deal.II/base/array_view.h>

#include <array>
#include <vector>

namespace seiche
{
  /**
   * @brief Own and ghost cells of this rank: geometry, neighbours, walls.
   *
   * Local numbers: 0 ... n_owned()-1 are the rank's own cells in the order of
   * the triangulation, then the ghost cells. Periodic sides are no boundary:
   * cells across the seam are neighbours, whose coordinates differ by a period
   * (Periods::image()).
   */
  template <int dim>
  class Cells
  {
  public:
    using Iterator = typename CellLattice<dim>::CellIterator;

    static constexpr unsigned int invalid =
      dealii::numbers::invalid_unsigned_int;

    /// @p grid must outlive the object.
    explicit Cells(const BackgroundGrid<dim> &grid);

    /// After a change of the mesh; @p lattice gets the new cells. Local.
    void
    reinit(CellLattice<dim> &lattice);

    /// After the grid lines have moved. Local.
    void
    move(const CellLattice<dim> &lattice);

    /// After a change of the cells or of the solids. Local.
    void
    find_solids(const std::vector<Solid<dim>> &solids);

    unsigned int
    n_owned() const
    {
      return n_owned_cells;
    }

    /// Own and ghost cells.
    unsigned int
    size() const
    {
      return iterators.size();
    }

    const CellGeometry<dim> &
    geometry(const unsigned int cell) const
    {
      return geometries[cell];
    }

    const Iterator &
    iterator(const unsigned int cell) const
    {
      return iterators[cell];
    }

    /// Local number of an own or ghost cell.
    unsigned int
    index(const Iterator &cell) const
    {
      return by_active_index[cell->active_cell_index()];
    }

    /// Rank that owns the cell.
    unsigned int
    owner(const unsigned int cell) const
    {
      return iterators[cell]->subdomain_id();
    }

    /// Refinement level above the coarse cells of the forest.
    unsigned int
    level(const unsigned int cell) const
    {
      return iterators[cell]->level();
    }

    /// Cell across a face (deal.II's face number), of the same or a coarser
    /// level; invalid at a wall and where the neighbour is not known to this
    /// rank or is refined.
    unsigned int
    neighbor(const unsigned int cell, const unsigned int face) const
    {
      return face_neighbors[cell][face];
    }

    /// Own and ghost cells that share a vertex with an own cell (without it),
    /// ascending. Across a level jump, cells that touch share a vertex too.
    dealii::ArrayView<const unsigned int>
    vertex_neighbors(const unsigned int cell) const
    {
      return {vertex_neighbor_list.data() + vertex_neighbor_begin[cell],
              vertex_neighbor_begin[cell + 1] - vertex_neighbor_begin[cell]};
    }

    /// Smallest edges among an own cell and its vertex neighbours [m]: what
    /// moves no farther stays among these.
    const dealii::Tensor<1, dim> &
    reach(const unsigned int cell) const
    {
      return reaches[cell];
    }

    /// The wall, or open side, that a face is part of; null elsewhere.
    const Wall<dim> *
    wall_at(const unsigned int cell, const unsigned int face) const
    {
      return walls[cell][face];
    }

    /// The same, null at open sides.
    const Wall<dim> *
    closed_wall_at(const unsigned int cell, const unsigned int face) const
    {
      const Wall<dim> *const wall = wall_at(cell, face);
      return wall != nullptr && wall->is_closed() ? wall : nullptr;
    }

    /// True if a solid may be in an own or ghost cell, or as near as its
    /// diagonal is long.
    bool
    is_near_solid(const unsigned int cell) const
    {
      return !near_solids.empty() && near_solids[cell];
    }

    /// Send one value per own cell to the ranks that see it as ghost:
    /// entries of ghost cells are overwritten. Number: double, char.
    /// Collective.
    template <typename Number>
    void
    exchange_to_ghosts(std::vector<Number> &cell_values) const;

  private:
    void
    find_walls(const CellLattice<dim> &lattice);
    void
    find_face_neighbors(const CellLattice<dim> &lattice);
    void
    find_vertex_neighbors(const CellLattice<dim> &lattice);
    /// What is smallest around own cells.
    void
    find_reaches();
    /// Of each vertex of the triangulation the number that stands for it and
    /// for those that coincide with it across a seam.
    std::vector<unsigned int>
    joined_vertices(const CellLattice<dim> &lattice) const;

    const BackgroundGrid<dim>                          &grid;
    unsigned int                                        n_owned_cells = 0;
    std::vector<Iterator>                               iterators;
    std::vector<unsigned int>                           by_active_index;
    std::vector<CellGeometry<dim>>                      geometries;
    std::vector<std::array<unsigned int, 2 * dim>>      face_neighbors;
    std::vector<std::array<const Wall<dim> *, 2 * dim>> walls; ///< of faces
    std::vector<std::size_t>            vertex_neighbor_begin; // own cells
    std::vector<unsigned int>           vertex_neighbor_list;
    std::vector<dealii::Tensor<1, dim>> reaches;
    std::vector<char>                   near_solids; // empty: there are none
    SolidDistances<dim>                 distances_of_centres;
  };
} // namespace seiche

#endif
