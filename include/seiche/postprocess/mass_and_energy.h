// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_mass_and_energy_h
#define seiche_postprocess_mass_and_energy_h

#include <seiche/postprocess/postprocessor.h>
#include <seiche/postprocess/tank_record.h>

#include <array>

namespace seiche
{
  /**
   * @brief The ledger: what must be conserved, from the points alone.
   *
   * Sums run over the points in the order (cell, id), in blocks of fixed size
   * with compensated sums of the blocks; then over the ranks. All values in
   * 2D are per metre of depth. The angular momentum is taken about the
   * origin, without the spin of the velocity gradient. Potential energy is
   * counted from the lowest point of the domain box; with a body force that
   * varies it is left out. In a tank that moves both energies are those of its
   * frame, and what its motion has worked is taken off their sum.
   */
  template <int dim>
  class MassAndEnergy : public Postprocessor<dim>
  {
  public:
    /// @p tank: that of a tank that moves, or null; executed before.
    MassAndEnergy(const BackgroundGrid<dim> &grid, const TankRecord<dim> *tank);

    /// Corner of the box at the start that the potential energy counts from
    /// [m], as a vector.
    static dealii::Tensor<1, dim>
    zero_of_potential(const StepView<dim> &view);

    /// Names of the columns, in order.
    static std::vector<std::string>
    columns();

    /// Paths of the numbers that finish() adds.
    static std::vector<std::string>
    summary_numbers()
    {
      return {"ledger/mass_relative_change",
              "ledger/volume_relative_change",
              "ledger/angular_momentum_relative_change",
              "ledger/energy_initial",
              "ledger/energy_final",
              "ledger/energy_max_relative_gain",
              "ledger/lost_points",
              "ledger/outflow_points",
              "ledger/overfull_fraction",
              "ledger/overfull_fraction_mean"};
    }

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

    /// Fills summary["ledger"]; what is not defined is null.
    void
    finish(const StatisticsTable  &statistics,
           nlohmann::ordered_json &summary) override;

    /// sum V0 [m^dim] of the last step, and sum J V0 over it, less 1 [-].
    double
    first_volume() const
    {
      return now.initial_volume;
    }
    double
    volume_change() const
    {
      return now.volume / now.initial_volume - 1.;
    }

    /// Kinetic and potential energy over that at the start; NaN if that was
    /// zero.
    double
    relative_energy() const;

    /// Largest rise of the energy above an earlier value, over that at the
    /// start; 0 if there was none.
    double
    relative_energy_gain() const;

  private:
    static constexpr unsigned int n_rotations = (dim == 2 ? 1 : 3);

    /// State of all points of all ranks.
    struct Totals
    {
      double                          mass           = 0.; ///< [kg]
      double                          volume         = 0.; ///< sum J V0
      double                          initial_volume = 0.; ///< sum V0
      double                          kinetic        = 0.; ///< [J]
      double                          potential      = 0.; ///< [J]
      std::array<double, dim>         momentum{};          ///< [kg m/s]
      std::array<double, n_rotations> angular_momentum{};  ///< [kg m^2/s]
      double                          speed_max        = 0.;
      double                          volume_ratio_min = 1.;
      double                          volume_ratio_max = 1.;
      double                          outflow_mass     = 0.;
      std::uint64_t                   points           = 0;
      std::uint64_t                   outflow_points   = 0;

      double
      energy() const
      {
        return kinetic + potential;
      }

      void
      save_or_load(StateArchive &archive);
    };

    Totals
    sum_up(const StepView<dim> &view) const;

    /// Of the fluid now, less the work of the tank [J].
    double
    energy() const
    {
      return now.energy() - (tank != nullptr ? tank->work() : 0.);
    }

    const BackgroundGrid<dim> &grid;
    const TankRecord<dim>     *tank;

    Totals       start, now;
    bool         started          = false;
    double       energy_minimum   = 0.; // so far
    double       energy_rise      = 0.; // largest above the running minimum
    double       overfull_maximum = 0.;
    double       overfull_sum     = 0.;
    unsigned int n_rows           = 0;
  };
} // namespace seiche

#endif
