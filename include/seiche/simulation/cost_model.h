// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_cost_model_h
#define seiche_simulation_cost_model_h

namespace seiche
{
  /**
   * @brief What a run costs, by a table of figures measured once.
   *
   * Linear in cells and points: the iterations of the solvers hardly grow
   * with them (doc/scaling.md). Two Newton iterations a step are assumed;
   * what viscosity adds, see step().
   */
  struct CostModel
  {
    CostModel(const int dim, const unsigned int degree, const bool is_mixed);

    /// Processor time of a step on this machine [s]. @p diffusion is nu dt/h^2:
    /// from about one on a step takes up to four Newton iterations, each with a
    /// preconditioner of its own.
    double
    step(const double occupied_cells,
         const double points,
         const double diffusion) const;

    /// Processor time of the start on this machine [s].
    double
    start(const double cells) const;

    /// Processor time of writing files on this machine [s].
    double
    output(const double bytes) const;

    /// Largest, of all ranks together [bytes].
    double
    memory(const double cells,
           const double occupied_cells,
           const double points) const;

    /// Of the frames' files, as they come [bytes].
    double
    point_frame(const double points) const;
    double
    grid_frame(const double occupied_cells) const;
    double
    surface_frame(const double cells) const;
    /// Of a checkpoint, or a frame of the point series [bytes].
    double
    full_points(const double points) const;

  private:
    const int          dim;
    const unsigned int degree;
    const bool         is_mixed;
  };

  /// Time of this machine for a product of small matrices, over that of the
  /// machine of the table. Takes some 10 ms. Local.
  double
  slowness();
} // namespace seiche

#endif
