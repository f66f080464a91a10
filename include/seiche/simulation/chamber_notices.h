// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_chamber_notices_h
#define seiche_simulation_chamber_notices_h

#include <seiche/grid/closed_chambers.h>
#include <seiche/simulation/run_report.h>
#include <seiche/simulation/scene.h>

namespace seiche
{
  /**
   * @brief What a user is told of chambers that fluid fills, from the start or
   * in the course of the run: what the pressure is worth there. Once for each.
   */
  template <int dim>
  class ChamberNotices
  {
  public:
    /// References must outlive the object.
    ChamberNotices(const Scene<dim> &scene, RunReport &report);

    /// Speak of those that are full at @p time [s]. Local.
    void
    update(const ClosedChambers<dim> &closed, const double time);

    /// Local.
    void
    save_or_load(StateArchive &archive);

  private:
    /// Of a chamber of incompressible fluid; @p it: which.
    void
    tell_of_level(const std::string &it, const double time);

    const Scene<dim> &scene;
    RunReport        &report;
    std::vector<char> told; ///< by chamber
  };
} // namespace seiche

#endif
