// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_fill_h
#define seiche_grid_fill_h

#include <seiche/grid/closed_chambers.h>
#include <seiche/grid/point_boxes.h>
#include <seiche/grid/surface.h>

#include <memory>
#include <vector>

namespace seiche
{
  /// A face between two occupied cells of which at least one is cut.
  struct GhostFace
  {
    unsigned int lower;      ///< local cell on the lower side
    unsigned int upper;      ///< local cell on the upper side
    unsigned int direction;  ///< of the normal
    bool         fragment;   ///< one of the cells has points, hardly an inside
    double       fluid = 1.; ///< [cells] that the penalty stands for, at most 1
  };

  /// Rules of the weak forms' quadrature.
  enum class QuadratureRule
  {
    cut_cells,      ///< the inside of a level set, and points of fragments
    material_points ///< the points
  };

  /// What of a point fills the grid.
  enum class FilledVolume
  {
    initial, ///< V0: an incompressible fluid's J is an error of its motion
    current  ///< J V0: of a compressible fluid
  };

  /**
   * @brief How full cells and nodes are, and what follows for each cell.
   *
   * Recomputed every step from the points alone, so that restart and
   * repartitioning change nothing. Thresholds are compared on values rounded to
   * 1e-10, so that round-off cannot flip a class between rank counts or mirror
   * images. Fill of a node: doc/theory.md (5.0a); the table of classes stands
   * in section 5.
   */
  template <int dim>
  class Fill
  {
  public:
    using Vector = typename Occupancy<dim>::Vector;

    /// Of @p rule depend the classes. @p occupancy must outlive the object.
    Fill(Occupancy<dim>      &occupancy,
         const QuadratureRule rule,
         const FilledVolume   filled = FilledVolume::initial);

    /// After Occupancy::update(); cells with an inside but no points are
    /// occupied then. Collective.
    void
    update(const PointCloud<dim> &points);

    /// False with material points.
    bool
    has_surface() const
    {
      return free_surface != nullptr;
    }

    /// With cut cells.
    const Surface<dim> &
    surface() const
    {
      return *free_surface;
    }

    /// Shares of the points of an own cell that the surface does not represent,
    /// or null if there are none. With cut cells.
    const double *
    loose_shares(const PointCloud<dim> &points, const unsigned int cell) const
    {
      return has_loose[cell] ? &loose[points.first_point(cell)] : nullptr;
    }

    /// Volume of the points in an own cell that the surface does not represent,
    /// over the cell's.
    double
    loose_volume(const unsigned int cell, const PointCloud<dim> &points) const;

    /// Share of a cell that is inside the surface [0,1]: the weight of its
    /// Gauss points; 0 with material points. Own and ghost cells.
    double
    inside_share(const unsigned int cell) const
    {
      return has_surface() ? surface().inside_share(cell) : 0.;
    }

    /// True if the surface sees nothing of the fluid in an occupied cell: all
    /// that its points are is loose (drops, thin sheets). Own and ghost cells.
    bool
    is_spray(const unsigned int cell) const
    {
      return has_surface() && surface().inside_share(cell) == 0.;
    }

    /// True if the inside fills the cell, whose quadrature are Gauss points
    /// then. Own and ghost cells.
    bool
    is_full(const unsigned int cell) const
    {
      return inside_share(cell) == 1. && !walls().cuts(cell);
    }

    /// True if there is no room in the cell but for solids. Own cells.
    bool
    has_no_room(const unsigned int cell) const;

    /// The wall of solids in an own cell where there is fluid at it, or null.
    const std::vector<WallPoint<dim>> *
    wall(const unsigned int cell) const
    {
      return has_surface() ? surface().wall(cell) : nullptr;
    }

    /// True if the cell is occupied and the inside does not fill it (material
    /// points: a vertex neighbour inside the domain is not occupied). Own and
    /// ghost cells.
    bool
    is_cut(const unsigned int cell) const
    {
      return cut[cell];
    }

    /// Chambers whose cells are all full (material points: occupied).
    const ClosedChambers<dim> &
    closed_chambers() const
    {
      return closed;
    }

    /// Own cells on which elements of degree 2 are multilinear: at the surface
    /// and where there are no points.
    const std::vector<char> &
    linear_cells() const
    {
      return linear;
    }

    /// Second moments of the own extent of the points that the surface does not
    /// represent (all with material points), in an own cell: s^2/12 of their
    /// share of its volume [-]. A point is taken as a box of the cell's shape
    /// with s times its edges, so that it holds the mean volume of the cell's
    /// points; s is 1 at most.
    double
    extent_moment(const unsigned int cell) const
    {
      return extent_moments[cell];
    }

    /// Volume of the points in an own cell over its measure.
    double
    cell_fill(const unsigned int cell) const
    {
      return fill[cell];
    }

    /// sum N_I V over the node's full volume, N_I of FE_Q(1) averaged over the
    /// points' boxes; own and ghost nodes, zero where no vertex lies.
    const Vector &
    nodal_fill() const
    {
      return node_fill;
    }

    /// 1 at nodes whose cells are all occupied and not cut, 0 at others; own
    /// and ghost nodes.
    const Vector &
    inner_nodes() const
    {
      return inner;
    }

    /// Ghost faces that this rank assembles
    /// (for_each_assembled_face()).
    const std::vector<GhostFace> &
    ghost_faces() const
    {
      return faces;
    }

    /// sum_I max(0, fill_I - 1) V_I / sum V, all ranks.
    double
    overfull_fraction() const
    {
      return overfull;
    }

    Occupancy<dim> &occupancy;

  private:
    const CutWalls<dim> &
    walls() const
    {
      return occupancy.mesh_nodes.cut_walls;
    }

    /// Volumes of the points.
    const double *
    volumes(const PointCloud<dim> &points) const
    {
      return filled == FilledVolume::initial ?
               points.data(PointColumn::initial_volume) :
               current_volumes.data();
    }

    void
    find_current_volumes(const PointCloud<dim> &points);

    /// Nodal fill, cell fill and the share of the fluid where there is too
    /// much.
    void
    sum_points(const PointCloud<dim> &points);

    /// The level set, the cells that it occupies and the loose points.
    void
    find_surface(const PointCloud<dim> &points);

    bool
    touches_unoccupied(const unsigned int cell) const;

    void
    classify(const PointCloud<dim> &points);
    void
    mark_inner_nodes();
    /// Of each cell, in cells, on which a ghost penalty may act: all of it, or
    /// of spray the volume of its points. Collective.
    std::vector<double>
    penalised_fluid(const PointCloud<dim> &points) const;
    void
    collect_ghost_faces(const PointCloud<dim> &points);

    const FilledVolume                  filled;
    const PointBoxes<dim>               boxes;
    std::vector<double>                 current_volumes; ///< J V0
    const std::unique_ptr<Surface<dim>> free_surface;    ///< with cut cells
    std::vector<double>                 loose;           ///< of the points
    std::vector<char>                   has_loose;       ///< own cells
    std::vector<double>                 fill, extent_moments;
    std::vector<char>                   cut; ///< own and ghost cells
    std::vector<char>                   linear;
    Vector                              node_fill, inner;
    std::vector<GhostFace>              faces;
    double                              overfull = 0.;
    ClosedChambers<dim>                 closed;
  };
} // namespace seiche

#endif
