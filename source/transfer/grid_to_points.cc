// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/held_points.h>
#include <seiche/transfer/point_arrays.h>
#include <seiche/transfer/point_block.h>
#include <seiche/transfer/transfer.h>
#include <seiche/transfer/volume_change.h>
#include <seiche/transfer/wall_faces.h>

#include <cmath>
#include <limits>

namespace seiche
{
  namespace
  {
    /// The velocity of the points of a block, by the method's rule.
    template <int dim, int degree>
    class VelocityRule
    {
    public:
      static constexpr unsigned int n_nodes = TensorShape<dim, degree>::n_nodes;

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
        , velocity_new(by_acceleration(transfer_method) ?
                         state.velocity_start.begin() :
                         state.velocity_np1.begin())
        , velocity_np1(state.velocity_np1.begin())
        , velocity_series(state.velocity_series.size() > 0 ?
                            state.velocity_series.begin() :
                            nullptr)
        , acceleration_np1(state.acceleration_np1.size() > 0 ?
                             state.acceleration_np1.begin() :
                             nullptr)
      {}

      void
      gather(const Occupancy<dim> &occupancy, const unsigned int cell)
      {
        end_field.gather(velocity_np1, occupancy, cell);
        if (velocity_new == velocity_np1)
          source = end_field;
        else
          source.gather(velocity_new, occupancy, cell);
        const bool series = method.update == VelocityUpdate::xpic;
        if (const double share = series ? 1. : keep; share > 0.)
          subtract(velocity_n, share, occupancy, cell);
        if (series)
          subtract(velocity_series, -1., occupancy, cell);
        if (acceleration_np1 != nullptr)
          acceleration_field.gather(acceleration_np1, occupancy, cell);
      }

      template <typename Arrays>
      void
      update(const Block<dim, degree> &block,
             const Arrays             &arrays,
             const std::size_t         first,
             const unsigned int        n_filled) const
      {
        const bool with_acceleration =
          acceleration_np1 != nullptr && arrays.acceleration[0] != nullptr;
        double result[n_lanes];
        for (unsigned int c = 0; c < dim; ++c)
          {
            block.value(source.values[c], result);
            for (unsigned int l = 0; l < n_filled; ++l)
              arrays.velocity[c][first + l] =
                keep * arrays.velocity[c][first + l] + result[l];
          }
        if (by_acceleration(method))
          {
            Assert(with_acceleration,
                   dealii::ExcMessage("Points or grid lack accelerations."));
            // Newmark with gamma = 1/2, as in the founding paper
            for (unsigned int c = 0; c < dim; ++c)
              {
                block.value(acceleration_field.values[c], result);
                for (unsigned int l = 0; l < n_filled; ++l)
                  arrays.velocity[c][first + l] +=
                    0.5 * dt * (arrays.acceleration[c][first + l] + result[l]);
              }
          }
        if (with_acceleration)
          for (unsigned int c = 0; c < dim; ++c)
            {
              block.value(acceleration_field.values[c], result);
              for (unsigned int l = 0; l < n_filled; ++l)
                arrays.acceleration[c][first + l] = result[l];
            }
      }

      CellField<dim, degree> end_field; // v_np1, for the gradient

    private:
      /// True if the points integrate accelerations; of the grid's velocity
      /// they then take the jump v_0 - v_n alone: impulses of the walls and
      /// of the projection are in no acceleration.
      static bool
      by_acceleration(const TransferMethod &method)
      {
        return method.update == VelocityUpdate::flip_acceleration;
      }

      /// source -= share times a nodal vector.
      void
      subtract(const double         *vector,
               const double          share,
               const Occupancy<dim> &occupancy,
               const unsigned int    cell)
      {
        CellField<dim, degree> field;
        field.gather(vector, occupancy, cell);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int i = 0; i < n_nodes; ++i)
            source.values[c][i] -= share * field.values[c][i];
      }

      const TransferMethod  &method;
      const double           keep;
      const double           dt;
      const double          *velocity_n;
      const double          *velocity_new;
      const double          *velocity_np1;
      const double          *velocity_series;
      const double          *acceleration_np1;
      CellField<dim, degree> source;
      CellField<dim, degree> acceleration_field;
    };



