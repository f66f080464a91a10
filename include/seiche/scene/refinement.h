// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_refinement_h
#define seiche_scene_refinement_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;
  template <int dim>
  struct GridParameters;

  /// What a refinement criterion is about.
  enum class RefinementKind
  {
    fluid,        ///< cells that hold points
    free_surface, ///< of these, those beside a cell without points
    walls,        ///< fluid near walls and obstacles
    probes,       ///< fluid near probes
    box           ///< a box in space, with fluid or without
  };

  /**
   * @brief One criterion of the adaptive mesh (prm subsection "Refinement
   * NAME"): where cells have at least a given level.
   *
   * Levels count from the cells of subsection "Grid": level n has edges of
   * 2^-n of theirs. Cells that no criterion claims are as coarse as the grid
   * lines allow.
   */
  template <int dim>
  struct RefinementCriterion
  {
    std::string    name;
    RefinementKind kind     = RefinementKind::fluid;
    unsigned int   level    = 0;
    unsigned int   layers   = 2;  // of cells of the level, around what is meant
    double         distance = 0.; // [m] from walls and probes
    /// Walls: parts of the boundary as boxes without thickness; probes: points;
    /// box: the box. [m]
    std::vector<dealii::BoundingBox<dim>> places;

    /// True if the criterion marks cells from where the points are.
    bool
    follows_fluid() const
    {
      return kind == RefinementKind::fluid ||
             kind == RefinementKind::free_surface;
    }
  };

  /// prm entries of the adaptive mesh.
  template <int dim>
  struct RefinementParameters
  {
    std::vector<RefinementCriterion<dim>> criteria;
    unsigned int                          adapt_every = 4; // steps

    /// Makes room for the criteria that @p input names.
    RefinementParameters(const InputFile &input);
    /// Subsections "Refinement NAME" and entry "Grid/Adapt every".
    void
    add_parameters(dealii::ParameterHandler &prm);
    /// Reads the parsed strings; after GridParameters::check(). InputError
    /// with place.
    void
    check(const InputFile &input, const GridParameters<dim> &grid);

    /// Without criteria the mesh is uniform and never changes.
    bool
    is_adaptive() const
    {
      return !criteria.empty();
    }

    /// Greatest level of all criteria.
    unsigned int
    finest_level() const;

    /// Greatest level at the free surface, 0 without such a criterion.
    unsigned int
    free_surface_level() const;

  private:
    struct Text
    {
      std::string kind = "free surface", names, lower, upper;
    };
    std::vector<Text> texts; // as parsed

    void
    read_walls(const InputFile           &input,
               const GridParameters<dim> &grid,
               const unsigned int         index);
    void
    read_probes(const InputFile &input, const unsigned int index);
    void
    read_box(const InputFile           &input,
             const GridParameters<dim> &grid,
             const unsigned int         index);
  };
} // namespace seiche

#endif
