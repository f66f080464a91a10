// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/assembler.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  Assembler<dim>::Assembler(const Formulation<dim>      &weak_form,
                            const Quadrature<dim>       &rule,
                            const Fill<dim>             &grid_fill,
                            const BodyForce<dim>        &force,
                            const FreeSurfaceParameters &surface,
                            TimerTree                   &timer_tree)
    : formulation(weak_form)
    , free_surface(surface)
    , quadrature(rule)
    , fill(grid_fill)
    , occupancy(grid_fill.occupancy)
    , body_force(force)
    , timer(timer_tree)
  {
    data.body_force_varies = !body_force.is_constant();
    if (!data.body_force_varies)
      data.constant_body_force = body_force.constant_value();
  }

  template <int dim>
  void
  Assembler<dim>::begin(const StepCoefficients &coefficients,
                        const double            start_time,
                        const Vector           &acceleration_offset,
                        const Vector           &velocity_offset)
  {
    data.coefficients = coefficients;
    time              = start_time;
    inertia_offset    = &acceleration_offset;
    rate_offset       = &velocity_offset;
    if (!coefficients.body_force)
      data.constant_body_force = 0.;
    else if (!data.body_force_varies)
      data.constant_body_force = body_force.constant_value();
  }

  template <int dim>
  Tau
  Assembler<dim>::reference_tau(const double size) const
  {
    return formulation.stabilization.evaluate(data.coefficients,
                                              formulation.material.density,
                                              formulation.material.viscosity(
                                                data.coefficients),
                                              size,
                                              /*degree=*/1,
                                              /*speed=*/0.);
  }

  template <int dim>
  void
  Assembler<dim>::gather(const unsigned int cell, const GridState<dim> &state)
  {
    constexpr unsigned int n_nodes = CellData<dim>::n_nodes;
    const auto            &locator = occupancy.locator;
    data.extent                    = locator.extent(cell);
    data.size                      = std::pow(locator.measure(cell), 1. / dim);
    data.sliver = free_surface.sliver_treatment && fill.is_sliver(cell);
    quadrature.get(cell, data.quadrature);

    const StepCoefficients &c     = data.coefficients;
    const unsigned int     *nodes = occupancy.cell_nodes(cell);
    double                  start_velocity[dim][n_nodes];
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const unsigned int dof  = dim * nodes[a] + i;
          const double       u    = state.displacement().local_element(dof);
          data.displacement[i][a] = u;
          data.acceleration[i][a] =
            c.inertia * u + inertia_offset->local_element(dof);
          data.rate_velocity[i][a] =
            c.rate * u + rate_offset->local_element(dof);
          start_velocity[i][a] = state.velocity_start.local_element(dof);
        }
    Tensor<1, dim> mean_velocity;
    for (unsigned int i = 0; i < dim; ++i)
      {
        occupancy.expand(cell, data.displacement[i]);
        occupancy.expand(cell, data.acceleration[i]);
        occupancy.expand(cell, data.rate_velocity[i]);
        occupancy.expand(cell, start_velocity[i]);
        for (unsigned int a = 0; a < n_nodes; ++a)
          mean_velocity[i] += start_velocity[i][a] / n_nodes;
      }
    data.start_speed = mean_velocity.norm();
    if (state.has_pressure())
      {
        for (unsigned int a = 0; a < n_nodes; ++a)
          data.pressure[a] = state.pressure().local_element(nodes[a]);
        occupancy.expand(cell, data.pressure);
      }

    if (data.body_force_varies)
      {
        // at the place that v_0 predicts: second order, and the tangent does
        // not need the gradient of the expression
        data.body_force.assign(data.quadrature.size, Tensor<1, dim>());
        double N[n_nodes];
        if (c.body_force)
          for (unsigned int q = 0; q < data.quadrature.size; ++q)
            {
              const Point<dim> unit = data.quadrature.point(q);
              LinearShape<dim>::values(unit, N);
              Point<dim> x = locator.lower_corner(cell);
              for (unsigned int d = 0; d < dim; ++d)
                {
                  x[d] += unit[d] * data.extent[d];
                  for (unsigned int a = 0; a < n_nodes; ++a)
                    x[d] += c.theta * c.dt * N[a] * start_velocity[d][a];
                }
              data.body_force[q] = body_force.value(x, time + c.theta * c.dt);
            }
      }
  }

  template <int dim>
  template <typename Function>
  void
  Assembler<dim>::for_each_ghost_face(const Function &f)
  {
    if (!free_surface.has_ghost_penalty())
      return;
    GhostFaceMatrix<dim> matrix;
    for (const GhostFace &face : fill.ghost_faces())
      {
        matrix.evaluate(face, occupancy);
        const double size = // of the smaller cell, which the face belongs to
          std::pow(std::min(occupancy.locator.measure(face.lower),
                            occupancy.locator.measure(face.upper)),
                   1. / dim);
        f(matrix,
          ghost_coefficients(free_surface,
                             face,
                             matrix.h,
                             formulation.material.density,
                             ghost_tau(size),
                             data.coefficients.damping));
      }
  }

  template <int dim>
  void
  Assembler<dim>::residual(GridState<dim> &state, BlockVector &residual)
  {
    const TimerTree::Scope scope(timer, "residual");
    constexpr unsigned int n_nodes = CellData<dim>::n_nodes;
    residual                       = 0.;
    const bool mixed               = formulation.has_pressure();
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        gather(cell, state);
        formulation.residual(data);
        const unsigned int *nodes = occupancy.cell_nodes(cell);
        for (unsigned int i = 0; i < dim; ++i)
          occupancy.condense(cell, data.residual_u[i]);
        if (mixed)
          occupancy.condense(cell, data.residual_p);
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            for (unsigned int i = 0; i < dim; ++i)
              residual.block(0).local_element(dim * nodes[a] + i) +=
                data.residual_u[i][a];
            if (mixed)
              residual.block(1).local_element(nodes[a]) += data.residual_p[a];
          }
      }
    const StepCoefficients &c = data.coefficients;
    for_each_ghost_face([&](const GhostFaceMatrix<dim> &face,
                            const GhostCoefficients    &coefficient) {
      const unsigned int n = face.n_nodes;
      for (unsigned int i = 0; i < dim; ++i)
        {
          double jump[GhostFaceMatrix<dim>::max_nodes];
          for (unsigned int b = 0; b < n; ++b)
            {
              const unsigned int dof = dim * face.nodes[b] + i;
              const double       u   = state.displacement().local_element(dof);
              jump[b]                = coefficient.acceleration *
                          (c.inertia * u + inertia_offset->local_element(dof)) +
                        coefficient.velocity *
                          (c.rate * u + rate_offset->local_element(dof));
            }
          for (unsigned int a = 0; a < n; ++a)
            {
              double sum = 0.;
              for (unsigned int b = 0; b < n; ++b)
                sum += face.B[a][b] * jump[b];
              residual.block(0).local_element(dim * face.nodes[a] + i) += sum;
            }
        }
      if (mixed)
        for (unsigned int a = 0; a < n; ++a)
          {
            double sum = 0.;
            for (unsigned int b = 0; b < n; ++b)
              sum +=
                face.B[a][b] * state.pressure().local_element(face.nodes[b]);
            residual.block(1).local_element(face.nodes[a]) +=
              coefficient.pressure * sum;
          }
    });
    residual.compress(VectorOperation::add);

    for (unsigned int node = 0; node < occupancy.n_own_nodes(); ++node)
      if (const unsigned int fixed = occupancy.fixed_components(node))
        for (unsigned int i = 0; i < dim; ++i)
          if (fixed & (1u << i))
            {
              double &value = residual.block(0).local_element(dim * node + i);
              state.reaction.local_element(dim * node + i) = value;
              value                                        = 0.;
            }
  }

  template <int dim>
  void
  Assembler<dim>::tangent(const GridState<dim> &state, BlockMatrix<dim> &matrix)
  {
    const TimerTree::Scope scope(timer, "tangent");
    matrix.set_zero();
    // The matrices of full cells at rest are equal for equal cells: those of
    // the last one stay in the workspace.
    const bool     at_rest = is_at_rest(state);
    Tensor<1, dim> last_extent;
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        const bool hanging = occupancy.hanging().has_matrix(cell);
        const bool reusable =
          at_rest && !hanging && fill.gauss_weight(cell) == 1.;
        if (!reusable || occupancy.locator.extent(cell) != last_extent)
          {
            gather(cell, state);
            formulation.tangent(data);
            if (hanging)
              condense_tangent(cell);
            last_extent = reusable ? data.extent : Tensor<1, dim>();
          }
        matrix.add_cell(cell, data);
      }
    const StepCoefficients &c = data.coefficients;
    for_each_ghost_face([&](const GhostFaceMatrix<dim> &face,
                            const GhostCoefficients    &coefficient) {
      matrix.add_face(face,
                      coefficient.acceleration * c.inertia +
                        coefficient.velocity * c.rate,
                      coefficient.pressure);
    });
    matrix.compress();
  }

  template <int dim>
  bool
  Assembler<dim>::is_at_rest(const GridState<dim> &state) const
  {
    const StepCoefficients &c = data.coefficients;
    const Vector           &u = state.displacement();
    return formulation.has_pressure() && c.theta == 0. && !c.viscous &&
           c.volume_recovery == 0. &&
           formulation.stabilization.tau_is_uniform() &&
           std::all_of(u.begin(), u.end(), [](const double value) {
             return value == 0.;
           });
  }

  template <int dim>
  void
  Assembler<dim>::condense_tangent(const unsigned int cell)
  {
    const HangingNodes<dim> &hanging = occupancy.hanging();
    for (unsigned int i = 0; i < dim; ++i)
      {
        for (unsigned int j = 0; j < dim; ++j)
          hanging.condense_matrix(cell, data.uu[i][j]);
        if (formulation.has_pressure())
          {
            hanging.condense_matrix(cell, data.up[i]);
            hanging.condense_matrix(cell, data.pu[i]);
          }
      }
    if (formulation.has_pressure())
      hanging.condense_matrix(cell, data.pp);
  }

  template <int dim>
  double
  Assembler<dim>::body_force_scale() const
  {
    if (!data.coefficients.body_force)
      return 0.;
    if (!data.body_force_varies)
      return data.constant_body_force.norm();
    double       largest = 0.;
    const double t = time + data.coefficients.theta * data.coefficients.dt;
    for (unsigned int i = 0; i < occupancy.n_own_nodes(); ++i)
      largest =
        std::max(largest,
                 body_force.value(occupancy.node_position(i), t).norm());
    return Utilities::MPI::max(
      largest, occupancy.scalar_partitioner()->get_mpi_communicator());
  }

  template <int dim>
  double
  Assembler<dim>::ghost_tau(const double size) const
  {
    return 1. / formulation.stabilization.inverse_transient_tau(
                  data.coefficients,
                  formulation.material.density,
                  formulation.material.viscosity(data.coefficients),
                  size,
                  /*degree=*/1);
  }

  template class Assembler<2>;
  template class Assembler<3>;
} // namespace seiche
