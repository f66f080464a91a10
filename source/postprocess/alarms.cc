// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/alarms.h>
#include <seiche/utilities/over_ranks.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// A quantity that has to stay in a band around zero.
    struct Quantity
    {
      const char *name;
      double      limit; // [-]
      const char *text, *advice;
      bool        is_of_pace = false;
    };

    /// Of the expected step. That of a step whose size follows its error is
    /// larger, and so is one that halves for want of convergence now and then.
    constexpr double tiny = 2e-3; // the default least step is Step/1024

    /// Steps over which their share is taken, roughly.
    constexpr double memory = 100.;

    // in the order of the values in Alarms::execute()
    constexpr Quantity quantities[] = {
      {"seen volume",
       0.01,
       "the water between surface and walls is not that of the points by more "
       "than 1 %: levels may be wrong by as much of the depth",
       "smaller cells, more Points/Per cell and direction or a larger "
       "Points/Density rate"},
      {"volume",
       0.01,
       "the volume of the points, which pressure alone may change, is wrong by "
       "more than 1 %",
       "a larger Formulation/Tau continuity factor (0.5) or a smaller "
       "Time/Step"},
      {"overfull",
       0.02,
       "more than 2 % of the water is where cells are full already",
       "Quadrature/Rule = cut cells, a larger Points/Density rate, a smaller "
       "Time/Step, or more Points/Per cell and direction"},
      {"unseen air",
       0.001,
       "a closed chamber counts as full of fluid although it holds air: less "
       "than half a cell under the lid, whose pressure is then not zero",
       "smaller cells, or a level at least half a cell below the lid"},
      {"tiny steps",
       0.5,
       "most steps are 500 times smaller than Time/Step and than what "
       "the fluid needs to cross a cell",
       "what the warnings above advise, or a look at the fastest points; a "
       "larger Time/Minimum step ends such a run",
       /*is_of_pace=*/true}};

    /// 1 at nodes whose walls fluid is leaving.
    template <int dim>
    typename Occupancy<dim>::Vector
    find_leaving(const Occupancy<dim> &occupancy)
    {
      typename Occupancy<dim>::Vector result(occupancy.nodes.partitioner());
      for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
        result.local_element(node) = occupancy.constraints.leaves_wall(node);
      result.update_ghost_values();
      return result;
    }

    /// Share of a cell that is a gap between a wall and the fluid that leaves
    /// it: what the inside has more than the points at the cell's vertices.
    template <int dim>
    double
    gap(const StepView<dim>                   &view,
        const unsigned int                     cell,
        const typename Occupancy<dim>::Vector &leaving)
    {
      VertexValues<dim> leaves, points, inside;
      const auto       &occupancy = view.occupancy;
      occupancy.vertex_values(cell, leaving, leaves.data());
      if (std::all_of(leaves.begin(), leaves.end(), [](const double value) {
            return value == 0.;
          }))
        return 0.;
      occupancy.vertex_values(cell, view.fill.nodal_fill(), points.data());
      occupancy.vertex_values(cell,
                              view.fill.surface().nodal_fill(),
                              inside.data());
      double result = 0.;
      for (unsigned int v = 0; v < leaves.size(); ++v)
        result += std::max(0., inside[v] - points[v]) / leaves.size();
      return result;
    }

    double
    ratio(std::array<double, 2> parts, const MPI_Comm communicator)
    {
      sum_over_ranks(parts, communicator);
      const auto [part, whole] = parts;
      return whole > 0. ? part / whole : 0.;
    }

    /// Water that the weak forms see less that of the points [m^dim]. Gaps at
    /// walls that fluid is leaving are no error: the level set shows them only
    /// from a third of a cell on, but the walls hold nothing there.
    template <int dim>
    double
    excess_seen(const StepView<dim> &view)
    {
      if (!view.fill.has_surface())
        return 0.;
      const bool has_gaps =
        view.occupancy.locator.grid.parameters.any_unilateral();
      typename Occupancy<dim>::Vector leaving;
      if (has_gaps)
        leaving = find_leaving(view.occupancy);
      std::array<double, 2> parts{}; // excess, gaps
      for (const unsigned int cell : view.occupancy.cells.occupied())
        {
          const double measure =
            view.occupancy.locator.cells.geometry(cell).measure;
          parts[0] += (view.fill.inside_share(cell) +
                       view.fill.loose_volume(cell, view.points) -
                       view.fill.cell_fill(cell)) *
                      measure;
          if (has_gaps)
            parts[1] += gap(view, cell, leaving) * measure;
        }
      sum_over_ranks(parts, view.points.communicator);
      const auto [excess, gaps] = parts;
      return excess - std::min(gaps, std::max(0., excess));
    }

    /// What points leave free in closed chambers, over their volume.
    template <int dim>
    double
    air_in_closed_chambers(const StepView<dim> &view)
    {
      const auto &locator = view.occupancy.locator;
      const auto &solids  = view.occupancy.mesh_nodes.cut_walls;
      if (!view.fill.closed_chambers().any())
        return 0.;
      std::array<double, 2> air_and_volume{};
      for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
        if (view.fill.closed_chambers().holds_cell(cell))
          {
            const double volume = locator.cells.geometry(cell).measure;
            air_and_volume[0] +=
              (solids.wet_share(cell) - view.fill.cell_fill(cell)) * volume;
            air_and_volume[1] += solids.wet_share(cell) * volume;
          }
      return ratio(air_and_volume, view.points.communicator);
    }

    /// Relative change of the volume of the points outside closed chambers: in
    /// these points in corners change theirs without end, and without harm.
    template <int dim>
    double
    volume_change_outside(const StepView<dim> &view)
    {
      const double *initial = view.points.data(PointColumn::initial_volume);
      const double *J       = view.points.data(PointColumn::volume_ratio);
      std::array<double, 2> change_and_volume{};
      for (const unsigned int cell : view.occupancy.cells.occupied())
        if (!view.fill.closed_chambers().holds_cell(cell))
          for (const std::size_t p : view.points.points_in(cell))
            {
              change_and_volume[0] += (J[p] - 1.) * initial[p];
              change_and_volume[1] += initial[p];
            }
      return ratio(change_and_volume, view.points.communicator);
    }
    /// What volumes of fluid of finite bulk modulus are off from those of its
    /// pressure, over all volume; mean of the sizes by cell. The square is what
    /// laws of the volume differ by.
    template <int dim>
    double
    volume_beside_pressure(const StepView<dim> &view)
    {
      const double *initial = view.points.data(PointColumn::initial_volume);
      const double *J       = view.points.data(PointColumn::volume_ratio);
      const double *p       = view.points.data(PointColumn::pressure);
      std::array<double, 2> excess_and_volume{};
      for (const unsigned int cell : view.occupancy.cells.occupied())
        {
          double volume = 0., change = 0., pressure = 0.;
          for (const std::size_t q : view.points.points_in(cell))
            {
              volume += initial[q];
              change += (J[q] - 1.) * initial[q];
              pressure += p[q] * initial[q];
            }
          if (volume == 0.)
            continue;
          const double strain = pressure / volume / view.bulk_modulus;
          excess_and_volume[0] += std::max(0.,
                                           std::abs(change + strain * volume) -
                                             strain * strain * volume);
          excess_and_volume[1] += volume;
        }
      return ratio(excess_and_volume, view.points.communicator);
    }
  } // namespace

  template <int dim>
  Alarms<dim>::Alarms(const MassAndEnergy<dim> &run_ledger)
    : ledger(run_ledger)
  {}

  template <int dim>
  std::vector<std::string>
  Alarms<dim>::summary_numbers()
  {
    std::vector<std::string> names;
    for (const Quantity &quantity : quantities)
      names.push_back(std::string("largest/") + quantity.name);
    return names;
  }

  template <int dim>
  void
  Alarms<dim>::execute(const StepView<dim> &view,
                       StatisticsTable & /*statistics*/)
  {
    static_assert(std::size(quantities) == n_quantities);
    watch_step(view);
    const bool is_incompressible =
      view.bulk_modulus == std::numeric_limits<double>::infinity();
    const std::array<double, n_quantities> values = {
      {excess_seen(view) / ledger.first_volume(),
       !is_incompressible                ? volume_beside_pressure(view) :
       view.fill.closed_chambers().any() ? volume_change_outside(view) :
                                           ledger.volume_change(),
       view.fill.overfull_fraction(),
       air_in_closed_chambers(view),
       tiny_steps}};
    new_alarms.clear();
    for (unsigned int i = 0; i < n_quantities; ++i)
      {
        const Quantity &quantity = quantities[i];
        if (std::abs(values[i]) > quantity.limit &&
            std::abs(largest[i]) <= quantity.limit)
          new_alarms.push_back(
            {quantity.text, quantity.advice, values[i], quantity.is_of_pace});
        if (std::abs(values[i]) > std::abs(largest[i]))
          largest[i] = values[i];
      }
  }

  template <int dim>
  void
  Alarms<dim>::watch_step(const StepView<dim> &view)
  {
    if (view.step > 0)
      tiny_steps +=
        ((view.dt < tiny * view.expected_step ? 1. : 0.) - tiny_steps) / memory;
  }

  template <int dim>
  void
  Alarms<dim>::finish(const StatisticsTable & /*statistics*/,
                      nlohmann::ordered_json &summary)
  {
    for (unsigned int i = 0; i < n_quantities; ++i)
      {
        summary["largest"][quantities[i].name] = largest[i];
        if (std::abs(largest[i]) > quantities[i].limit)
          summary["alarms"][quantities[i].name] = largest[i];
      }
  }

  template <int dim>
  void
  Alarms<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("alarms", [&]() {
      archive("largest", largest);
      archive("tiny steps", tiny_steps);
    });
  }

  template class Alarms<2>;
  template class Alarms<3>;
} // namespace seiche