    /// C = (grad_n v_np1) f_1^-1: the gradient in the end configuration, or
    /// without f_1^-1 in that at the start.
    template <int dim, int degree, typename Arrays>
    void
    update_gradient(const Block<dim, degree>     &block,
                    const CellField<dim, degree> &velocity,
                    const bool                    at_start,
                    const double (&det)[n_lanes],
                    const double (&cofactor)[dim][dim][n_lanes],
                    const Arrays      &arrays,
                    const std::size_t  first,
                    const unsigned int n_filled)
    {
      double gradient[dim][dim][n_lanes];
      block.field_gradient(velocity, /*add_identity=*/false, gradient);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          {
            double result[n_lanes];
            for (unsigned int l = 0; l < n_lanes; ++l)
              {
                double sum = 0.;
                for (unsigned int k = 0; k < dim; ++k)
                  sum += gradient[c][k][l] * cofactor[d][k][l];
                result[l] = at_start ? gradient[c][d][l] : sum / det[l];
              }
            for (unsigned int l = 0; l < n_filled; ++l)
              arrays.gradient[c * dim + d][first + l] = result[l];
          }
    }

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
    const CellLocator<dim>                 &locator = points.locator;
    constexpr unsigned int n_nodes = TensorShape<dim, degree>::n_nodes;

    const bool    with_pressure = state.solution.n_blocks() > 1;
    const double *displacement  = state.displacement().begin();
    const double *pressure = with_pressure ? state.pressure().begin() : nullptr;

    VelocityRule<dim, degree> rule(method, parameters, state);
    CellField<dim, degree>    u;
    double                    p_nodal[n_nodes] = {}, volume_nodal[n_nodes] = {};
    Block<dim, degree>        block;
    WallFaces<dim, degree>    walls(occupancy);
    std::size_t               n_held = 0;
    for_each_block(
      occupancy,
      points,
      [&](const unsigned int cell) {
        if (occupancy.degree(cell) != degree)
          return false;
        const auto nodes = occupancy.template unknowns<degree>(cell);
        u.gather(displacement, occupancy, cell);
        if (held.any_may_be())
          walls.reinit(cell, u);
        rule.gather(occupancy, cell);
        if (mean_volume)
          {
            for (unsigned int i = 0; i < n_nodes; ++i)
              volume_nodal[i] = volume_change.local_element(nodes[i]);
            nodes.expand(volume_nodal);
          }
        if (with_pressure)
          {
            for (unsigned int i = 0; i < n_nodes; ++i)
              p_nodal[i] = pressure[nodes[i]];
            nodes.expand(p_nodal);
          }
        return true;
      },
      [&](const unsigned int cell,
          const std::size_t  first,
          const unsigned int n_filled) {
        block.reinit(arrays,
                     first,
                     n_filled,
                     locator.lower_corner(cell),
                     locator.extent(cell));
        double F[dim][dim][n_lanes], cofactor[dim][dim][n_lanes];
        double det[n_lanes], way[dim][n_lanes], result[n_lanes];
        block.field_gradient(u, /*add_identity=*/true, F);
        for (unsigned int c = 0; c < dim; ++c)
          block.value(u.values[c], way[c]);
        bool is_held[n_lanes] = {};
        if (held.any_may_be())
          {
            std::array<const double *, dim> x;
            for (unsigned int c = 0; c < dim; ++c)
              x[c] = arrays.position[c] + first;
            held.shorten(
              locator.reach(cell), walls, x, n_filled, F, way, is_held);
          }
        determinant_and_cofactors<dim>(F, det, cofactor);
        if (mean_volume)
          block.value(volume_nodal, result);
        for (unsigned int l = 0; l < n_filled; ++l)
          arrays.volume_ratio[first + l] *=
            mean_volume && !is_held[l] ? result[l] : det[l];
        for (unsigned int l = 0; l < n_filled; ++l)
          if (is_held[l])
            {
              ++n_held;
              double &ratio = arrays.volume_ratio[first + l];
              ratio         = held.bounded(ratio);
            }
        rule.update(block, arrays, first, n_filled);
        if (arrays.gradient[0] != nullptr)
          update_gradient<dim, degree>(block,
                                       rule.end_field,
                                       method.at_start,
                                       det,
                                       cofactor,
                                       arrays,
                                       first,
                                       n_filled);
        if (with_pressure)
          {
            block.value(p_nodal, result);
            for (unsigned int l = 0; l < n_filled; ++l)
              arrays.pressure[first + l] = result[l];
          }
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int l = 0; l < n_filled; ++l)
            arrays.position[c][first + l] += way[c][l];
      });
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
