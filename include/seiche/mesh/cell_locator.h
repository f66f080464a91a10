// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_cell_locator_h
#define seiche_mesh_cell_locator_h

#include <seiche/mesh/cell_geometry.h>
#include <seiche/scene/background_grid.h>
#include <seiche/utilities/box_face.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstdint>
#include <vector>

namespace seiche
{
  /**
   * @brief Own and ghost cells of this rank: geometry and location of points.
   *
   * Cells are numbered locally: 0 ... n_owned()-1 are the rank's own cells in
   * the order of the triangulation, then the ghost cells. All are
   * axis-parallel boxes, so a position is located in closed form: segment and
   * index on the finest lattice (that of the finest level that refinement may
   * make) per direction, then the cell whose lattice box holds the index. Cells
   * are half-open, [lower, upper); only the upper sides of the domain belong to
   * their cell. The result depends on the position alone, never on the rank
   * count. A position on a wall up to 1e-10 of a cell belongs to the cell
   * inside.
   *
   * Periodic sides are no boundary: cells across the seam are neighbours, and a
   * position beyond it is found where wrapped() takes it. Coordinates of a cell
   * and of a position found in it may then differ by a period: image().
   */
  template <int dim>
  class CellLocator
  {
  public:
    static constexpr unsigned int invalid = static_cast<unsigned int>(-1);

    /// @p background_grid must outlive the locator.
    explicit CellLocator(const BackgroundGrid<dim> &background_grid);

    /// Rebuild the tables after a change of the mesh. Local.
    void
    reinit();

    /// Place of a grid line [m], from its direction and its place in
    /// BackgroundGrid [m]; linear between the ends of a segment.
    using LinePlace = std::function<double(const unsigned int, const double)>;

    /// Move the grid lines, now and for meshes to come; the triangulation stays
    /// as it is. Points have to be located anew. Local.
    void
    move(const LinePlace &place);

    /// Where a place of BackgroundGrid is since then [m].
    dealii::Point<dim>
    moved(const dealii::Point<dim> &x) const;

    unsigned int
    n_owned() const
    {
      return n_owned_cells;
    }

    /// Own and ghost cells.
    unsigned int
    n_cells() const
    {
      return geometries.size();
    }

    /// Where @p x is inside the domain if it is beyond a periodic side: half
    /// open, [lower, upper). Other coordinates stay.
    dealii::Point<dim>
    wrapped(const dealii::Point<dim> &x) const
    {
      return has_seam ? wrapped_at_seam(x) : x;
    }

    /// @p x moved by periods so that it is nearest to the cell.
    dealii::Point<dim>
    image(const dealii::Point<dim> &x, const unsigned int cell) const
    {
      return has_seam ? image_at_seam(x, cell) : x;
    }

    /// @p x in periodic directions as difference of two places: the least.
    dealii::Tensor<1, dim>
    shortest(const dealii::Tensor<1, dim> &x) const
    {
      return has_seam ? shortest_at_seam(x) : x;
    }

    /// Cell that holds @p x (wrapped) among own and ghost cells, or invalid. @p
    /// hint is tried first, then its neighbours. Local.
    unsigned int
    find(const dealii::Point<dim> &x, const unsigned int hint = invalid) const;

    const CellGeometry<dim> &
    geometry(const unsigned int cell) const
    {
      return geometries[cell];
    }

    /// Rank that owns the cell.
    unsigned int
    owner(const unsigned int cell) const
    {
      return owners[cell];
    }

    /// Cell across a face (deal.II's face number), of the same or a coarser
    /// level; invalid at a wall and where the neighbour is not known to this
    /// rank or is refined.
    unsigned int
    neighbor(const unsigned int cell, const unsigned int face) const
    {
      return face_neighbors[cell][face];
    }

    /// True at a wall and at an open side; own cells.
    bool
    at_boundary(const unsigned int cell, const unsigned int face) const
    {
      return wall_at(cell, face) != nullptr;
    }

    /// Own and ghost cells that share a vertex with an own cell (without it),
    /// ascending. Across a level jump, cells that touch share a vertex too.
    dealii::ArrayView<const unsigned int>
    vertex_neighbors(const unsigned int cell) const
    {
      return {vertex_neighbor_list.data() + vertex_neighbor_begin[cell],
              vertex_neighbor_begin[cell + 1] - vertex_neighbor_begin[cell]};
    }

    /// Refinement level above the coarse cells of the forest.
    unsigned int
    level(const unsigned int cell) const
    {
      return iterators[cell]->level();
    }

    /// Smallest edges among an own cell and its vertex neighbours [m]: what
    /// moves no farther stays among these.
    const dealii::Tensor<1, dim> &
    reach(const unsigned int cell) const
    {
      return reaches[cell];
    }

    /// Send one value per own cell to the ranks that see it as ghost:
    /// entries of ghost cells are overwritten. Number: double, char.
    /// Collective.
    template <typename Number>
    void
    exchange_to_ghosts(std::vector<Number> &cell_values) const;

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
      return wall != nullptr && wall->condition != WallCondition::open ?
               wall :
               nullptr;
    }

    /// True if the cell has a face on a periodic side.
    bool
    at_seam(const unsigned int cell, const BoxFace face) const
    {
      const unsigned int d = face.direction();
      return periodic[d] && (face.is_upper() ? lattice_upper[cell][d] + 1 ==
                                                 lines[d].places.size() :
                                               lattice_lower[cell][d] == 0);
    }
    bool
    at_seam(const unsigned int cell) const;

