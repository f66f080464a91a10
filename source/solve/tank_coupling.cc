// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/tank_coupling.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  TankCoupling<dim>::TankCoupling(TankMotion<dim>      &motion,
                                  const Occupancy<dim> &grid_occupancy,
                                  const double          of_balance)
    : BodyCoupling<dim>({&motion.motion_to_move()}, grid_occupancy, of_balance)
    , tank(motion)
  {}

  template <int dim>
  std::vector<typename TankCoupling<dim>::AddedInertia>
  TankCoupling<dim>::added_inertias(const GridState<dim> &state) const
  {
    std::vector<double> sums(directions.size(), 0.);
    for (unsigned int i = 0; i < sums.size(); ++i)
      for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
        {
          const BodyDirection<dim> &direction = directions[i].way;
          Tensor<1, dim> arm = occupancy.nodes.position(node) - tank.centre();
          if (dim == 3)
            arm[direction.axis()] = 0.;
          sums[i] += state.mass.local_element(node) *
                     (direction.is_angle() ? arm.norm_square() : 1.);
        }
    Utilities::MPI::sum(sums, state.mass.get_mpi_communicator(), sums);
    const double              mass = state.mass.l1_norm();
    std::vector<AddedInertia> result;
    for (const double sum : sums)
      result.push_back({sum, mass});
    return result;
  }

  template <int dim>
  std::vector<double>
  TankCoupling<dim>::fluid_loads(const GridState<dim> &state) const
  {
    std::vector<double> loads(directions.size(), 0.);
    const auto          R = tank.at(state.time + step.theta * step.dt).rotation;
    // @p force: of the walls on the fluid
    const auto subtract_at = [&](const Point<dim>     &place,
                                 const Tensor<1, dim> &force) {
      const auto turn = moment(place - tank.centre(), force);
      for (unsigned int i = 0; i < loads.size(); ++i)
        {
          const BodyDirection<dim> &direction = directions[i].way;
          loads[i] -= direction.is_angle() ? turn[direction.number - dim] :
                                             R[direction.number] * force;
        }
    };
    const auto subtract = [&](const unsigned int    node,
                              const Tensor<1, dim> &force) {
      Point<dim> place = occupancy.nodes.position(node);
      for (unsigned int c = 0; c < dim; ++c)
        place[c] +=
          step.theta * state.displacement().local_element(dim * node + c);
      subtract_at(place, force);
    };
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      {
        Tensor<1, dim> force;
        for (unsigned int c = 0; c < dim; ++c)
          force[c] = state.reaction.local_element(dim * node + c) +
                     state.start_reaction.local_element(dim * node + c);
        if (force.norm_square() > 0.)
          subtract(node, force);
      }
    for (const auto &drag : state.drags)
      subtract(drag.node, drag.force);
    state.for_each_solid_reaction([&](const auto &reaction) {
      subtract_at(reaction.place, reaction.force);
    });
    Utilities::MPI::sum(loads, state.mass.get_mpi_communicator(), loads);
    return loads;
  }

  template class TankCoupling<2>;
  template class TankCoupling<3>;
} // namespace seiche
