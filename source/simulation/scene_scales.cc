// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/largest_wall_speed.h>
#include <seiche/scene/sample_times.h>
#include <seiche/scene/smallest_cell.h>
#include <seiche/simulation/scene_scales.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double round_off_of_force = 1e-9; // [m/s^2]

    /// At which viscosities that depend on it are compared [1/s].
    constexpr double usual_shear = 1.;

    /// True if a place is surely more than @p slack [m] outside of a body.
    template <int dim>
    bool
    is_far(const Shape<dim> &shape, const Point<dim> &place, const double slack)
    {
      BoundingBox<dim> box = shape.bounding_box();
      box.extend(slack);
      return shape.level(place) > 0. && !box.point_inside(place);
    }

    /// True if there are walls at both sides of the domain in a direction.
    template <int dim>
    bool
    has_walls(const GridParameters<dim> &grid, const unsigned int direction)
    {
      const auto is_wall = [&](const bool upper) {
        return grid.walls[BoxFace(direction, upper)].is_closed();
      };
      return is_wall(false) && is_wall(true);
    }
  } // namespace

  template <int dim>
  SceneScales::SceneScales(const Scene<dim>                    &scene,
                           const std::vector<FluidBody<dim>>   &bodies,
                           const std::vector<SampledBody<dim>> &samples,
                           const BodyForce<dim>                &body_force,
                           const double                         finest_edge)
    : walls(
        largest_wall_speed(scene.grid, body_force.tank, scene.time.end_time))
    , modulus(scene.fluid.volume_law.bulk_modulus)
    , is_mixed(scene.formulation.is_mixed())
    , step(scene.time.step)
    , is_fixed(!scene.time.is_controlled())
    , end_time(scene.time.end_time)
    , smallest_cell(finest_edge)
    , smallest_height(smallest_edge(scene.grid, dim - 1).edge)
  {
    for (const Material &material : scene.materials)
      {
        const FluidProperties at_usual_shear =
          material.properties(usual_shear * usual_shear);
        fluid.density   = std::max(fluid.density, at_usual_shear.density);
        fluid.viscosity = std::max(fluid.viscosity, at_usual_shear.viscosity);
      }
    measure_fluid(scene, bodies, samples, body_force);
    for (const auto &track : scene.postprocessors.tracked_places())
      if (!scene.grid.any_periodic() && // or near across a seam
          std::all_of(bodies.begin(), bodies.end(), [&](const auto &body) {
            return is_far(*body.shape, track.place, finest_edge);
          }))
        lost_tracks.push_back(track.name);
    if (body_force.tank.any())
      for (const double t : sample_times(end_time))
        for (const double angle : body_force.tank.at(t).angles)
          turn = std::max(turn, std::abs(angle));
  }

  template <int dim>
  void
  SceneScales::measure_fluid(const Scene<dim>                    &scene,
                             const std::vector<FluidBody<dim>>   &bodies,
                             const std::vector<SampledBody<dim>> &samples,
                             const BodyForce<dim>                &body_force)
  {
    double         bottom = std::numeric_limits<double>::max();
    double         top    = std::numeric_limits<double>::lowest();
    double         square = 0., n = 0.;
    Tensor<1, dim> sum;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const SampledBody<dim> &body = samples[b];
        if (body.places.empty())
          continue;
        mass +=
          scene.materials[bodies[b].material].properties().mass(body.volume);
        mass_is_exact  = mass_is_exact && body.is_whole;
        depth_is_exact = depth_is_exact && body.ends_at_box;
        note_thickness(bodies[b]);
        bottom       = std::min(bottom, body.bottom);
        top          = std::max(top, body.top);
        tallest_body = std::max(tallest_body, body.top - body.bottom);
        for (const Point<dim> &x : body.places)
          {
            Tensor<1, dim> force = body_force.value(x, /*t=*/0.);
            if (force.norm() < round_off_of_force)
              force.clear(); // a tank that falls
            square += body.resolution * force.norm_square();
            sum += body.resolution * force;
            n += body.resolution;
            const Tensor<1, dim> v =
              bodies[b].velocity->vector_value(x, /*t=*/0.);
            speed = std::max(speed, v.norm());
          }
      }
    if (n > 0.)
      {
        depth   = top - bottom;
        gravity = std::sqrt(square / n);
        upwards = sum[dim - 1] / n;
        for (unsigned int d = 0; dim == 3 && d < 2; ++d)
          if (has_walls(scene.grid, d))
            sideways = std::max(sideways, std::abs(sum[d]) / n);
      }
  }

  template <int dim>
  void
  SceneScales::note_thickness(const FluidBody<dim> &body)
  {
    const Thickness<dim> least = body.shape->least_thickness();
    if (least.length >= thinnest)
      return;
    thinnest = least.length;
    std::ostringstream place;
    place << body.name << " near " << least.place;
    thinnest_place = place.str();
  }

  double
  SceneScales::wave_speed() const
  {
    return std::sqrt(gravity * depth);
  }

  double
  SceneScales::pressure_under(const double height) const
  {
    return fluid.density * gravity * height;
  }

  double
  SceneScales::fastest() const
  {
    return std::max({wave_speed(), speed, walls});
  }

  double
  SceneScales::expected_step() const
  {
    return std::min(step, smallest_cell / fastest());
  }

  double
  SceneScales::creep_speed() const
  {
    return fluid.is_viscous() ?
             gravity * depth * depth / fluid.kinematic_viscosity() :
             std::numeric_limits<double>::infinity();
  }

  double
  SceneScales::cells_in(const double time) const
  {
    return std::max({speed, walls, std::min(gravity * time, creep_speed())}) *
           time / smallest_cell;
  }

  std::string
  SceneScales::text() const
  {
    const int   digits = depth_is_exact ? 3 : 2;
    std::string result =
      fmt::format("{}{:.4g} kg of fluid, depth {}{:.{}g} m ({:.2g} cells), ",
                  mass_is_exact ? "" : "about ",
                  mass,
                  depth_is_exact ? "" : "about ",
                  depth,
                  digits,
                  depth / smallest_height);
    if (std::isfinite(thinnest))
      result += fmt::format("thinnest part {:.3g} m ({:.2g} cells), ",
                            thinnest,
                            thinnest / smallest_cell);
    if (gravity > 0.)
      result += fmt::format("sqrt(g H) {:.{}g} m/s, rho g H {:.{}g} Pa",
                            wave_speed(),
                            digits,
                            pressure_under(depth),
                            digits);
    else
      result += "no body force at the start";
    if (speed > 0.)
      result += fmt::format("; fastest {:.3g} m/s", speed);
    if (speed > 0. && gravity > 0.)
      result += fmt::format(", Froude number {:.2g}", speed / wave_speed());
    if (walls > 0.)
      result += fmt::format("; walls move with up to {:.3g} m/s", walls);
    if (fluid.is_viscous() && fastest() > 0.)
      result += fmt::format("; Reynolds number {:.2g}",
                            fastest() * depth / fluid.kinematic_viscosity());
    if (fastest() > 0.)
      result += fmt::format("; in {} {:.3g} s {:.2g} cells",
                            is_fixed ? "steps of" : "the largest step,",
                            step,
                            fastest() * step / smallest_cell);
    return result;
  }

  template SceneScales::SceneScales(const Scene<2> &,
                                    const std::vector<FluidBody<2>> &,
                                    const std::vector<SampledBody<2>> &,
                                    const BodyForce<2> &,
                                    const double);
  template SceneScales::SceneScales(const Scene<3> &,
                                    const std::vector<FluidBody<3>> &,
                                    const std::vector<SampledBody<3>> &,
                                    const BodyForce<3> &,
                                    const double);
} // namespace seiche
