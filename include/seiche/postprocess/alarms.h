// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_alarms_h
#define seiche_postprocess_alarms_h

#include <seiche/postprocess/mass_and_energy.h>

#include <array>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief Whether the run can be trusted with volumes and levels: the water
   * that the weak forms see against that of the points, the points' volumes
   * against those at the start, the water that stands where there is no room
   * for it, and air that is too thin to be seen. And whether it comes to an
   * end: steps far smaller than what was asked for.
   *
   * A quantity that leaves its band raises its alarm once in a run.
   */
  template <int dim>
  class Alarms : public Postprocessor<dim>
  {
  public:
    /// What a user is told.
    struct Alarm
    {
      std::string text;       ///< what is wrong
      std::string advice;     ///< what may help
      double      value;      ///< of the step that raised it [-]
      bool        is_of_pace; ///< the run takes longer than one expects
    };

    /// @p ledger: of the same steps, executed before; it must outlive the
    /// object.
    explicit Alarms(const MassAndEnergy<dim> &ledger);

    /// Paths of the numbers that finish() always adds.
    static std::vector<std::string>
    summary_numbers();

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    /// Those that the last step has raised.
    const std::vector<Alarm> &
    raised() const
    {
      return new_alarms;
    }

    void
    save_or_load(StateArchive &archive) override;

    /// Fills summary["alarms"] with the largest value of each quantity that
    /// has left its band.
    void
    finish(const StatisticsTable  &statistics,
           nlohmann::ordered_json &summary) override;

  private:
    const MassAndEnergy<dim> &ledger;

    static constexpr unsigned int n_quantities = 5;

    double tiny_steps = 0.; // their share of the last ones [-]

    /// Account for a step.
    void
    watch_step(const StepView<dim> &view);

    std::array<double, n_quantities> largest{}; // so far, by size
    std::vector<Alarm>               new_alarms;
  };
} // namespace seiche

#endif
