// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_tracked_points_h
#define seiche_postprocess_tracked_points_h

#include <seiche/postprocess/postprocessor.h>
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

  /// prm entries of "Tracked point NAME".
  template <int dim>
  struct TrackedPointParameters
  {
    static constexpr const char *kind = "Tracked point";

    std::string        name;
    dealii::Point<dim> position; ///< [m]
    dealii::Point<dim> centre;   ///< [m]

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const GridParameters<dim> &grid) const;
    std::vector<std::string>
    columns() const;
  };

  /**
   * @brief Path of single material points, each chosen at the start as the
   * nearest to a place (the lowest id of several).
   *
   * Columns: the position, and the distance from a centre over that at the
   * start. Missing after the point has left through an open side.
   */
  template <int dim>
  class TrackedPoints : public Postprocessor<dim>
  {
  public:
    using Parameters = TrackedPointParameters<dim>;

    TrackedPoints(const std::vector<Parameters> &parameters,
                  const PostprocessorContext<dim> &);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

  private:
    /// Ids of the points nearest to the given places. Collective.
    void
    choose(const StepView<dim> &view);

    const std::vector<TrackedPointParameters<dim>> tracks;

    std::vector<std::uint64_t> ids;          // of each track
    std::vector<std::size_t>   last_index;   // where this rank saw it last
    std::vector<double>        start_radius; // [m]
  };
} // namespace seiche

#endif
