// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/assembler.h>

// The part of Assembler that collects what a weak form reads in a cell.
namespace seiche
{
  using namespace dealii;

  template <int dim>
  template <int degree>
  CellData<dim, degree> &
  Assembler<dim>::gather(const unsigned int cell, const GridState<dim> &state)
  {
    constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    CellData<dim, degree> &data    = std::get<degree - 1>(workspace);
    data.coefficients              = step;
    data.geometry                  = occupancy.locator.cells.geometry(cell);
    // few points alone in a cell: a consistent mass lets its nodes run away
    data.lumped = formulation.lumps_inertia || fill.is_spray(cell);
    data.is_cut = fill.is_cut(cell);
    data.fluid  = materials.mean(cell);
    data.extent_inertia =
      data.fluid.mass(fill.extent_moment(cell)) * data.geometry.measure;
    quadrature.get(cell, data.quadrature);
    const auto &walls = occupancy.mesh_nodes.cut_walls;
    data.wall         = fill.wall(cell);
    data.wall_is_dry  = data.wall == nullptr && walls.cuts(cell);
    if (data.wall_is_dry)
      data.wall = &walls.whole(cell).wall;
    data.solids                       = &state.solids;
    data.wall_material                = &materials.of_cell(cell);
    const ClosedChambers<dim> *closed = closed_chambers();
    data.wall_may_be_left = data.wall != nullptr && walls_may_be_left &&
                            (closed == nullptr || !closed->holds_cell(cell));
    data.solid_reactions.clear();

    const auto nodes = occupancy.template unknowns<degree>(cell);
    nodes.read(state.displacement().begin(), data.displacement);
    nodes.read(inertia_offset->begin(), data.acceleration);
    nodes.read(rate_offset->begin(), data.rate_velocity);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          data.acceleration[i][a] += step.inertia * data.displacement[i][a];
          data.rate_velocity[i][a] += step.rate * data.displacement[i][a];
        }
    data.turns = weak_form->has_body_force && body_force.tank.any();
    if (data.turns)
      {
        data.coriolis =
          body_force.tank.at(time + step.theta * step.dt).coriolis;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int a = 0; a < n_nodes; ++a)
              data.acceleration[i][a] +=
                data.coriolis[i][k] * data.rate_velocity[k][a];
      }
    if (state.has_pressure())
      nodes.read(state.pressure().begin(), data.pressure);
    if (data.wall_may_be_left)
      nodes.read(state.pressure_guess.begin(), data.old_pressure);
    data.orthogonal = projection != nullptr;
    if (data.orthogonal)
      gather_projection<degree>(cell);

    data.body_force_varies =
      weak_form->has_body_force && !body_force.is_constant();
    if (!data.body_force_varies)
      data.constant_body_force = weak_form->has_body_force ?
                                   body_force.constant_value() :
                                   Tensor<1, dim>();
    if (data.body_force_varies || needs_start_speed)
      gather_start_velocity<degree>(cell, state);
    formulation.set_subscales(data);
    return data;
  }

  template <int dim>
  template <int degree>
  void
  Assembler<dim>::gather_start_velocity(const unsigned int    cell,
                                        const GridState<dim> &state)
  {
    constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    CellData<dim, degree> &data    = std::get<degree - 1>(workspace);
    double                 start_velocity[dim][n_nodes];
    occupancy.template unknowns<degree>(cell).read(state.velocity_start.begin(),
                                                   start_velocity);
    Tensor<1, dim> mean_velocity;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < n_nodes; ++a)
        mean_velocity[i] += start_velocity[i][a] / n_nodes;
    data.start_speed = mean_velocity.norm();
    if (data.body_force_varies)
      gather_body_force<degree>(start_velocity);
  }

  template <int dim>
  template <int degree>
  void
  Assembler<dim>::gather_projection(const unsigned int cell)
  {
    CellData<dim, degree> &data  = std::get<degree - 1>(workspace);
    const auto             nodes = occupancy.template unknowns<degree>(cell);
    nodes.read_nodes(projection->block(0).begin(), data.projected_momentum);
    nodes.read(projection->block(1).begin(), data.projected_constraint);
  }

  template <int dim>
  template <int degree>
  void
  Assembler<dim>::gather_body_force(
    const double (&start_velocity)[dim][CellData<dim, degree>::n_nodes])
  {
    CellData<dim, degree> &data = std::get<degree - 1>(workspace);
    for (auto &component : data.body_force)
      component.assign(data.quadrature.size + n_lanes_of_register, 0.);
    PointBatch<dim, degree> batch;
    const double            delay = step.theta * step.dt;
    data.quadrature.for_each_batch(
      [&](const unsigned int q, const unsigned int n, const Material &) {
        const auto unit = data.quadrature.template point<Lanes>(q);
        batch.reinit_values(unit);
        const Point<dim, Lanes> place =
          data.geometry.to_real(unit) + delay * batch.value(start_velocity);
        for (unsigned int l = 0; l < n; ++l)
          {
            Point<dim> x;
            for (unsigned int d = 0; d < dim; ++d)
              x[d] = place[d][l];
            const Tensor<1, dim> force = body_force.value(x, time + delay);
            for (unsigned int d = 0; d < dim; ++d)
              data.body_force[d][q + l] = force[d];
          }
      });
  }

#define INSTANTIATE(dim, degree)                                  \
  template CellData<dim, degree> &Assembler<dim>::gather<degree>( \
    const unsigned int, const GridState<dim> &);
  INSTANTIATE(2, 1)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 1)
  INSTANTIATE(3, 2)
#undef INSTANTIATE
} // namespace seiche
