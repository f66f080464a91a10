// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_transfer_h
#define seiche_transfer_transfer_h

#include <seiche/grid/cell_materials.h>
#include <seiche/grid/fill.h>
#include <seiche/grid/grid_state.h>
#include <seiche/points/point_cloud.h>
#include <seiche/transfer/volume_update.h>

#include <limits>
#include <set>
#include <string>

namespace seiche
{
  class InputFile;
  template <int dim>
  class HeldPoints;

  /**
   * @brief The choice of transfers (prm subsection "Transfer"): one name is a
   * row of the table in transfer.cc (doc/theory.md, section 7).
   */
  struct TransferParameters
  {
    std::string  method        = "affine FLIP";
    double       flip_fraction = 0.95; // of "PIC/FLIP blend"
    unsigned int order         = 4;    // of XPIC and FMPM
    std::string  mass          = "automatic";

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @p degree of the elements; @p points_per_direction at the start.
    void
    check(const InputFile   &input,
          const unsigned int degree,
          const unsigned int points_per_direction) const;

    bool
    is_consistent(const unsigned int degree) const
    {
      return mass == "consistent" || (mass == "automatic" && degree > 1);
    }

    /// Whether a mass that is consistent is so in cells of degree 2 alone.
    bool
    lumps_linear_cells() const
    {
      return mass == "automatic";
    }
  };

  /// What a point passes on beside its velocity.
  enum class GradientUse
  {
    none,
    carried, ///< the velocity gradient C that it carries
    fitted   ///< least squares over the points of its cell
  };

  /// How velocities return to the points.
  enum class VelocityUpdate
  {
    pic,               ///< v = N v_np1
    flip_increment,    ///< v += N (v_np1 - v_n)
    flip_acceleration, ///< v += N (v_0 - v_n) + dt/2 (a_p + N a_np1)
    blend,             ///< flip_fraction flip_increment + rest pic
    xpic,              ///< v = N (v_np1 - v_n + M^-1 p by a series)
    fmpm               ///< v = N v_np1, and v_n by the series too
  };

  /// One row of the table of transfers.
  struct TransferMethod
  {
    const char    *name;
    GradientUse    gradient; ///< in points to grid
    bool           at_start; ///< C in the configuration at t_n, not t_n+1
    VelocityUpdate update;
    const char    *papers; ///< keys of doc/references.bib
    const char    *description;
  };

  /// Row by name; Assert if there is none (the pattern refuses others).
  const TransferMethod &
  transfer_method(const std::string &name);

  /// Of all rows, in their order.
  std::vector<std::string>
  transfer_names();

  /// Result of a trial of the convective phase, all ranks.
  struct StepCheck
  {
    double min_det_F =
      std::numeric_limits<double>::max(); ///< of the whole and half increment,
                                          ///< at the points
    double max_displacement = 0.;         ///< in cells of the point's cell
    double beyond_wall      = 0.;         ///< way of a point through a wall of
                                          ///< WallFaces [cells]
    bool finite = true;

    /// Collective.
    StepCheck
    of_all_ranks(const MPI_Comm communicator) const;

    /// Why the step must not be accepted, or empty. @p limit: largest
    /// displacement in cells. @p holds_points: grid_to_points() holds back
    /// those that move too far or crush their volume.
    std::string
    problem(const double limit, const bool holds_points) const;
  };

  /**
   * @brief Points to grid and back (doc/theory.md (7.1) to (7.3); papers:
   * TransferMethod); sums in (cell, id) order.
   */
  template <int dim>
  class Transfer
  {
  public:
    /// References must outlive the object.
    Transfer(const TransferParameters &transfer_parameters,
             const Fill<dim>          &grid_fill,
             const CellMaterials<dim> &materials,
             const VolumeUpdate        volume_update);

    /// Columns that the method needs beyond the always present ones.
    static std::set<PointColumn>
    columns(const TransferParameters &parameters);

    /// Fills mass, velocity_n, acceleration_n (if present), pressure_guess of
    /// the state, what is unseen beside them, and the series of XPIC. Nodes
    /// without mass get zero. Walls do not count, so that increments carry what
    /// they do to the fluid to the points. Collective.
    void
    points_to_grid(const PointCloud<dim> &points, GridState<dim> &state) const;

    /// What grid_to_points would do to the points. Cells whose nodal values
    /// show already that the step is accepted with this @p limit [cells] do not
    /// count. Collective.
    StepCheck
    check(const GridState<dim>  &state,
          const PointCloud<dim> &points,
          const double           limit) const;

    /// Position, velocity, gradient, acceleration, volume ratio and pressure
    /// of the points. (x += N u; J *= det f_1 or its nodal mean; C = grad_n
    /// v_np1 f_1^-1.) In the irreducible form the pressure is left to the
    /// caller. @p held_beyond [cells]: points that would move farther, or crush
    /// their volume, are held back (HeldPoints); infinity: none. The number of
    /// points held on this rank. Collective.
    std::size_t
    grid_to_points(
      const GridState<dim> &state,
      PointCloud<dim>      &points,
      const double held_beyond = std::numeric_limits<double>::infinity()) const;

  private:
    /// Nodal velocities closest to the points'. Collective.
    void
    find_closest(const PointCloud<dim> &points, GridState<dim> &state) const;

    /// The series of XPIC and FMPM. Collective.
    void
    expand_series(const PointCloud<dim> &points, GridState<dim> &state) const;

    /// In the cells of a degree.
    template <int degree>
    void
    check_cells(const GridState<dim>  &state,
                const PointCloud<dim> &points,
                const double           limit,
                StepCheck             &result) const;
    template <int degree>
    std::size_t
    move_points(const GridState<dim>                  &state,
                const typename GridState<dim>::Vector &volume_change,
                const HeldPoints<dim>                 &held,
                PointCloud<dim>                       &points) const;

    const TransferParameters  parameters;
    const TransferMethod     &method;
    const Fill<dim>          &fill;
    const Occupancy<dim>     &occupancy;
    const CellMaterials<dim> &materials;
    const bool                mean_volume;
  };
} // namespace seiche

#endif
