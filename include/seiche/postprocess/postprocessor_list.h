// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_postprocessor_list_h
#define seiche_postprocess_postprocessor_list_h

#include <seiche/postprocess/alarms.h>

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
  struct OutputParameters;

  /// Where something is measured.
  template <int dim>
  struct NamedPlace
  {
    std::string        name;
    dealii::Point<dim> place; ///< [m]
  };

  /**
   * @brief All postprocessors of a scene: declares their entries, makes them
   * and runs them in the order of the table (postprocessor_table.h).
   *
   * Always there: the ledger (mass_and_energy) and the alarms. By instance
   * subsections of the parameter file: "Front NAME", "Gauge NAME", "Run-up
   * NAME", "Probe NAME", "Tracked point NAME", "Force NAME", "Error NAME",
   * "Score NAME", "Verdict NAME". By entries of "Output": mean level, grid,
   * points, surface, HDF5 series.
   */
  template <int dim>
  class PostprocessorList
  {
  public:
    explicit PostprocessorList(const InputFile &input);
    ~PostprocessorList();

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Check the parsed entries (names of columns and walls, expressions,
    /// reference tables, paths of verdicts). @p end_time: of the run [s];
    /// @p other_columns: of the statistics, and @p other_numbers: paths in
    /// summary.json, beside those that the postprocessors add; @p tank_moves:
    /// a "Tank motion" adds some. InputError with place.
    void
    check(const GridParameters<dim>      &grid,
          const double                    end_time,
          const std::vector<std::string> &other_columns,
          const std::vector<std::string> &other_numbers,
          const bool                      tank_moves = false) const;

    /// Make the postprocessors. @p directory empty: no files (validation).
    void
    make(const std::string         &directory,
         const BackgroundGrid<dim> &grid,
         const MPI_Comm             communicator,
         const bool                 tank_moves = false);

    /// Ask for the columns that scores need at the end. After make().
    void
    request_columns(StatisticsTable &statistics) const;

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics);

    /// Fills "ledger", "errors", "verdict" and more of the summary.
    void
    finish(const StatisticsTable &statistics, nlohmann::ordered_json &summary);

    /// True if the finished run fails a verdict that decides over the exit
    /// code.
    bool
    rejects_run() const;

    const OutputParameters &
    output() const;

    /// True if a "Force NAME" reads the reactions of the walls.
    bool
    measure_forces() const;

    /// Of probes, tracked points and gauges.
    std::vector<NamedPlace<dim>>
    places() const;

    /// Of tracked points alone.
    std::vector<NamedPlace<dim>>
    tracked_places() const;

    /// What all of them carry from step to step. Collective.
    void
    save_or_load(StateArchive &archive);

    /// Energy [J] over its start, for the progress line.
    double
    relative_energy() const;

    /// Alarms::raised().
    const std::vector<typename Alarms<dim>::Alarm> &
    raised_alarms() const;

    /// MassAndEnergy::relative_energy_gain().
    double
    relative_energy_gain() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace seiche

#endif
