// SPDX-License-Identifier: LGPL-2.1-or-later
// Filter and samples of a sensor: gain at the cut-off, a step's response,
// samples between readings, independence of the steps, saved and loaded.
#include <seiche/postprocess/sensor_signal.h>
#include <seiche/utilities/state_archive.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <iostream>
#include <limits>

using seiche::SensorSignal;

namespace
{
  seiche::SensorParameters
  parameters(const double rate, const double cut_off)
  {
    seiche::SensorParameters result;
    result.rate    = rate;
    result.cut_off = cut_off;
    return result;
  }

  /// Amplitude of the filtered sine of @p frequency [Hz] after the start.
  double
  gain(const double frequency, const double cut_off)
  {
    SensorSignal signal(parameters(0., cut_off));
    double       largest = 0.;
    for (unsigned int i = 0; i <= 30000; ++i)
      {
        const double t = i * 1e-3 / frequency;
        signal.advance(t, std::sin(2. * dealii::numbers::PI * frequency * t));
        if (i > 29000) // the last of 30 periods
          largest = std::max(largest, std::abs(signal.value()));
      }
    return largest;
  }
} // namespace

int
main()
{
  const double cut_off = 10.;
  std::cout << "gain at the cut-off, over 1/sqrt(2): "
            << gain(cut_off, cut_off) * std::sqrt(2.) << std::endl
            << "gain at 10 times the cut-off, times sqrt(101): "
            << gain(10. * cut_off, cut_off) * std::sqrt(101.) << std::endl;

  // from 0 to 1 within 1e-9 s: 1 - 1/e after the time 1/(2 pi f_c)
  const double tau = 1. / (2. * dealii::numbers::PI * cut_off);
  for (const unsigned int n : {1, 7})
    {
      SensorSignal signal(parameters(0., cut_off));
      signal.advance(0., 0.);
      signal.advance(1e-9, 1.);
      for (unsigned int i = 1; i <= n; ++i)
        signal.advance(1e-9 + tau * i / n, 1.);
      std::cout << "a step after one time constant, in " << n
                << " steps, over 1 - 1/e: "
                << signal.value() / (1. - std::exp(-1.)) << std::endl;
    }

  // readings on a line at uneven times: samples of the line, each once; the
  // first reading is missing
  SensorSignal line(parameters(10., 0.));
  line.advance(0., std::numeric_limits<double>::quiet_NaN());
  for (const double t : {0.05, 0.1, 0.12, 0.42, 0.5})
    {
      const auto samples = line.advance(t, 2. + t);
      std::cout << "samples up to " << t << ":";
      for (const auto &sample : samples)
        std::cout << " (" << sample.time << ", " << sample.value << ")";
      std::cout << std::endl;
    }

  // a filtered line lags by the time constant
  SensorSignal ramp(parameters(4., cut_off));
  ramp.advance(0., 0.);
  const auto late = ramp.advance(1., 1.);
  std::cout << "lag of a line at " << late.back().time
            << " s, in time constants: "
            << (late.back().time - late.back().value) / tau << std::endl;

  // one that is loaded goes on as the other does
  seiche::StateArchive saved;
  ramp.save_or_load(saved, "0");
  seiche::StateArchive loaded(saved.bytes());
  SensorSignal         other(parameters(4., cut_off));
  other.save_or_load(loaded, "0");
  const auto one = ramp.advance(1.3, 0.5), two = other.advance(1.3, 0.5);
  std::cout << "loaded: " << one.size() << " and " << two.size()
            << " samples, the same: "
            << (one.at(0).value == two.at(0).value &&
                    ramp.value() == other.value() ?
                  "yes" :
                  "no")
            << std::endl;
}
