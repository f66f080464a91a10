// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/step_advice.h>

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace seiche
{
  namespace
  {
    /// Whether an entry may help, and that entry.
    using Advice = std::vector<std::pair<bool, std::string>>;

    /// What makes the equations of a step unstable at every size.
    template <int dim>
    Advice
    equations(const Scene<dim> &scene)
    {
      const StabilizationParameters &vms      = scene.formulation.stabilization;
      const bool                     is_mixed = scene.formulation.is_mixed();
      const bool   is_soft       = is_mixed && !scene.fluid.is_incompressible();
      const bool   has_subscales = is_mixed && vms.is_active();
      const double least_floor   = 1.; // cells a step
      const double larger_modulus       = 10.;
      const double least_inertia_factor = 0.25; // doc/methods.md, in splashes
      return {
        {scene.transfer.is_consistent(/*degree=*/1),
         "Transfer/Mass = automatic"},
        {is_mixed && !has_subscales, "Formulation/Stabilization = ASGS"},
        {has_subscales && vms.is_quasi_static() && vms.has_inertia() &&
           vms.speed_floor < least_floor,
         "Formulation/Tau = transient"},
        {has_subscales && !vms.is_quasi_static() &&
           vms.inertia_factor < least_inertia_factor,
         "Formulation/Tau inertia factor = 1"},
        {has_subscales && !vms.has_inertia() &&
           !scene.formulation.lumps_inertia(),
         "Formulation/Subscale residual = whole"},
        {has_subscales && vms.is_orthogonal(),
         "Formulation/Stabilization = ASGS"},
        {is_soft && !scene.quadrature.has_surface(),
         "Quadrature/Rule = cut cells"},
        {is_soft && scene.time_scheme.is_elastic_at_end() &&
           !scene.formulation.lumps_inertia(),
         "Fluid/Bulk modulus = infinite"},
        {!is_mixed,
         fmt::format("Fluid/Bulk modulus = {:.3g}",
                     larger_modulus * scene.fluid.volume_law.bulk_modulus)},
        {scene.time.accepts_failing_steps(), "Time/Failing steps = repeated"}};
    }

    /// What a coarse or thin resolution of the fluid needs.
    template <int dim>
    Advice
    resolution(const Scene<dim> &scene)
    {
      const FreeSurfaceParameters   &surface  = scene.free_surface;
      const StabilizationParameters &vms      = scene.formulation.stabilization;
      const bool                     is_mixed = scene.formulation.is_mixed();
      const bool         has_subscales        = is_mixed && vms.is_active();
      const unsigned int enough_points        = dim == 2 ? 4 : 2; // a direction
      const double       enough_tau2          = 0.5;
      return {
        {surface.point_inertia < 1., "Free surface/Point inertia = 1"},
        {surface.acceleration < 0.1, "Free surface/Ghost acceleration = 0.1"},
        {is_mixed && surface.pressure < 0.1,
         "Free surface/Ghost pressure = 0.1"},
        {surface.velocity < 0.1, "Free surface/Ghost velocity = 0.1"},
        {surface.velocity_time > 0.05,
         "Free surface/Ghost velocity time = 0.05"},
        {!scene.time.is_controlled(), "Time/Step control = CFL"},
        {scene.seeding.per_direction < enough_points,
         fmt::format("Points/Per cell and direction = {}", enough_points)},
        {has_subscales && vms.continuity_factor < enough_tau2,
         fmt::format("Formulation/Tau continuity factor = {}", enough_tau2)},
        {scene.formulation.degree > 1, "Formulation/Element degree = 1"},
        {scene.time.minimum_step > 0., "Time/Minimum step = 0"},
        {scene.newton.tolerance < NewtonParameters().tolerance,
         fmt::format("Solver/Newton tolerance = {}",
                     NewtonParameters().tolerance)},
        {true, fmt::format("Time/Step = {:.3g}", 0.5 * scene.time.step)}};
    }
  } // namespace

  template <int dim>
  std::string
  step_advice(const Scene<dim> &scene, const SceneScales &scales)
  {
    if (scales.step_is_round_off())
      return fmt::format("Points hardly move in such a step, so that only "
                         "round-off is left. What may help in this scene: "
                         "{}.",
                         scales.entry_for_motion());
    std::string result;
    for (const Advice &advice : {equations(scene), resolution(scene)})
      for (const auto &[helps, entry] : advice)
        if (helps)
          result += (result.empty() ? "" : ", ") + entry;
    return "What may help in this scene: " + result + ".";
  }

  template std::string
  step_advice(const Scene<2> &, const SceneScales &);
  template std::string
  step_advice(const Scene<3> &, const SceneScales &);
} // namespace seiche