    /// Place in a cell in halves of its edges (0, 1, 2 per direction), as
    /// halves of the finest lattice's cells, the same on both sides of a seam.
    std::array<unsigned int, dim>
    lattice_place(const unsigned int                   cell,
                  const std::array<unsigned int, dim> &halves) const;

    /// Number of cells of the finest lattice along an edge of the cell.
    unsigned int
    lattice_size(const unsigned int cell) const
    {
      return lattice_upper[cell][0] - lattice_lower[cell][0];
    }

    /// Global index on the finest lattice, x fastest, of a lattice cell inside
    /// a cell, @p offset from its lowest: the same on every rank count and
    /// mesh.
    std::uint64_t
    lattice_index(const unsigned int                   cell,
                  const std::array<unsigned int, dim> &offset = {}) const;

    /// Number of cells of that lattice; a double holds it where 64 bits do not.
    double
    n_lattice_cells() const;

    /// Box of that lattice cell.
    dealii::BoundingBox<dim>
    lattice_box(const unsigned int                   cell,
                const std::array<unsigned int, dim> &offset) const;

    /// Local number of an own or ghost cell.
    unsigned int
    index(const typename dealii::Triangulation<dim>::active_cell_iterator &cell)
      const
    {
      return by_active_index[cell->active_cell_index()];
    }

    const typename dealii::Triangulation<dim>::active_cell_iterator &
    iterator(const unsigned int cell) const
    {
      return iterators[cell];
    }

    /// The wall through which a position outside left, found from the side of
    /// the box it lies beyond (or the obstacle it lies in); null for a position
    /// in the fluid domain.
    const Wall<dim> *
    wall_beyond(const dealii::Point<dim> &x) const;

    /// The domain's box as it stands.
    dealii::BoundingBox<dim>
    domain() const;

    const BackgroundGrid<dim> &grid;

  private:
    using Lattice = std::array<unsigned int, dim>;

    /// Grid lines of a direction on the finest lattice; cell i lies between
    /// lines i and i + 1.
    struct Lines
    {
      struct Segment
      {
        double       end;          // [m]
        double       begin;        // [m]
        double       inverse_size; // [1/m]
        unsigned int first;
      };
      std::vector<Segment> segments;
      std::vector<double>  places; // [m]

      /// Index of the half-open cell; x must lie between the outer lines.
      unsigned int
      index(const double x) const;
    };

    /// Lines of a direction, @p place as in move().
    Lines
    make_line(const unsigned int direction, const LinePlace &place) const;
    void
    make_lines();
    /// The geometry of a cell between the lines.
    void
    set_geometry(const unsigned int cell);
    /// What is smallest around own cells.
    void
    find_reaches();
    void
    add_cell(
      const typename dealii::Triangulation<dim>::active_cell_iterator &cell);
    void
    find_face_neighbors();
    void
    find_vertex_neighbors();
    // asked for by every point and piece of the surface: a call only where
    // there is a seam
    dealii::Point<dim>
    wrapped_at_seam(const dealii::Point<dim> &x) const;
    dealii::Point<dim>
    image_at_seam(const dealii::Point<dim> &x, const unsigned int cell) const;
    dealii::Tensor<1, dim>
    shortest_at_seam(const dealii::Tensor<1, dim> &x) const;

    /// Cell across a face on a periodic side, as neighbor().
    unsigned int
    across_seam(const unsigned int cell, const BoxFace face) const;
    /// Of each vertex of the triangulation the number that stands for it and
    /// for those that coincide with it across a seam.
    std::vector<unsigned int>
    joined_vertices() const;

    /// Index on the finest lattice; false if outside the box.
    bool
    lattice_position(const dealii::Point<dim> &x, Lattice &index) const;
    bool
    in_obstacle(const Lattice &index) const;
    bool
    covers(const unsigned int cell, const Lattice &index) const;
    /// Own or ghost cell that covers the lattice cell, or invalid.
    unsigned int
    search(const Lattice &index) const;
    /// A position that is in no lattice cell but perhaps on a wall.
    unsigned int
    find_at_wall(const dealii::Point<dim> &x) const;

    unsigned int                                        n_owned_cells = 0;
    std::vector<CellGeometry<dim>>                      geometries;
    std::vector<unsigned int>                           owners;
    std::vector<std::array<unsigned int, 2 * dim>>      face_neighbors;
    std::vector<std::array<const Wall<dim> *, 2 * dim>> walls; ///< of faces
    std::vector<std::size_t>            vertex_neighbor_begin; // own cells
    std::vector<unsigned int>           vertex_neighbor_list;
    std::vector<dealii::Tensor<1, dim>> reaches;
    std::vector<Lattice>                lattice_lower; // finest lattice box
    std::vector<Lattice>                lattice_upper; // exclusive
    std::vector<unsigned int>           by_active_index;
    std::vector<typename dealii::Triangulation<dim>::active_cell_iterator>
                           iterators;
    std::array<Lines, dim> lines;     // where they are
    std::array<Lines, dim> reference; // of the triangulation, never moved
    LinePlace              line_place;
    std::array<bool, dim>  periodic{};
    bool                   has_seam       = false; // in some direction
    unsigned int           finest_level   = 0;
    unsigned int           obstacle_shift = 0; // grid's lattice -> finest
    // (Morton key of the lower lattice corner, cell), sorted by key: the cells
    // of a forest of 2^n-refined boxes are intervals of this order
    std::vector<std::pair<std::uint64_t, unsigned int>> by_key;
  };
} // namespace seiche

#endif
