// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/body_pieces.h>
#include <seiche/postprocess/output_parameters.h>
#include <seiche/scene/speed_of_fall.h>
#include <seiche/simulation/cost_model.h>
#include <seiche/simulation/scene_plan.h>
#include <seiche/utilities/readable.h>

#include <deal.II/base/utilities.h>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double a_month = 30. * 86400.; // [s]

    template <int dim>
    constexpr unsigned int pieces_per_direction = (dim == 2 ? 128 : 32);

    double
    available_memory()
    {
      const double physical = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                              static_cast<double>(sysconf(_SC_PAGE_SIZE));
      rlimit limit; // of addresses (ulimit -v)
      return ::getrlimit(RLIMIT_AS, &limit) == 0 &&
                 limit.rlim_cur != RLIM_INFINITY ?
               std::min(physical, static_cast<double>(limit.rlim_cur)) :
               physical;
    }

    /// Free space where the folder is or will be [bytes].
    double
    free_space(const std::string &directory)
    {
      auto            path = std::filesystem::absolute(directory);
      std::error_code error;
      while (!std::filesystem::exists(path, error) && path.has_relative_path())
        path = path.parent_path();
      const auto space = std::filesystem::space(path, error);
      return error ? std::numeric_limits<double>::infinity() :
                     static_cast<double>(space.available);
    }

    /// Processor time on this machine of the body force at a point of the
    /// quadrature in a step [s]: none of a constant one, otherwise that of its
    /// expressions, in three residuals and a tangent.
    template <int dim>
    double
    time_of_force(const BodyForce<dim> &force, const SceneMap<dim> &map)
    {
      constexpr unsigned int  in_a_step = 4, samples = 1000;
      std::vector<Point<dim>> places;
      if (!force.is_constant())
        map.for_each([&](const auto &piece) {
          if (piece.content >= 0 && places.size() < samples)
            places.push_back(piece.centre);
        });
      if (places.empty())
        return 0.;
      // the first one compiles the expressions; all are evaluated
      volatile double    sum   = force.value(places.front(), /*t=*/0.)[0];
      const std::clock_t begin = std::clock();
      for (const Point<dim> &place : places)
        sum = sum + force.value(place, /*t=*/0.)[0];
      const double seconds =
        static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      return in_a_step * seconds / static_cast<double>(places.size());
    }

    /// Points of a body over those of its volume: a box thinner than their
    /// spacing holds a layer even so (BodyPieces::Lattice). @p per_length: of
    /// the points [1/m].
    template <int dim>
    double
    thinness(const Shape<dim> &shape, const double per_length)
    {
      double result = 1.;
      for (unsigned int d = 0; shape.is_box() && d < dim; ++d)
        result /=
          std::min(1., shape.bounding_box().side_length(d) * per_length);
      return result;
    }
  } // namespace

  template <int dim>
  ScenePlan<dim>::ScenePlan(const Scene<dim>                  &scene,
                            const std::vector<FluidBody<dim>> &bodies)
    : smallest(smallest_cell(scene.grid))
  {
    const SceneMap<dim> map(scene.grid, bodies, pieces_per_direction<dim>);
    mesh = estimate_mesh(scene.grid, map);

    const auto samples = sample_bodies(scene.grid, bodies);
    count_points(scene, bodies, samples, map);
    const TankMotion<dim> tank = scene.make_tank_motion();
    const BodyForce<dim>  force(scene.body_force, tank, scene.input);
    scales = SceneScales(scene, bodies, samples, force, smallest.edge);
    count_steps(scene, map, force);

    const CostModel cost(dim,
                         scene.formulation.degree,
                         scene.formulation.is_mixed());
    count_seconds(scene, map, force, cost);
    memory = cost.memory(mesh.cells, mesh.occupied, points);
    point_memory =
      cost.memory(0., 0., points) - cost.memory(0., 0., /*points=*/0.);
    count_files(scene, cost);
  }

  template <int dim>
  void
  ScenePlan<dim>::count_points(const Scene<dim>                    &scene,
                               const std::vector<FluidBody<dim>>   &bodies,
                               const std::vector<SampledBody<dim>> &samples,
                               const SceneMap<dim>                 &map)
  {
    double in_map = 0.;
    map.for_each([&](const auto &piece) {
      in_map += piece.content < 0 ? 0. : piece.volume;
    });
    const double per_direction = scene.seeding.per_direction;
    const double per_volume =
      Utilities::fixed_power<dim>(per_direction) *
      (in_map > 0. ? mesh.full / in_map :
                     mesh.cells / scene.grid.domain().volume());
    const double of_smallest_point =
      Utilities::fixed_power<dim>(smallest.edge / per_direction);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const SampledBody<dim> &sampled = samples[b];
        points += sampled.volume * per_volume *
                  thinness(*bodies[b].shape, std::pow(per_volume, 1. / dim));
        if (sampled.volume + sampled.resolution <
            BodyPieces<dim>::light * of_smallest_point)
          empty_bodies.push_back(bodies[b].name);
      }
  }

  template <int dim>
  void
  ScenePlan<dim>::count_steps(const Scene<dim>     &scene,
                              const SceneMap<dim>  &map,
                              const BodyForce<dim> &force)
  {
    const TimeStepParameters &time = scene.time;
    steps           = std::ceil(std::max(0., time.end_time / time.step - 1e-9));
    steps_are_least = time.is_controlled();
    if (!time.controls_courant_number())
      return;
    const double speed =
      std::max({scales.speed, scales.walls, speed_of_fall(force, map)});
    steps =
      std::max(steps,
               std::ceil(time.end_time * speed / (time.cfl * smallest.edge)));
  }

  template <int dim>
  void
  ScenePlan<dim>::count_seconds(const Scene<dim>     &scene,
                                const SceneMap<dim>  &map,
                                const BodyForce<dim> &force,
                                const CostModel      &cost)
  {
    double nu = 0.; // kinematic, at a shear rate of 1/s
    for (const Material &material : scene.materials)
      nu = std::max(nu, material.properties(1.).kinematic_viscosity());
    const double dt        = scene.time.end_time / std::max(1., steps);
    const double diffusion = nu * dt / (smallest.edge * smallest.edge);
    const double gauss =
      Utilities::fixed_power<dim>(scene.formulation.degree + 1.);
    const double quadrature =
      scene.quadrature.has_surface() ? gauss * mesh.occupied : points;
    seconds = cost.start(mesh.cells) +
              steps * (cost.step(mesh.occupied, points, diffusion) +
                       quadrature * time_of_force(force, map));
  }

  template <int dim>
  void
  ScenePlan<dim>::count_files(const Scene<dim> &scene, const CostModel &cost)
  {
    const OutputParameters &output = scene.postprocessors.output();
    if (output.interval > 0.)
      frames =
        std::min(1. + std::ceil(scene.time.end_time / output.interval - 1e-9),
                 1. + steps);
    double frame = 0.;
    if (output.grid)
      frame += cost.grid_frame(mesh.occupied);
    if (output.points)
      frame += cost.point_frame(points);
    if (output.surface)
      frame += cost.surface_frame(mesh.surface);
    if (output.series)
      frame += cost.full_points(points);
    const bool has_checkpoints = scene.checkpoint.every_steps > 0 ||
                                 (scene.checkpoint.every_wall_time > 0. &&
                                  seconds > scene.checkpoint.every_wall_time);
    constexpr double kept = 2., row = 500., // of the statistics [bytes]
      texts = 35e3;
    files   = texts + frames * frame + row * steps +
            (has_checkpoints ? kept * cost.full_points(points) : 0.);
    seconds += cost.output(files);
  }

  template <int dim>
  void
  ScenePlan<dim>::require_possible(const InputFile   &input,
                                   const unsigned int ranks) const
  {
    for (const std::string &name : empty_bodies)
      input.require(false,
                    FluidBodyParameters<dim>::path(name, "Shape"),
                    BodyPieces<dim>::message_if_empty);
    const double available = available_memory() * ranks;
    const bool   by_points = 2. * point_memory > memory;
    input.require(memory < available,
                  by_points ? "Points/Per cell and direction" :
                              "Grid/Cell size",
                  fmt::format("about {} cells, {} of them with fluid, and {} "
                              "points need {} of memory; there are {}. Choose "
                              "{}larger cells or smaller levels of "
                              "refinement.",
                              readable_count(mesh.cells),
                              readable_count(mesh.occupied),
                              readable_count(points),
                              readable_size(memory),
                              readable_size(available),
                              by_points ? "fewer points, " : ""));
  }

  template <int dim>
  std::string
  ScenePlan<dim>::size_text() const
  {
    return fmt::format("{}D, {} cells, about {} of them with fluid, about {} "
                       "points, {} {} steps",
                       dim,
                       readable_count(mesh.cells),
                       readable_count(mesh.occupied),
                       readable_count(points),
                       steps_are_least ? "at least" : "about",
                       readable_count(steps));
  }

  template <int dim>
  std::string
  ScenePlan<dim>::cost_text() const
  {
    return fmt::format("  smallest edge {:.4g} m in {}, between {:.6g} and "
                       "{:.6g} m, by {}\n"
                       "  {} {} of processor time, {} of memory, {} of files "
                       "({} frames)\n",
                       smallest.edge,
                       "xyz"[smallest.direction],
                       smallest.begin,
                       smallest.end,
                       smallest.cause,
                       steps_are_least ? "at least" : "about",
                       readable_duration(seconds),
                       readable_size(memory),
                       readable_size(files),
                       readable_count(frames));
  }

  template <int dim>
  std::vector<std::string>
  ScenePlan<dim>::doubts(const std::string &directory) const
  {
    std::vector<std::string> result = scales.doubts();
    if (seconds > a_month)
      result.push_back(fmt::format("the run would take {} of processor time: "
                                   "choose larger cells or steps, or an "
                                   "earlier end",
                                   readable_duration(seconds)));
    const double space = free_space(directory);
    if (files > space)
      result.push_back(fmt::format("the run would write {}, but only {} are "
                                   "free: make Output/Interval longer or set "
                                   "Output/Points = false",
                                   readable_size(files),
                                   readable_size(space)));
    return result;
  }

  template class ScenePlan<2>;
  template class ScenePlan<3>;
} // namespace seiche
