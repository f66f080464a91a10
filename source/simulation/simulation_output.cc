// SPDX-License-Identifier: LGPL-2.1-or-later
// What a run says and writes.
#include <seiche/simulation/simulation.h>
#include <seiche/simulation/summary_file.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Of the energy at the start; more is no error of a scheme that is stable.
    constexpr double suspicious_gain = 0.1;

    /// Of a body's mass: less is the rounding of its shape.
    constexpr double missing_share = 1e-3;

    std::string
    in_words(const SeededBody &body)
    {
      const double missing = body.whole - body.mass;
      return fmt::format("body {}: {:.6g} kg, {} points{}",
                         body.name,
                         body.mass,
                         body.n_points,
                         missing > missing_share * body.whole ?
                           fmt::format("; {:.6g} kg of its shape lie in "
                                       "obstacles, solids or earlier bodies",
                                       missing) :
                           "");
    }
  } // namespace

  template <int dim>
  std::string
  Simulation<dim>::description() const
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    std::string        text =
      fmt::format("{}D, {} cells, {} points, {} rank{}\n",
                  dim,
                  problem.grid.triangulation.n_global_active_cells(),
                  problem.points.n_global(),
                  n_ranks,
                  n_ranks == 1 ? "" : "s");
    for (const SeededBody &body :
         problem.seeding.bodies) // none after a restart
      text += in_words(body) + "\n";
    return text;
  }

  template <int dim>
  StepView<dim>
  Simulation<dim>::step_view(const double dt) const
  {
    // points that carry the pressure have that of the end of the step
    const bool    at_end = !state.has_pressure();
    StepView<dim> view(problem.points, problem.fill, state);
    view.step = time_stepper.steps();
    view.time = time_stepper.time();
    view.dt   = dt;
    view.pressure_time =
      at_end ? view.time :
               view.time - (1. - problem.time_scheme->pressure_time()) * dt;
    view.gravity           = problem.body_force.gravity(view.time);
    view.bulk_modulus      = scene.fluid.volume_law.bulk_modulus;
    view.theta             = dt == 0. ? 0. : step_solver.coefficients().theta;
    view.pressure_theta    = at_end ? 1. : view.theta;
    view.half_spacing      = problem.seeding.half_spacing;
    view.box               = problem.grid_motion.box(view.time);
    view.newton_iterations = record.newton;
    view.krylov_iterations = record.krylov;
    view.tank =
      problem.tank_motion.any() ? &problem.tank_motion.at(view.time) : nullptr;
    view.balance       = balance;
    view.expected_step = expected_step;
    return view;
  }

  namespace
  {
    /// Of a body: its rates and what the fluid does to it.
    template <int dim>
    void
    add_freedoms(const RigidMotion<dim> &motion,
                 const double            time,
                 std::vector<double>    &values)
    {
      for (const auto &freedom : motion.body()->freedoms())
        values.insert(values.end(),
                      {motion.jet(freedom.direction.number, time).first,
                       freedom.fluid});
    }
  } // namespace

  template <int dim>
  void
  Simulation<dim>::postprocess()
  {
    const TimerTree::Scope scope(timer, "postprocess");
    const unsigned int     step   = time_stepper.steps();
    const double           time   = time_stepper.time();
    const double           dt     = step == 0 ? 0. : state.dt;
    const StepView<dim>    now    = step_view(dt);
    std::vector<double>    values = {static_cast<double>(step),
                                     time,
                                     dt,
                                     now.pressure_time,
                                     static_cast<double>(record.newton),
                                     static_cast<double>(record.krylov),
                                     static_cast<double>(
                                    problem.occupancy.cells.n_global())};
    if (scene.time.controls_error())
      values.push_back(time_stepper.error());
    if (problem.tank_motion.body() != nullptr)
      add_freedoms(problem.tank_motion.free_motion(), time, values);
    const auto &solids = problem.locator.solids;
    for (unsigned int s = 0; s < solids.size(); ++s)
      if (const Solid<dim> &solid = solids[s]; solid.motion != nullptr)
        {
          values.push_back(step == 0 ? 0. : work_of_solids[s]);
          for (unsigned int d = 0; d < BodyDirection<dim>::n_all; ++d)
            values.push_back(solid.motion->place(d, time));
          if (solid.is_free())
            {
              add_freedoms(*solid.motion, time, values);
              for (const auto &freedom : solid.motion->body()->freedoms())
                values.push_back(freedom.stop);
              for (const Mooring<dim> &mooring : solid.moorings)
                for (const double value :
                     mooring.values(solid.motion->at(time)))
                  values.push_back(value);
            }
        }
    for (const auto &change : problem.point_control.account())
      values.push_back(change.second);
    const auto names = scene.simulation_columns();
    AssertDimension(names.size(), values.size());
    for (unsigned int i = 0; i < names.size(); ++i)
      statistics.set(names[i], values[i]);
    scene.postprocessors.execute(now, statistics);
    statistics.end_row();
    for (const auto &alarm : scene.postprocessors.raised_alarms())
      report.warn(alarm.text + "; what may help: " + alarm.advice,
                  fmt::format("t = {:.6g} s, {:.3g}{}",
                              time,
                              alarm.value,
                              alarm.is_of_pace ? report.time_left() : ""));
    const double energy = scene.postprocessors.relative_energy();
    if (step > 0)
      report.progress(time, dt, record.newton, record.krylov, energy);
    if (const double gain = suspicious_energy_gain(); gain > 0.)
      report.warn("the energy has risen by more than 10 % of that at the "
                  "start: the run is unstable or far too coarse",
                  fmt::format("t = {:.6g} s, {:.3g}", time, gain));
  }

  template <int dim>
  double
  Simulation<dim>::suspicious_energy_gain() const
  {
    const bool is_isolated =
      (problem.body_force.is_constant() || problem.tank_motion.any()) &&
      !problem.walls_move();
    // a soft fluid takes its energy back from the volume
    const double gain = scene.fluid.is_incompressible() ?
                          scene.postprocessors.relative_energy_gain() :
                          scene.postprocessors.relative_energy() - 1.;
    return is_isolated && gain > suspicious_gain ? gain : 0.;
  }

  template <int dim>
  void
  Simulation<dim>::finish()
  {
    nlohmann::ordered_json summary;
    summary["dim"]    = dim;
    summary["points"] = problem.points.n_global();
    summary["cells"]  = problem.grid.triangulation.n_global_active_cells();
    summary["occupied_cells_max"] = occupied_max;
    summary["work_imbalance"]     = problem.mesh_adaptation.imbalance();
    summary["points_put_back"]    = problem.points.outflow.set_on_walls;
    summary["dofs_max"]           = unknowns_max;
    summary["end_time"]           = time_stepper.time();
    summary["steps"]              = time_stepper.steps();
    summary["rejected_steps"]     = time_stepper.rejected();
    if (is_empty)
      {
        summary["empty_since"] = time_stepper.time();
        report.warn(fmt::format("no fluid is left: all of it has gone through "
                                "open sides by t = {:.6g} s; the ledger is "
                                "that of the last row of statistics.csv",
                                time_stepper.time()));
      }
    if (scene.time.controls_error())
      summary["time_error"] = time_stepper.error();
    if (scene.time.accepts_failing_steps())
      accepted_failures.summarize(summary);
    summary["newton_iterations"] = newton_total;
    summary["krylov_iterations"] = krylov_total;
    for (const auto &[name, value] : problem.point_control.account())
      summary["point control"][name] = value;
    scene.postprocessors.finish(statistics, summary);
    if (const double gain = suspicious_energy_gain(); gain > 0.)
      summary["alarms"]["energy"] = gain;
    report.finish(summary, timer);
  }

  template std::string
  Simulation<2>::description() const;
  template std::string
  Simulation<3>::description() const;
  template StepView<2>
  Simulation<2>::step_view(const double) const;
  template StepView<3>
  Simulation<3>::step_view(const double) const;
  template void
  Simulation<2>::postprocess();
  template void
  Simulation<3>::postprocess();
  template void
  Simulation<2>::finish();
  template void
  Simulation<3>::finish();
} // namespace seiche
