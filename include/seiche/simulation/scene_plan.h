// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_scene_plan_h
#define seiche_simulation_scene_plan_h

#include <seiche/scene/mesh_estimate.h>
#include <seiche/scene/smallest_cell.h>
#include <seiche/simulation/cost_model.h>
#include <seiche/simulation/scene.h>
#include <seiche/simulation/scene_scales.h>

#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief What a run of a scene will need: cells, points, steps, seconds,
   * memory, files.
   *
   * Estimated without a grid and without points, in a fraction of a second for
   * scenes of any size.
   */
  template <int dim>
  class ScenePlan
  {
  public:
    /// @p bodies of the scene. Local.
    ScenePlan(const Scene<dim>                  &scene,
              const std::vector<FluidBody<dim>> &bodies);

    /// InputError for bodies that surely hold no point (of others the seeding
    /// will know) and for what does not fit into the memory of @p ranks
    /// machines.
    void
    require_possible(const InputFile &input, const unsigned int ranks) const;

    /// For the user: numbers of cells, points and steps on one line.
    std::string
    size_text() const;

    /// For the user: smallest cell, time, memory and files, two lines.
    std::string
    cost_text() const;

    /// What is hardly meant or will not go well: that of the scales, months of
    /// time, a full disk.
    /// @p directory: of the results; it need not exist.
    std::vector<std::string>
    doubts(const std::string &directory) const;

    SceneScales  scales; ///< at the start
    MeshEstimate mesh;
    double       points  = 0.;
    double       steps   = 0.;
    double       seconds = 0.; ///< of processor time
    double       memory  = 0.; ///< [bytes], of all ranks
    double       frames  = 0.; ///< of each kind that is written
    double       files   = 0.; ///< [bytes]
    SmallestCell smallest;

  private:
    void
    count_points(const Scene<dim>                    &scene,
                 const std::vector<FluidBody<dim>>   &bodies,
                 const std::vector<SampledBody<dim>> &samples,
                 const SceneMap<dim>                 &map);
    void
    count_steps(const Scene<dim>     &scene,
                const SceneMap<dim>  &map,
                const BodyForce<dim> &force);
    void
    count_seconds(const Scene<dim>     &scene,
                  const SceneMap<dim>  &map,
                  const BodyForce<dim> &force,
                  const CostModel      &cost);
    void
    count_files(const Scene<dim> &scene, const CostModel &cost);

    bool   steps_are_least = false; ///< there may be many more
    double point_memory    = 0.;    ///< of that [bytes]
    std::vector<std::string> empty_bodies;
  };
} // namespace seiche

#endif
