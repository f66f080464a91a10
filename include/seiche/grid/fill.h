// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_fill_h
#define seiche_grid_fill_h

#include <seiche/grid/point_boxes.h>
#include <seiche/grid/surface.h>

#include <memory>
#include <vector>

namespace seiche
{
  /// A face between two occupied cells of which at least one is cut.
  struct GhostFace
  {
    unsigned int lower;     ///< local cell on the lower side
    unsigned int upper;     ///< local cell on the upper side
    unsigned int direction; ///< of the normal
    bool         thin;      ///< one of the cells is thin
  };

  /// Rules of the weak forms' quadrature.
  enum class QuadratureRule
  {
    material_points, ///< the points
    hybrid,          ///< Gauss points in full cells, points near the surface
    cut_cells        ///< the inside of a level set, and points of fragments
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
   * repartitioning change nothing. Thresholds are compared on values rounded
   * to 1e-10, so that round-off cannot flip a class between rank counts or
   * mirror images. The table of classes stands in doc/theory.md.
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

    /// Weight of the Gauss points in a cell, [0,1]; points weigh 1 - w. Own
    /// and ghost cells, as the next three.
    double
    gauss_weight(const unsigned int cell) const
    {
      return weight[cell];
    }

    bool
    is_cut(const unsigned int cell) const
    {
      return flags[cell] & cut;
    }

    bool
    is_thin(const unsigned int cell) const
    {
      return flags[cell] & thin;
    }

    bool
    is_sliver(const unsigned int cell) const
    {
      return flags[cell] & sliver;
    }

    /// Where the acceleration's gradient means little: impacts gain energy by
    /// it, and in spray it is noise.
    bool
    is_rough(const unsigned int cell) const
    {
      return rule == QuadratureRule::cut_cells ?
               is_cut(cell) :
               is_thin(cell) || is_sliver(cell);
    }

    /// Own cells on which elements of degree 2 are multilinear: at the surface
    /// and where there are no points.
    const std::vector<char> &
    linear_cells() const
    {
      return linear;
    }

    /// Second moments of the points' own extent in an own cell: (1 - w) s^2/12
    /// of its fill [-]. A point is taken as a box of the cell's shape with s
    /// times its edges, so that it holds the mean volume of the cell's points;
    /// s is 1 at most.
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

    /// sum N_I V over the node's full volume, N_I of FE_Q(1); own and ghost
    /// nodes, zero where no vertex lies.
    const Vector &
    nodal_fill() const
    {
      return node_fill;
    }

    /// Ghost faces that this rank assembles
    /// (Occupancy::for_each_assembled_face).
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

    Occupancy<dim>      &occupancy;
    const QuadratureRule rule;

  private:
    enum Flag : unsigned char
    {
      cut = 1,    ///< occupied, and a vertex neighbour inside the domain is
                  ///< not, or the fluid has left a unilateral wall
      thin   = 2, ///< cut, and point volume below 0.7 of the cell
      sliver = 4  ///< weight below one, and point volume below 0.3
    };

    /// True if a unilateral wall of the cell has little fluid beside it: it
    /// has left the wall, and has a surface there. [nodes_per_cell()]
    bool
    is_detached(const unsigned int cell, const double *at_nodes) const;

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

    /// Add the hats' values at a cell's points, times their volume, to the
    /// nodal fill.
    void
    add_values(const PointCloud<dim> &points, const unsigned int cell);

    /// Nodal fill, cell fill and the share of the fluid where there is too
    /// much.
    void
    sum_points(const PointCloud<dim> &points);

    /// The level set, the cells that it occupies and the loose points.
    void
    find_surface(const PointCloud<dim> &points);

    /// What the weak forms' points weigh in a cell.
    struct Content
    {
      bool   is_cut;
      double gauss_weight;
      double loose;       ///< volume of material points over the cell's
      double volume;      ///< of all over the cell's
      bool   is_fragment; ///< hardly more than material points
    };
    Content
    content(const unsigned int cell, const PointCloud<dim> &points) const;

    bool
    touches_unoccupied(const unsigned int cell) const;

    void
    classify(const PointCloud<dim> &points);
    void
    collect_ghost_faces();
    void
    collect_linear_cells(const PointCloud<dim> &points);

    const FilledVolume                  filled;
    const PointBoxes<dim>               boxes;
    std::vector<double>                 current_volumes; ///< J V0
    const std::unique_ptr<Surface<dim>> free_surface;    ///< with cut cells
    std::vector<double>                 loose;           ///< of the points
    std::vector<char>                   has_loose;       ///< own cells
    std::vector<double>                 weight, fill, extent_moments;
    std::vector<unsigned char>          flags;
    std::vector<char>                   linear;
    Vector                              node_fill;
    std::vector<GhostFace>              faces;
    double                              overfull = 0.;
  };
} // namespace seiche

#endif
