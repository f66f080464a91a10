// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_tank_record_h
#define seiche_postprocess_tank_record_h

#include <seiche/postprocess/postprocessor.h>

namespace seiche
{
  /**
   * @brief The tank that moves: where it is, the work that its motion does on
   * the fluid, and how well the balance of momentum in its frame closes.
   *
   * The energy in the tank's frame is that of the relative velocity and of the
   * gravity g as it points in the tank now, U = -sum m g.(x - x_0). It changes
   * by the work, of a step
   *
   *     dW = sum m f.u - sum m (x - x_0).dg,
   *
   * f the body and Coriolis forces without gravity (doc/theory.md, moving
   * tank).
   */
  template <int dim>
  class TankRecord : public Postprocessor<dim>
  {
  public:
    /// Names of the columns, in order.
    static std::vector<std::string>
    columns();

    /// Paths of the numbers that finish() adds.
    static std::vector<std::string>
    summary_numbers();

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    /// Adds to summary["ledger"].
    void
    finish(const StatisticsTable  &statistics,
           nlohmann::ordered_json &summary) override;

    void
    save_or_load(StateArchive &archive) override;

    /// Of the tank's motion since the start [J].
    double
    work() const
    {
      return total_work;
    }

  private:
    double total_work        = 0.;
    double largest_imbalance = 0.;  ///< over the weight or inertia of the fluid
    double mass              = 0.;  ///< [kg]
    dealii::Tensor<1, dim> gravity; ///< of the step before, tank's axes
    dealii::Tensor<1, dim> mass_moment; ///< sum m x, of the step before [kg m]
  };
} // namespace seiche

#endif
