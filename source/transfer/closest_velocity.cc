// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/mass_matrix.h>
#include <seiche/transfer/point_sums.h>
#include <seiche/transfer/transfer.h>

// The part of points to grid that needs the mass matrix of the points.
namespace seiche
{
  namespace
  {
    /// Masses that stand for the points in each component of the fields.
    template <int dim>
    typename MassMatrix<dim>::Field
    masses_of_components(const Occupancy<dim> &occupancy,
                         const GridState<dim> &state)
    {
      auto masses = MassMatrix<dim>::field(state.velocity_n, state.unseen_mass);
      for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
        for (unsigned int c = 0; c < dim; ++c)
          masses.block(0).local_element(dim * node + c) =
            state.seen_mass(node, c);
      return masses;
    }
  } // namespace

  template <int dim>
  void
  Transfer<dim>::find_closest(const PointCloud<dim> &points,
                              GridState<dim>        &state) const
  {
    using Vector         = typename GridState<dim>::Vector;
    using Field          = typename MassMatrix<dim>::Field;
    const bool     lumps = parameters.lumps_linear_cells();
    GridState<dim> lumped; // of linear cells
    lumped.reinit(occupancy, false, state.acceleration_n.size() > 0);
    if (lumps)
      sum_to_nodes(points,
                   occupancy,
                   method.gradient,
                   /*is_consistent=*/true,
                   /*linear_cells_only=*/true,
                   lumped);
    const Field           masses = masses_of_components(occupancy, lumped);
    const MassMatrix<dim> mass(points,
                               fill,
                               materials,
                               /*ghost_penalty=*/true,
                               lumps ? &masses : nullptr);

    Field sum =
            MassMatrix<dim>::field(lumped.velocity_n, lumped.unseen_velocity),
          velocity =
            MassMatrix<dim>::field(state.velocity_n, state.unseen_velocity);
    // means of all points: those of the seen and the unseen ones mix the hats
    // with the shape functions
    if (velocity.n_blocks() == 2)
      for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
        for (unsigned int c = 0; c < dim; ++c)
          if (const double unseen = state.unseen(node, c); unseen != 0.)
            {
              double &v = velocity.block(0).local_element(dim * node + c),
                     &w = velocity.block(1).local_element(dim * node + c);
              v = w = (state.seen_mass(node, c) * v + unseen * w) /
                      state.mass.local_element(node);
            }
    mass.add_right_hand_side(PointColumn::velocity, sum);
    mass.solve(velocity, sum);
    state.velocity_n = velocity.block(0);
    state.velocity_n.update_ghost_values();
    if (velocity.n_blocks() == 2)
      {
        state.unseen_velocity = velocity.block(1);
        state.unseen_velocity.update_ghost_values();
      }
    if (state.acceleration_n.size() == 0)
      return;
    const Vector none;
    Field        acceleration_sum =
            MassMatrix<dim>::field(lumped.acceleration_n, none),
          acceleration = MassMatrix<dim>::field(state.acceleration_n, none);
    mass.add_right_hand_side(PointColumn::acceleration, acceleration_sum);
    mass.solve(acceleration, acceleration_sum);
    state.acceleration_n = acceleration.block(0);
    state.acceleration_n.update_ghost_values();
  }



  template <int dim>
  void
  Transfer<dim>::expand_series(const PointCloud<dim> &points,
                               GridState<dim>        &state) const
  {
    const MassMatrix<dim> mass(
      points, fill, materials, /*ghost_penalty=*/false, /*lumped=*/nullptr);
    auto velocity =
      MassMatrix<dim>::field(state.velocity_n, state.unseen_velocity);
    auto momentum = velocity;
    momentum      = 0.;
    mass.add_right_hand_side(PointColumn::velocity, momentum);
    mass.expand(velocity,
                momentum,
                masses_of_components(occupancy, state),
                parameters.order - 1);
    velocity.update_ghost_values();
    const bool replaces = method.update == VelocityUpdate::fmpm;
    (replaces ? state.velocity_n : state.velocity_series) = velocity.block(0);
    if (velocity.n_blocks() == 2)
      (replaces ? state.unseen_velocity : state.unseen_series) =
        velocity.block(1);
  }

  template void
  Transfer<2>::find_closest(const PointCloud<2> &, GridState<2> &) const;
  template void
  Transfer<3>::find_closest(const PointCloud<3> &, GridState<3> &) const;
  template void
  Transfer<2>::expand_series(const PointCloud<2> &, GridState<2> &) const;
  template void
  Transfer<3>::expand_series(const PointCloud<3> &, GridState<3> &) const;
} // namespace seiche
