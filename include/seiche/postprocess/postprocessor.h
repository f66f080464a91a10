// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_postprocessor_h
#define seiche_postprocess_postprocessor_h

#include <seiche/grid/fill.h>
#include <seiche/grid/grid_state.h>
#include <seiche/points/point_cloud.h>
#include <seiche/postprocess/statistics_table.h>
#include <seiche/scene/tank_motion.h>
#include <seiche/solve/step_balance.h>
#include <seiche/space/occupancy.h>

#include <deal.II/base/bounding_box.h>

#include <limits>
#include <string>

namespace seiche
{
  /**
   * @brief What a postprocessor sees of a finished step.
   *
   * Grid fields belong to the step just done and to the grid as it was at its
   * start (node positions at t_n); the points are at the new positions but
   * still sorted by the cells of t_n (PointCloud::locate() runs at the start
   * of the next step). Before the first step (step 0) the grid fields hold
   * zero displacement and the velocity of the points.
   */
  template <int dim>
  struct StepView
  {
    /// The fields; all else is named by who fills it in.
    StepView(const PointCloud<dim> &step_points,
             const Fill<dim>       &step_fill,
             const GridState<dim>  &step_state)
      : points(step_points)
      , occupancy(step_fill.occupancy)
      , fill(step_fill)
      , state(step_state)
      , box(step_fill.occupancy.locator.lines.domain())
    {}

    const PointCloud<dim> &points;
    const Occupancy<dim>  &occupancy;
    const Fill<dim>       &fill;
    const GridState<dim>  &state;

    unsigned int step          = 0;
    double       time          = 0.; ///< [s] end of the step
    double       dt            = 0.; ///< [s]
    double       pressure_time = 0.; ///< [s] time of the pressure
    /// Constant body acceleration [m/s^2], in the axes of the tank as it is
    /// now; zero if it varies in space or time (the ledger's energy is then
    /// kinetic only).
    dealii::Tensor<1, dim> gravity;
    /// Bulk modulus [Pa], infinity allowed.
    double bulk_modulus = std::numeric_limits<double>::infinity();
    /// The configuration of forces is x_n + theta u, that of the pressure
    /// x_n + pressure_theta u.
    double                   theta          = 0.;
    double                   pressure_theta = 0.;
    double                   half_spacing   = 0.; ///< [m] of points, initial
    dealii::BoundingBox<dim> box; ///< of the walls at the end of the step
    unsigned int             newton_iterations = 0; ///< of this step, all tries
    unsigned int             krylov_iterations = 0; ///< of this step, all tries
    const TankPose<dim>     *tank = nullptr; ///< at the end of the step, if any
    StepBalance<dim>         balance = {};   ///< with a tank that moves
    double expected_step             = 0.; ///< SceneScales::expected_step() [s]
  };

  /**
   * @brief One quantity computed from each step: adds columns to the
   * statistics table, or writes files of its own.
   */
  template <int dim>
  class Postprocessor
  {
  public:
    virtual ~Postprocessor() = default;

    /// After every step, and once before the first. Collective.
    virtual void
    execute(const StepView<dim> &view, StatisticsTable &statistics) = 0;

    /// After the last step; may add to the summary. Collective.
    virtual void
    finish(const StatisticsTable &statistics, nlohmann::ordered_json &summary)
    {
      (void)statistics;
      (void)summary;
    }

    /// What it carries from step to step, in a section of its own, for a
    /// checkpoint. Loading also cuts its files back to that step. Collective.
    virtual void
    save_or_load(StateArchive &archive)
    {
      (void)archive;
    }
  };
} // namespace seiche

#endif
