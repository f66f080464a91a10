// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_grid_lines_h
#define seiche_mesh_grid_lines_h

#include <seiche/mesh/cell_geometry.h>
#include <seiche/scene/background_grid.h>
#include <seiche/scene/grid_motion.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace seiche
{
  /**
   * @brief The lines of the finest lattice, where they are now: that of the
   * finest level that refinement may make, over the whole box of the domain.
   *
   * Lattice cell i of a direction lies between lines i and i + 1.
   */
  template <int dim>
  class GridLines
  {
  public:
    using Index = std::array<unsigned int, dim>;

    /// @p grid must outlive the object.
    explicit GridLines(const BackgroundGrid<dim> &grid);

    /// To where @p motion, which must outlive the object, has them at @p time
    /// [s], and later meshes' too.
    void
    move(const GridMotion<dim> &motion, const double time);

    /// Where a place of BackgroundGrid is since then [m].
    dealii::Point<dim>
    moved(const dealii::Point<dim> &x) const;

    /// The time of the last move() [s].
    double
    time() const
    {
      return time_of_lines;
    }

    /// The domain's box as it stands.
    dealii::BoundingBox<dim>
    domain() const;

    /// Ends of the domain in a direction [m].
    double
    front(const unsigned int direction) const
    {
      return lines[direction].places.front();
    }
    double
    back(const unsigned int direction) const
    {
      return lines[direction].places.back();
    }

    /// Of line @p i of a direction [m].
    double
    place(const unsigned int direction, const unsigned int i) const
    {
      return lines[direction].places[i];
    }

    /// Number of lattice cells in a direction, obstacles included.
    unsigned int
    n_cells(const unsigned int direction) const
    {
      return lines[direction].places.size() - 1;
    }

    /// Lattice cell, half-open, of a coordinate between the outer lines.
    unsigned int
    index(const unsigned int direction, const double x) const
    {
      return lines[direction].index(x);
    }

    /// The same of the triangulation, which never moves.
    unsigned int
    index_at_start(const unsigned int direction, const double x) const
    {
      return start[direction].index(x);
    }

    /// Between two lines a direction.
    CellGeometry<dim>
    box(const Index &lower, const Index &upper) const;

    /// True if an obstacle is there.
    bool
    in_obstacle(const Index &index) const;

    const BackgroundGrid<dim> &grid;

  private:
    struct Line
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

      unsigned int
      index(const double x) const;
    };

    /// All lines, as @p motion has them.
    void
    make_lines();

    /// @p motion: null for those of the triangulation.
    Line
    make_line(const unsigned int     direction,
              const GridMotion<dim> *motion) const;

    std::array<Line, dim>  lines; // where they are
    std::array<Line, dim>  start; // of the triangulation
    const GridMotion<dim> *motion         = nullptr;
    double                 time_of_lines  = 0.;
    unsigned int           obstacle_shift = 0; // grid's lattice -> finest
  };
} // namespace seiche

#endif
