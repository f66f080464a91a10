// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_probe_parameters_h
#define seiche_postprocess_probe_parameters_h

#include <seiche/postprocess/sensor_signal.h>
#include <seiche/scene/grid_parameters.h>

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
} // namespace seiche

#endif
