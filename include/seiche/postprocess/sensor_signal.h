// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_sensor_signal_h
#define seiche_postprocess_sensor_signal_h

#include <cstdint>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;
  class StateArchive;

  /// prm entries of a sensor's amplifier and recorder, part of "Probe NAME".
  struct SensorParameters
  {
    double rate    = 0.; ///< [Hz] of samples; 0: no record of its own
    double cut_off = 0.; ///< [Hz] of the low-pass filter; 0: none

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @p section: that of the probe, for messages.
    void
    check(const InputFile &input, const std::string &section) const;
  };

  /**
   * @brief A signal as a laboratory records it: low-pass filter, then samples.
   *
   * Between two readings, the steps of the run, the signal x is a straight
   * line. The filter is one of first order, dy/dt = 2 pi f_c (x - y), with gain
   * 1/sqrt(1 + (f/f_c)^2); it starts in equilibrium with the first reading and
   * is solved exactly for that line, so that neither its result nor its
   * stability depends on the steps. Samples are taken of y at whole multiples
   * of 1/rate. Local.
   */
  class SensorSignal
  {
  public:
    struct Sample
    {
      double time; ///< [s]
      double value;
    };

    explicit SensorSignal(const SensorParameters &parameters);

    /// The next reading, later than the last one; one that is not finite does
    /// not count. Returns the samples since the last one.
    std::vector<Sample>
    advance(const double time, const double reading);

    /// The filtered signal at the last reading; NaN before the first.
    double
    value() const
    {
      return filtered;
    }

    void
    save_or_load(StateArchive &archive, const std::string &name);

  private:
    /// Go on to @p time, at most @p end, on the line from the last reading to
    /// that at @p end.
    void
    go_on(const double time, const double end, const double reading);

    const SensorParameters parameters;
    double                 last_time; // of the line's begin
    double                 last_reading;
    double                 filtered;
    std::int64_t           n_next = 0; // number of the next sample
  };
} // namespace seiche

#endif
