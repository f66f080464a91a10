// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_grid_parameters_h
#define seiche_scene_grid_parameters_h

#include <seiche/scene/refinement.h>
#include <seiche/scene/solid.h>
#include <seiche/scene/wall.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /**
   * @brief The box domain, its grid lines, walls and obstacles (prm entries).
   */
  template <int dim>
  struct GridParameters
  {
    dealii::Point<dim>                         lower_corner;   // [m]
    dealii::Point<dim>                         upper_corner;   // [m]
    double                                     cell_size = 0.; // [m], 0: unused
    std::array<std::vector<double>, dim>       break_points;   // interior, [m]
    std::array<std::vector<unsigned int>, dim> cells; // per segment, or empty
    std::vector<Wall<dim>>    walls; ///< by boundary id: sides, obstacles
    RefinementParameters<dim> refinement;
    std::vector<Solid<dim>>   solids; ///< walls that cut cells (make_solids())

    /// Makes room for the obstacles that @p input names.
    GridParameters(const InputFile &input);
    /// Subsections "Grid", "Walls", "Obstacle NAME" and "Refinement NAME".
    void
    add_parameters(dealii::ParameterHandler &prm);
    /// Reads the parsed strings; InputError for what makes no sense.
    void
    check(const InputFile &input);

    /// The walls that are no sides.
    dealii::ArrayView<const Wall<dim>>
    obstacles() const
    {
      return {walls.data() + 2 * dim, walls.size() - 2 * dim};
    }

    /// The obstacle that a place lies in, or null.
    const Wall<dim> *
    obstacle_at(const dealii::Point<dim> &place) const;

    /// Fewest cells along a periodic direction: a cell, the two beside it and
    /// one that is beside none of them, so that a neighbour is so on one side.
    static constexpr unsigned int fewest_periodic_cells = 4;

    /// True if the two sides across @p direction are one place.
    bool
    is_periodic(const unsigned int direction) const;
    /// True if some direction is periodic.
    bool
    any_periodic() const;

    /// True if the fluid may leave some wall; if some wall has friction.
    bool
    any_unilateral() const;
    bool
    any_friction() const;

    /// True if some wall moves along its normal; if some moves at all.
    bool
    any_displaced() const;
    bool
    any_moving() const;

    /// The whole box.
    dealii::BoundingBox<dim>
    domain() const;

    /// Where a place of the start is once the sides have gone to those of @p
    /// box: what is on a side goes with it; what is on an obstacle, up to
    /// wall_slack(), is exactly there, so that it can be found.
    dealii::Point<dim>
    with_sides(const dealii::Point<dim>       &place,
               const dealii::BoundingBox<dim> &box) const;

  private:
    void
    add_side_parameters(dealii::ParameterHandler &prm);
    void
    add_obstacle_parameters(dealii::ParameterHandler &prm);
    void
    check_walls(const InputFile &input);
    void
    check_lines(const InputFile &input, const unsigned int direction);
    /// The box of a side.
    void
    lay_side(Wall<dim> &wall) const;
    void
    check_obstacle(const InputFile &input, const unsigned int id);
    void
    check_friction(const InputFile &input) const;
    void
    check_periodic(const InputFile &input) const;
    void
    check_periodic_obstacle(const InputFile   &input,
                            const unsigned int direction) const;
    void
    check_size(const InputFile &input) const;
    void
    check_thin_cells(const InputFile &input) const;

    // strings as parsed; one per direction or instance
    std::array<std::string, dim> break_points_text;
    std::array<std::string, dim> cells_text;
    std::string                  contact = "sticking";
    std::string                  lower_text, upper_text;
    struct WallText
    {
      std::string condition = "slip", lower, upper;
    };
    std::vector<WallText> walls_text;
  };

  /// Name of a side of the box, e.g. "left", from its boundary id.
  template <int dim>
  std::string
  side_name(const unsigned int id);
} // namespace seiche

#endif
