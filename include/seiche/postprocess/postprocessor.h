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
    unsigned int           step          = 0;
    double                 time          = 0.; ///< [s] end of the step
    double                 dt            = 0.; ///< [s]
    double                 pressure_time = 0.; ///< [s] time of the pressure
    const PointCloud<dim> &points;
    const Occupancy<dim>  &occupancy;
    const Fill<dim>       &fill;
    const GridState<dim>  &state;
    /// Constant body acceleration [m/s^2], in the axes of the tank as it is
    /// now; zero if it varies in space or time (the ledger's energy is then
    /// kinetic only).
    dealii::Tensor<1, dim> gravity;
    /// Bulk modulus [Pa], infinity allowed.
    double bulk_modulus;
    /// The configuration of forces is x_n + theta u, that of the pressure
    /// x_n + pressure_theta u.
    double theta;
    double pressure_theta;
    double half_spacing;          ///< [m] half the initial spacing of points
    double smallest_extent;       ///< [m] smallest cell edge
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
