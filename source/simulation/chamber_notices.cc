// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/chamber_notices.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
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
  ChamberNotices<dim>::ChamberNotices(const Scene<dim> &run_scene,
                                      RunReport        &run_report)
    : scene(run_scene)
    , report(run_report)
  {}

  template <int dim>
  void
  ChamberNotices<dim>::update(const ClosedChambers<dim> &closed,
                              const double               time)
  {
    if (!closed.any())
      return;
    told.resize(closed.chambers.size(), 0);
    for (unsigned int chamber = 0; chamber < told.size(); ++chamber)
      if (!told[chamber] && closed.is_closed(chamber))
        {
          told[chamber] = 1;
          const auto corners =
            closed.chambers.box(chamber).get_boundary_points();
          const std::string it =
            fmt::format("the chamber between {} and {} m is closed and full",
                        in_words(corners.first),
                        in_words(corners.second));
          if (scene.fluid.is_incompressible())
            tell_of_level(it, time);
          else if (time > 0.)
            report.warn(
              it + " now: the air that it still holds, up to half a cell under "
                   "its lid, counts as compression, and pressures may be wrong "
                   "by factors; what may help: smaller cells, or room above "
                   "the fluid",
              fmt::format("t = {:.6g} s", time));
        }
  }

  template <int dim>
  void
  ChamberNotices<dim>::tell_of_level(const std::string &it, const double time)
  {
    report.note(it +
                  " of incompressible fluid: pressures in it, and what probes "
                  "and forces make of them, are relative to their mean" +
                  (scene.grid.any_unilateral() ?
                     "; unilateral walls hold the fluid there" :
                     ""),
                time > 0. ? fmt::format("t = {:.6g} s", time) : "");
  }

  template <int dim>
  void
  ChamberNotices<dim>::save_or_load(StateArchive &archive)
  {
    archive("told of full chambers", told);
  }

  template class ChamberNotices<2>;
  template class ChamberNotices<3>;
} // namespace seiche
