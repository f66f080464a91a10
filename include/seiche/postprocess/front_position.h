// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_front_position_h
#define seiche_postprocess_front_position_h

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

  /// prm entries of "Front NAME".
  template <int dim>
  struct FrontParameters
  {
    static constexpr const char *kind = "Front";

    std::string name;
    std::string direction    = "x";
    std::string sense        = "upper";
    double      least_height = 0.; ///< [m] above the first bottom; 0: all

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const GridParameters<dim> &grid) const;
    std::vector<std::string>
    columns() const;

    /// Number of the direction, and 1 or -1 for the sense.
    unsigned int
    axis() const;
    double
    sign() const;
  };

  /**
   * @brief How far the fluid reaches in a direction, from a height on
   * (FluidExtent).
   *
   * Spray counts where there is nothing else; without that it is the side of
   * the domain that the front moves from, at its place at the start. Vertical
   * is the last direction.
   */
  template <int dim>
  class FrontPosition : public Postprocessor<dim>
  {
  public:
    using Parameters = FrontParameters<dim>;

    FrontPosition(const std::vector<Parameters>   &parameters,
                  const PostprocessorContext<dim> &context);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

  private:
    const std::vector<FrontParameters<dim>>       fronts;
    const GridParameters<dim>                    &box;
    const std::shared_ptr<FluidExtentOfStep<dim>> extent;
  };
} // namespace seiche

#endif
