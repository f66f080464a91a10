// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_background_grid_h
#define seiche_scene_background_grid_h

#include <seiche/scene/refinement.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <deal.II/distributed/tria.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// What a wall does to the displacement of the fluid that touches it.
  enum class WallCondition
  {
    slip,       ///< normal component fixed
    unilateral, ///< the same, but the fluid may leave the wall
    no_slip,    ///< all components fixed
    open        ///< nothing fixed; points that cross it leave as outflow
  };

  /**
   * @brief The box domain, its grid lines, walls and obstacles (prm entries).
   */
  template <int dim>
  struct GridParameters
  {
    struct Obstacle
    {
      std::string        name;
      dealii::Point<dim> lower_corner; // [m]
      dealii::Point<dim> upper_corner; // [m]
      WallCondition      condition = WallCondition::slip;
      double             friction  = 0.; // skin friction coefficient [-]
    };

    dealii::Point<dim>                         lower_corner;   // [m]
    dealii::Point<dim>                         upper_corner;   // [m]
    double                                     cell_size = 0.; // [m], 0: unused
    std::array<std::vector<double>, dim>       break_points;   // interior, [m]
    std::array<std::vector<unsigned int>, dim> cells; // per segment, or empty
    std::array<WallCondition, 2 * dim>         walls; // by boundary id
    std::vector<Obstacle>                      obstacles;
    RefinementParameters<dim>                  refinement;

    /// Makes room for the obstacles that @p input names.
    GridParameters(const InputFile &input);
    /// Subsections "Grid", "Walls", "Obstacle NAME" and "Refinement NAME".
    void
    add_parameters(dealii::ParameterHandler &prm);
    /// Reads the parsed strings; InputError for what makes no sense.
    void
    check(const InputFile &input);

    /// Number of boundary ids: 2 dim + number of obstacles.
    unsigned int
    n_walls() const;

    /// By boundary id; friction: skin friction coefficient [-].
    WallCondition
    wall_condition(const unsigned int id) const;
    double
    friction(const unsigned int id) const;

    /// True if the fluid may leave some wall; if some wall has friction.
    bool
    any_unilateral() const;
    bool
    any_friction() const;

    /// Text and path of the entry with a wall's velocity, by boundary id.
    std::string
    wall_velocity_text(const unsigned int id) const;
    std::string
    wall_velocity_path(const unsigned int id) const;

    /// The same of the displacement of a side.
    const std::string &
    wall_displacement_text(const unsigned int side) const;
    std::string
    wall_displacement_path(const unsigned int side) const;

    /// The whole box.
    dealii::BoundingBox<dim>
    domain() const;

  private:
    void
    add_wall_parameters(dealii::ParameterHandler &prm);
    void
    check_walls(const InputFile &input);
    void
    check_lines(const InputFile &input, const unsigned int direction);
    void
    check_obstacle(const InputFile &input, const unsigned int index);
    void
    check_friction(const InputFile &input) const;
    void
    check_size(const InputFile &input) const;

    // strings as parsed; one per direction or instance
    std::array<std::string, dim>     break_points_text;
    std::array<std::string, dim>     cells_text;
    std::array<std::string, 2 * dim> walls_text;
    std::array<std::string, 2 * dim> velocities_text;
    std::array<std::string, 2 * dim> displacements_text;
    std::array<double, 2 * dim>      walls_friction{};
    std::string                      contact = "sticking";
    std::string                      lower_text, upper_text;
    struct ObstacleText
    {
      std::string name, lower, upper, condition = "slip", velocity;
      double      friction = 0.;
    };
    std::vector<ObstacleText> obstacles_text;
  };

  /// Name of a side of the box, e.g. "left", from its boundary id.
  template <int dim>
  std::string
  side_name(const unsigned int id);

  /// Equal cells between two grid lines of one direction.
  struct GridSegment
  {
    double       begin; // [m]
    double       end;   // [m]
    unsigned int first; // index of its first cell, finest level
    unsigned int cells; // number of finest cells
  };

  /**
   * The segments of one direction: between break points, split at the corners
   * of obstacles. An obstacle's corner inside a segment becomes a grid line:
   * where it coincides with one (to 1e-9 of a cell) nothing else changes,
   * elsewhere the segment's cells are shared out between its two parts in
   * proportion, at least one each.
   */
  template <int dim>
  std::vector<GridSegment>
  make_segments(const GridParameters<dim> &parameters,
                const unsigned int         direction);

  /**
   * @brief The background grid: a forest of axis-parallel boxes.
   *
   * Grid lines are given per direction by break points and the number of
   * equal cells between two of them. The coarse cells are as large as the
   * cell counts allow (the largest common power of two is made by
   * refinement); coarse cells inside an obstacle do not exist. The cells of
   * the lines are level 0 for the user; refinement criteria add levels, and
   * cells that none of them claims may be coarser. Boundary ids:
   * 2 d and 2 d + 1 for the lower and upper side of the box in direction d,
   * 2 dim + i for obstacle i. Names of the sides: left, right, bottom, top in
   * 2D; left, right, front, back, bottom, top in 3D.
   */
  template <int dim>
  class BackgroundGrid
  {
  public:
    using Segment = GridSegment;
    /// Indices of cells on the finest lattice: [first, second) per direction.
    using LatticeBox =
      std::pair<std::array<unsigned int, dim>, std::array<unsigned int, dim>>;

    /// Collective. @p grid_parameters must outlive the grid.
    BackgroundGrid(const GridParameters<dim> &grid_parameters,
                   MPI_Comm                   communicator);

    /// Divide the cells among the ranks so that each gets an equal share of
    /// the weights; own cells only are asked. Collective.
    void
    repartition(
      const std::function<unsigned int(
        const typename dealii::Triangulation<dim>::cell_iterator &)> &weight);

    const std::vector<Segment> &
    segments(const unsigned int direction) const;

    /// Number of finest cells in a direction, obstacles included.
    unsigned int
    n_lattice_cells(const unsigned int direction) const;

    /// Forest level of the cells between the grid lines: the user's level 0.
    unsigned int
    lattice_level() const;

    /// Greatest forest level that refinement may make.
    unsigned int
    finest_level() const;

    /// The cells that do not exist because of obstacle @p index.
    const LatticeBox &
    obstacle_box(const unsigned int index) const;

    /// Name of a boundary id, e.g. "left" or the name of an obstacle.
    std::string
    wall_name(const dealii::types::boundary_id id) const;

    /// Number of boundary ids: 2 dim + number of obstacles.
    unsigned int
    n_walls() const;

    WallCondition
    wall_condition(const dealii::types::boundary_id id) const;

    const GridParameters<dim>                        &parameters;
    dealii::parallel::distributed::Triangulation<dim> triangulation;

  private:
    void
    make_coarse_cells();
    void
    set_boundary_ids();

    std::array<std::vector<Segment>, dim> lattice;
    std::vector<LatticeBox>               obstacle_boxes;
    unsigned int                          n_refinements = 0;
  };
} // namespace seiche

#endif
