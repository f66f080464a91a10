// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_point_control_h
#define seiche_grid_point_control_h

#include <seiche/grid/reseeding.h>
#include <seiche/grid/shifting.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;
  class StateArchive;

  /// How the points are kept well distributed (prm subsection "Points").
  struct PointControlParameters
  {
    unsigned int sweeps       = 0;    // of shifting, each step
    double       strength     = 0.25; // of a sweep
    bool         reseeding    = false;
    unsigned int fewest       = 0; // points per cell; 0: half of what is seeded
    unsigned int most         = 0; // 0: twice what is seeded
    double       density_rate = 0.5; // of DensityProjection [-], 0: off

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @p carries_gradient: the points do. @p per_cell: points of a full cell.
    /// Fills in what is 0.
    void
    check(const InputFile   &input,
          const bool         carries_gradient,
          const unsigned int per_cell);
  };

  /**
   * @brief Shifting, splitting and merging of points between two steps, and
   * the account of what that does to energy and momentum (doc/theory.md (5.1),
   * (5.3) to (5.5)).
   */
  template <int dim>
  class PointControl
  {
  public:
    /// References must outlive the object. Collective.
    PointControl(const PointControlParameters &parameters,
                 PointCloud<dim>              &points,
                 Occupancy<dim>               &occupancy,
                 Fill<dim>                    &fill);

    /// Occupancy and Fill are those of the points, before and after. Nothing
    /// happens if all is off. Collective.
    void
    update();

    /// Names and values since the start of the run: points split and merged,
    /// changes of kinetic energy, momentum and angular momentum about the
    /// origin. Empty if all is off.
    std::vector<std::pair<std::string, double>>
    account() const;

    /// The names.
    static std::vector<std::string>
    account_names(const PointControlParameters &parameters);

    /// The account and the next id. Local.
    void
    save_or_load(StateArchive &archive);

  private:
    /// Kinetic energy, momentum (3), angular momentum (3) of all points.
    using Moments = std::array<double, 7>;
    /// Of the own points. Local.
    Moments
    moments() const;

    /// Add what has changed since @p before, all ranks, to @p sum. Collective.
    void
    add_change(const Moments &before, Moments &sum) const;

    /// Cells, occupancy and fill of the points where they are now. Collective.
    void
    find_again();

    const PointControlParameters &parameters;
    PointCloud<dim>              &points;
    Occupancy<dim>               &occupancy;
    Fill<dim>                    &fill;
    Shifting<dim>                 shifting;
    Reseeding<dim>                reseeding;

    // since the start, all ranks
    std::uint64_t next_id = 0;
    double        n_split = 0., n_merged = 0.;
    Moments       by_shifting{}, by_splitting{}, by_merging{};
  };
} // namespace seiche

#endif
