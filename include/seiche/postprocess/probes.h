// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_probes_h
#define seiche_postprocess_probes_h

#include <seiche/postprocess/nodal_pressure.h>
#include <seiche/postprocess/postprocessor.h>

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

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const GridParameters<dim> &grid) const;
    std::vector<std::string>
    columns() const;

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
   * times, into a file `probes.csv` of their own.
   */
  template <int dim>
  class Probes : public Postprocessor<dim>
  {
  public:
    /// @p filename empty: no file of its own. One rank writes it.
    Probes(const std::vector<ProbeParameters<dim>>   &parameters,
           const BackgroundGrid<dim>                 &grid,
           const std::shared_ptr<NodalPressure<dim>> &nodal_pressure,
           const std::string                         &filename,
           const bool                                 writes = true);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

  private:
    const std::vector<ProbeParameters<dim>>      probes;
    const std::shared_ptr<NodalPressure<dim>>    pressure;
    std::vector<std::vector<dealii::Point<dim>>> places; // of each probe
    StatisticsTable                              table;
  };
} // namespace seiche

#endif
