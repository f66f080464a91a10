// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_error_norms_h
#define seiche_postprocess_error_norms_h

#include <seiche/postprocess/error_parameters.h>
#include <seiche/postprocess/postprocessor_context.h>

#include <memory>
#include <vector>

namespace seiche
{
  /**
   * @brief Error of pressure or velocity against given functions.
   *
   * Pressure: in the configuration x_n + pressure_theta u at
   * `pressure_time`. Velocity: at x_n + u at the end of the step. Samples and
   * their weights:
   * nodes of occupied cells, weight mass; (degree + 1)^dim Gauss points of each
   * occupied cell, weight measure of the cell over their number; material
   * points, equal weights. Norms: rms sqrt(sum w e^2 / sum w) and maximum over
   * "Scale"; relative L2 sqrt(sum w e^2 / sum w exact^2).
   * Missing for the pressure before the first step, and where nothing lies in
   * the region or the exact solution is zero.
   */
  template <int dim>
  class ErrorNorm : public Postprocessor<dim>
  {
  public:
    using Parameters = ErrorParameters<dim>;

    ErrorNorm(const Parameters                &error_parameters,
              const PostprocessorContext<dim> &context);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

  private:
    struct Sample
    {
      dealii::Tensor<1, dim> computed, exact;
      double                 weight;
    };

    void
    sample_nodes(const StepView<dim> &view);
    void
    sample_gauss_points(const StepView<dim> &view);
    void
    sample_material_points(const StepView<dim> &view);

    /// Keep a sample if @p x lies in the region.
    void
    add(const dealii::Point<dim>     &x,
        const dealii::Tensor<1, dim> &computed,
        const double                  weight);

    /// The norm over all ranks. Collective.
    double
    evaluate(const MPI_Comm communicator);

    const Parameters                          parameters;
    const Expression<dim>                     exact;
    const dealii::BoundingBox<dim>            region;
    const std::shared_ptr<NodalPressure<dim>> pressure;
    const bool                                of_pressure;

    double              time = 0.; // at which the exact solution is taken
    std::vector<Sample> samples;
  };
} // namespace seiche

#endif
