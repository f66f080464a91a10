// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_probes_h
#define seiche_postprocess_probes_h

#include <seiche/postprocess/postprocessor_context.h>
#include <seiche/postprocess/sensor_signal.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of "Probe NAME".
  template <int dim>
  struct ProbeParameters
  {
    static constexpr const char *kind = "Probe";

    std::string        name;
    dealii::Point<dim> position;              ///< [m]
    std::string        quantity = "pressure"; ///< or velocity
    double             diameter = 0.;         ///< [m], 0: a point
    SensorParameters   sensor;

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const GridParameters<dim> &grid) const;
    bool
    reads_pressure() const
    {
      return quantity == "pressure";
    }
    /// Those of the readings and, with a filter, those of the filtered ones.
    std::vector<std::string>
    columns() const;
    std::vector<std::string>
    reading_columns() const;
    /// What the sensor gives out: filtered, if it has a filter.
    std::vector<std::string>
    signal_columns() const;

    /// Places whose mean is the reading [m]: one, or those of a sensor that
    /// lies in the plane of the wall nearest to it (2D: a line, 3D: a disc).
    std::vector<dealii::Point<dim>>
    places(const GridParameters<dim> &grid) const;
  };

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
