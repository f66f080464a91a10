// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_range.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/held_points.h>
#include <seiche/transfer/point_arrays.h>
#include <seiche/transfer/transfer.h>
#include <seiche/transfer/volume_change.h>
#include <seiche/transfer/wall_faces.h>

#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// The velocity of points, by the method's rule.
    template <int dim, int degree>
    class VelocityRule
    {
    public:
      using Batch       = PointBatch<dim, degree>;
      using NodalVector = double[dim][Batch::n_nodes];

      VelocityRule(const TransferMethod     &transfer_method,
                   const TransferParameters &parameters,
                   const GridState<dim>     &state)
        : method(transfer_method)
        // v_p <- keep v_p + N (v_new - keep v_n): 1 is FLIP, 0 is PIC
        , keep(transfer_method.update == VelocityUpdate::flip_increment ||
                   by_acceleration(transfer_method) ?
                 1. :
               transfer_method.update == VelocityUpdate::blend ?
                 parameters.flip_fraction :
                 0.)
        , dt(state.dt)
        , velocity_n(state.velocity_n.begin())
        , unseen_velocity(state.unseen_velocity.size() > 0 ?
                            state.unseen_velocity.begin() :
                            nullptr)
        , velocity_new(by_acceleration(transfer_method) ?
                         state.velocity_start.begin() :
                         state.velocity_np1.begin())
        , velocity_np1(state.velocity_np1.begin())
        , velocity_series(state.velocity_series.size() > 0 ?
                            state.velocity_series.begin() :
                            nullptr)
        , unseen_series(state.unseen_series.size() > 0 ?
                          state.unseen_series.begin() :
                          nullptr)
        , acceleration_np1(state.acceleration_np1.size() > 0 ?
                             state.acceleration_np1.begin() :
                             nullptr)
      {}

      void
      read(const CellUnknowns<dim, degree> &nodes)
      {
        nodes.read(velocity_np1, end_velocity);
        nodes.read(velocity_new, source);
        const bool series = method.update == VelocityUpdate::xpic;
        if (const double share = series ? 1. : keep; share > 0.)
          // what the points bring to a wall they leave there
          subtract(velocity_n, unseen_velocity, share, nodes);
        if (series)
          subtract(velocity_series, unseen_series, -1., nodes);
        if (acceleration_np1 != nullptr)
          nodes.read(acceleration_np1, acceleration);
      }

      template <typename Arrays>
      void
      update(const Batch      &batch,
             const PointRange &range,
             const Arrays     &arrays) const
      {
        const bool with_acceleration =
          acceleration_np1 != nullptr && arrays.acceleration[0] != nullptr;
        Assert(with_acceleration || !by_acceleration(method),
               dealii::ExcMessage("Points or grid lack accelerations."));
        for (unsigned int c = 0; c < dim; ++c)
          {
            Lanes velocity =
              keep * range.load(arrays.velocity[c]) + batch.value(source[c]);
            if (with_acceleration)
              {
                const Lanes a_np1 = batch.value(acceleration[c]);
                // Newmark with gamma = 1/2, as in the founding paper
                if (by_acceleration(method))
                  velocity +=
                    0.5 * dt * (range.load(arrays.acceleration[c]) + a_np1);
                range.store(a_np1, arrays.acceleration[c]);
              }
            range.store(velocity, arrays.velocity[c]);
          }
      }

      /// That of v_np1, with APIC and affine FLIP; @p F: of the step.
      template <typename Arrays>
      void
      update_gradient(const Batch                         &batch,
                      const dealii::Tensor<2, dim, Lanes> &F,
                      const PointRange                    &range,
                      const Arrays                        &arrays) const
      {
        if (arrays.gradient[0] == nullptr)
          return;
        dealii::Tensor<2, dim, Lanes> C = batch.gradient(end_velocity);
        if (!method.at_start)
          C = C * invert(F);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            range.store(C[c][d], arrays.gradient[c * dim + d]);
      }

    private:
      /// True if the points integrate accelerations; of the grid's velocity
      /// they then take the jump v_0 - v_n alone: impulses of the walls and
      /// of the projection are in no acceleration.
      static bool
      by_acceleration(const TransferMethod &method)
      {
        return method.update == VelocityUpdate::flip_acceleration;
      }

      /// source -= share times a nodal vector, of which @p unseen (or null)
      /// is what it leaves out.
      void
      subtract(const double                    *vector,
               const double                    *unseen,
               const double                     share,
               const CellUnknowns<dim, degree> &nodes)
      {
        NodalVector values;
        if (unseen == nullptr)
          nodes.read(vector, values);
        else
          nodes.read(vector, unseen, values);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int i = 0; i < Batch::n_nodes; ++i)
            source[c][i] -= share * values[c][i];
      }

      const TransferMethod &method;
      const double          keep;
      const double          dt;
      const double         *velocity_n;
      const double         *unseen_velocity;
      const double         *velocity_new;
      const double         *velocity_np1;
      const double         *velocity_series;
      const double         *unseen_series;
      const double         *acceleration_np1;
      NodalVector           end_velocity; // v_np1, for the gradient
      NodalVector           source;
      NodalVector           acceleration;
    };
  } // namespace



  template <int dim>
  std::size_t
  Transfer<dim>::grid_to_points(const GridState<dim> &state,
                                PointCloud<dim>      &points,
                                const double          held_beyond) const
  {
    const HeldPoints<dim>                 held(held_beyond);
    const typename GridState<dim>::Vector volume_change =
      mean_volume ? nodal_volume_change(fill, points, state) :
                    typename GridState<dim>::Vector();
    std::size_t n_held = 0;
    occupancy.for_each_degree([&](const auto degree) {
      n_held +=
        this->template move_points<degree>(state, volume_change, held, points);
    });
    return n_held;
  }



  template <int dim>
  template <int degree>
  std::size_t
  Transfer<dim>::move_points(
    const GridState<dim>                  &state,
    const typename GridState<dim>::Vector &volume_change,
    const HeldPoints<dim>                 &held,
    PointCloud<dim>                       &points) const
  {
    const PointArrays<dim, PointCloud<dim>> arrays(points);
    VelocityRule<dim, degree>               rule(method, parameters, state);
    PointBatch<dim, degree>                 batch;
    WallFaces<dim, degree>                  walls(occupancy);
    const bool  with_pressure = state.solution.n_blocks() > 1;
    double      u_nodal[dim][batch.n_nodes];
    double      p_nodal[batch.n_nodes], change_nodal[batch.n_nodes];
    std::size_t n_held = 0;
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        if (occupancy.degree(cell) != degree)
          continue;
        const CellGeometry<dim> &geometry = points.locator.cells.geometry(cell);
        const auto nodes = occupancy.template unknowns<degree>(cell);
        nodes.read(state.displacement().begin(), u_nodal);
        rule.read(nodes);
        if (mean_volume)
          nodes.read(volume_change.begin(), change_nodal);
        if (with_pressure)
          nodes.read(state.pressure().begin(), p_nodal);
        if (held.any_may_be())
          walls.reinit(cell, u_nodal);

        for_each_range(points, cell, [&](const PointRange &range) {
          const Point<dim, Lanes> x = range.position(arrays.position);
          batch.reinit(geometry, geometry.to_unit(x));
          Tensor<1, dim, Lanes> u = batch.value(u_nodal);
          Tensor<2, dim, Lanes> H = batch.gradient(u_nodal);
          const HeldFlags       is_held =
            held.any_may_be() ?
                    held.shorten(
                points.locator.cells.reach(cell), walls, x, range.size, H, u) :
                    HeldFlags();
          const Tensor<2, dim, Lanes> F = identity_plus(H);

          const Lanes own = determinant(F);
          n_held +=
            held.update_volume(mean_volume ? batch.value(change_nodal) : own,
                               own,
                               is_held,
                               range,
                               arrays.volume_ratio);
          rule.update(batch, range, arrays);
          rule.update_gradient(batch, F, range, arrays);
          if (with_pressure)
            range.store(batch.value(p_nodal), arrays.pressure);
          for (unsigned int c = 0; c < dim; ++c)
            range.store(x[c] + u[c], arrays.position[c]);
        });
      }
    return n_held;
  }



  template std::size_t
  Transfer<2>::grid_to_points(const GridState<2> &,
                              PointCloud<2> &,
                              const double) const;
  template std::size_t
  Transfer<3>::grid_to_points(const GridState<3> &,
                              PointCloud<3> &,
                              const double) const;
} // namespace seiche
