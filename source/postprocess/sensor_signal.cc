// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/sensor_signal.h>
#include <seiche/postprocess/statistics_table.h>
#include <seiche/utilities/state_archive.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    // of the interval between samples: a step ends where it should up to this
    constexpr double slack = 1e-9;
  } // namespace

  void
  SensorParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Sampling rate",
                      rate,
                      "Samples a second in a file probe_NAME.csv, taken "
                      "between the steps on straight lines; 0: no such file. "
                      "[Hz]",
                      Patterns::Double(0.));
    prm.add_parameter("Cut-off frequency",
                      cut_off,
                      "Of a low-pass filter of first order (-3 dB there) for "
                      "the samples and for a column \"filtered\" beside the "
                      "unfiltered one; 0: no filter. [Hz]",
                      Patterns::Double(0.));
  }

  void
  SensorParameters::check(const InputFile   &input,
                          const std::string &section) const
  {
    const double largest = 1e6; // more would be a file without end
    input.require(rate <= largest,
                  section + "/Sampling rate",
                  "at most 1e6 Hz; laboratories sample impacts at 1e3 to 1e5.");
    input.require(rate == 0. || cut_off <= 0.5 * rate,
                  section + "/Cut-off frequency",
                  "samples cannot show what is faster than half of the "
                  "sampling rate; choose a lower cut-off or a higher "
                  "\"Sampling rate\".");
  }

  SensorSignal::SensorSignal(const SensorParameters &sensor)
    : parameters(sensor)
    , last_time(StatisticsTable::missing)
    , last_reading(StatisticsTable::missing)
    , filtered(StatisticsTable::missing)
  {}

  std::vector<SensorSignal::Sample>
  SensorSignal::advance(const double time, const double reading)
  {
    std::vector<Sample> samples;
    if (!std::isfinite(reading))
      return samples;
    if (!std::isfinite(last_time))
      {
        last_time    = time;
        last_reading = filtered = reading;
        n_next =
          static_cast<std::int64_t>(std::ceil(time * parameters.rate - slack));
      }
    while (parameters.rate > 0. && n_next <= time * parameters.rate + slack)
      {
        const double at = n_next++ / parameters.rate;
        go_on(at, time, reading);
        samples.push_back({at, filtered});
      }
    go_on(time, time, reading);
    return samples;
  }

  void
  SensorSignal::go_on(const double time, const double end, const double reading)
  {
    const double step = time - last_time, left = end - last_time;
    if (step <= 0.)
      return;
    const double slope = (reading - last_reading) / left;
    const double next  = time >= end ? reading : last_reading + slope * step;
    if (parameters.cut_off > 0.)
      {
        const double speed = 2. * numbers::PI * parameters.cut_off;
        filtered += (last_reading - filtered - slope / speed) *
                      -std::expm1(-speed * step) +
                    slope * step;
      }
    else
      filtered = next;
    last_time    = time;
    last_reading = next;
  }

  void
  SensorSignal::save_or_load(StateArchive &archive, const std::string &name)
  {
    archive(name + " time", last_time);
    archive(name + " reading", last_reading);
    archive(name + " filtered", filtered);
    archive(name + " next sample", n_next);
  }
} // namespace seiche
