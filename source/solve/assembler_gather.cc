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
    const auto            &locator = occupancy.locator;
    data.coefficients              = step;
    if (fill.is_cut(cell)) // there impacts gain energy by it
      data.coefficients.jerk_constraint = 0.;
    data.extent         = locator.extent(cell);
    data.size           = dim == 2 ? std::sqrt(locator.measure(cell)) :
                                     std::cbrt(locator.measure(cell));
    data.lumped         = formulation.lumps_inertia;
    data.density        = materials.density(cell);
    data.viscosity      = viscosity(cell);
    data.extent_inertia = free_surface.point_inertia * data.density *
                          fill.extent_moment(cell) * locator.measure(cell);
    quadrature.get(cell, data.quadrature);

    const auto nodes = occupancy.template unknowns<degree>(cell);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const unsigned int dof  = dim * nodes[a] + i;
          const double       u    = state.displacement().local_element(dof);
          data.displacement[i][a] = u;
          data.acceleration[i][a] =
            step.inertia * u + inertia_offset->local_element(dof);
          data.rate_velocity[i][a] =
            step.rate * u + rate_offset->local_element(dof);
        }
    for (unsigned int i = 0; i < dim; ++i)
      {
        nodes.expand(data.displacement[i]);
        nodes.expand(data.acceleration[i]);
        nodes.expand(data.rate_velocity[i]);
      }
    data.turns = step.body_force && body_force.tank.any();
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
      {
        for (unsigned int a = 0; a < n_nodes; ++a)
          data.pressure[a] = state.pressure().local_element(nodes[a]);
        nodes.expand(data.pressure);
      }
    data.orthogonal = projection != nullptr;
    if (data.orthogonal)
      gather_projection<degree>(cell);

    data.body_force_varies = step.body_force && !body_force.is_constant();
    if (!data.body_force_varies)
      data.constant_body_force =
        step.body_force ? body_force.constant_value() : Tensor<1, dim>();
    if (data.body_force_varies || !tau_is_uniform)
      gather_start_velocity<degree>(cell, state);
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
    const auto             nodes   = occupancy.template unknowns<degree>(cell);
    double                 start_velocity[dim][n_nodes];
    Tensor<1, dim>         mean_velocity;
    for (unsigned int i = 0; i < dim; ++i)
      {
        for (unsigned int a = 0; a < n_nodes; ++a)
          start_velocity[i][a] =
            state.velocity_start.local_element(dim * nodes[a] + i);
        nodes.expand(start_velocity[i]);
        for (unsigned int a = 0; a < n_nodes; ++a)
          mean_velocity[i] += start_velocity[i][a] / n_nodes;
      }
    data.start_speed = mean_velocity.norm();
    if (data.body_force_varies)
      gather_body_force<degree>(cell, start_velocity);
  }

  template <int dim>
  template <int degree>
  void
  Assembler<dim>::gather_projection(const unsigned int cell)
  {
    CellData<dim, degree> &data  = std::get<degree - 1>(workspace);
    const auto             nodes = occupancy.template unknowns<degree>(cell);
    for (unsigned int a = 0; a < data.n_nodes; ++a)
      {
        for (unsigned int i = 0; i < dim; ++i)
          data.projected_momentum[i][a] =
            projection->block(0).local_element(dim * nodes[a] + i);
        data.projected_constraint[a] =
          projection->block(1).local_element(nodes[a]);
      }
    for (unsigned int i = 0; i < dim; ++i)
      nodes.expand(data.projected_momentum[i]);
    nodes.expand(data.projected_constraint);
  }

  template <int dim>
  template <int degree>
  void
  Assembler<dim>::gather_body_force(
    const unsigned int cell,
    const double (&start_velocity)[dim][CellData<dim, degree>::n_nodes])
  {
    constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    CellData<dim, degree> &data    = std::get<degree - 1>(workspace);
    for (auto &component : data.body_force)
      component.assign(data.quadrature.size + n_lanes_of_register, 0.);
    double N[n_nodes];
    for (unsigned int q = 0; q < data.quadrature.size; ++q)
      {
        const Point<dim> unit = data.quadrature.point(q);
        TensorShape<dim, degree>::values(unit, N);
        Point<dim> x = occupancy.locator.lower_corner(cell);
        for (unsigned int d = 0; d < dim; ++d)
          {
            x[d] += unit[d] * data.extent[d];
            for (unsigned int a = 0; a < n_nodes; ++a)
              x[d] += step.theta * step.dt * N[a] * start_velocity[d][a];
          }
        const Tensor<1, dim> force =
          body_force.value(x, time + step.theta * step.dt);
        for (unsigned int d = 0; d < dim; ++d)
          data.body_force[d][q] = force[d];
      }
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
