// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_run_up_h
#define seiche_postprocess_run_up_h

#include <seiche/postprocess/postprocessor_context.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of "Run-up NAME".
  template <int dim>
  struct RunUpParameters
  {
    static constexpr const char *kind = "Run-up";

    std::string name;
    std::string wall; ///< name of a side or an obstacle

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const GridParameters<dim> &grid) const;
    std::vector<std::string>
    columns() const;
  };

  /**
   * @brief How high a wall is wet (FluidExtent): the fluid that stands on it,
   * and the spray in the cells beside it if that is higher. The height falls
   * with the water; the bottom of the domain if the wall is dry. Vertical is
   * the last direction.
   */
  template <int dim>
  class RunUp : public Postprocessor<dim>
  {
  public:
    using Parameters = RunUpParameters<dim>;

    RunUp(const std::vector<Parameters>   &parameters,
          const PostprocessorContext<dim> &context);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

  private:
    const std::vector<RunUpParameters<dim>>       run_ups;
    const BackgroundGrid<dim>                    &grid;
    const std::shared_ptr<FluidExtentOfStep<dim>> extent;
    std::vector<unsigned int>                     walls; // of each run-up
  };
} // namespace seiche

#endif
