// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/chamber_notices.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Cells that sound may cross in a step where each point keeps its own
    /// volume: without a free surface pressures that the cells do not see grow
    /// from the round-off of Newton's iteration (doc/limits.md).
    constexpr double stiffest = 100.;

    /// "0; 0.5".
    template <int dim>
    std::string
    in_words(const Point<dim> &x)
    {
      std::string text = fmt::format("{:.6g}", x[0]);
      for (unsigned int d = 1; d < dim; ++d)
        text += fmt::format("; {:.6g}", x[d]);
      return text;
    }
  } // namespace

  template <int dim>
  ChamberNotices<dim>::ChamberNotices(const Scene<dim>  &run_scene,
                                      const SceneScales &scales,
                                      RunReport         &run_report)
    : scene(run_scene)
    , report(run_report)
    , sound(scales.cells_of_sound())
  {}

  template <int dim>
  void
  ChamberNotices<dim>::update(const ClosedChambers<dim> &closed,
                              const double               time)
  {
    if (!closed.any())
      return;
    known.resize(closed.chambers.size(), 0);
    for (unsigned int chamber = 0; chamber < known.size(); ++chamber)
      {
        if (known[chamber] || !closed.is_closed(chamber))
          continue;
        known[chamber]     = 1;
        const auto corners = closed.chambers.box(chamber).get_boundary_points();
        const std::string it   = fmt::format("the chamber between {} and {} m",
                                           in_words(corners.first),
                                           in_words(corners.second));
        const std::string when = fmt::format("t = {:.6g} s", time);
        if (scene.fluid.is_incompressible())
          report.note(it +
                        " is closed and full of incompressible fluid: "
                        "pressures in it, and what probes and forces make of "
                        "them, are relative to their mean" +
                        (scene.grid.any_unilateral() ?
                           "; unilateral walls hold the fluid there" :
                           ""),
                      time > 0. ? when : "");
        else if (!scene.uses_mean_volume() && sound > stiffest)
          report.warn(
            it + fmt::format(" is closed and full, and sound crosses {:.3g} "
                             "cells in a step: above {:.0f} pressures may "
                             "drift there; what may help: Volume/Update = "
                             "nodal mean",
                             sound,
                             stiffest),
            when);
      }
  }

  template class ChamberNotices<2>;
  template class ChamberNotices<3>;
} // namespace seiche
