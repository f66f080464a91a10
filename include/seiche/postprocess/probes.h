// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_probes_h
#define seiche_postprocess_probes_h

#include <seiche/postprocess/postprocessor_context.h>
#include <seiche/postprocess/probe_parameters.h>

#include <deque>
#include <memory>
#include <vector>

namespace seiche
{
  /**
   * @brief Pressure and velocity at fixed places, also as sensors in walls.
   *
   * The pressure is that of `pressure_time`, in the configuration of the
   * forces; the velocity that of the end of the step. Where there is no
   * fluid the reading is zero. Columns go into the statistics and, with both
   * times, into a file `probes.csv` of their own; the samples of a probe with a
   * sampling rate into `probe_NAME.csv`.
   */
  template <int dim>
  class Probes : public Postprocessor<dim>
  {
  public:
    using Parameters = ProbeParameters<dim>;

    Probes(const std::vector<Parameters>   &parameters,
           const PostprocessorContext<dim> &context);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

  private:
    /// Means over the places of each probe in turn: pressure, or components
    /// of the velocity; NaN where there is none yet. Collective.
    std::vector<double>
    readings(const StepView<dim> &view) const;

    /// Filter and sample the readings of a probe.
    void
    record(const unsigned int         probe,
           const double               time,
           const std::vector<double> &values,
           StatisticsTable           &statistics);

    const std::vector<ProbeParameters<dim>>      probes;
    const std::shared_ptr<NodalPressure<dim>>    pressure;
    std::vector<std::vector<dealii::Point<dim>>> places; // of each probe
    StatisticsTable                              table;
    std::vector<std::vector<SensorSignal>>       signals; // of each column
    std::deque<StatisticsTable>                  samples; // of each probe
  };
} // namespace seiche

#endif
