// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/assembler.h>
#include <seiche/utilities/injected_fault.h>

#include <limits>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  Assembler<dim>::Assembler(const Formulation<dim> &equations,
                            CellMaterials<dim>     &cell_materials,
                            const BodyForce<dim>   &force,
                            const Quadrature<dim>  &rule,
                            const NodePattern<dim> &pattern,
                            TimerTree              &timer_tree)
    : formulation(equations)
    , materials(cell_materials)
    , quadrature(rule)
    , fill(pattern.fill)
    , occupancy(pattern.occupancy)
    , body_force(force)
    , timer(timer_tree)
    , weak_form(formulation.step.get())
    , needs_start_speed(formulation.has_pressure() &&
                        !formulation.subscales->tau_is_uniform)
    , walls_may_be_left(formulation.has_pressure() &&
                        any_may_be_left(occupancy.locator.solids))
    , ghost_penalty(pattern)
  {}

  template <int dim>
  void
  Assembler<dim>::begin(const WeakForm<dim>    &form,
                        const StepCoefficients &coefficients,
                        const GridState<dim>   &state,
                        const Vector           &acceleration_offset,
                        const Vector           &velocity_offset)
  {
    weak_form      = &form;
    step           = coefficients;
    time           = state.time;
    inertia_offset = &acceleration_offset;
    rate_offset    = &velocity_offset;
    projection     = nullptr;
    if (form.is_viscous)
      materials.update_viscosities(state.velocity_start);
    else
      materials.neglect_viscosities();
    assemble_ghost_penalty();
  }

  template <int dim>
  void
  Assembler<dim>::set_projection(const BlockVector *projected)
  {
    projection = projected;
  }

  template <int dim>
  template <typename Action>
  void
  Assembler<dim>::for_each_cell(const Action &action) const
  {
    for (const unsigned int cell : occupancy.cells.occupied())
      with_degree(occupancy.degree(cell),
                  [&](const auto degree) { action(cell, degree); });
  }

  template <int dim>
  void
  Assembler<dim>::assemble_ghost_penalty()
  {
    const TimerTree::Scope scope(timer, "ghost penalty");
    ghost_penalty.clear();
    if (weak_form->acts_on_faces)
      ghost_penalty.assemble(fill.ghost_faces(),
                             [this](const GhostFace   &face,
                                    const double       h,
                                    const unsigned int degree) {
                               return weak_form->ghost_coefficients(
                                 {h,
                                  materials.mean(face.lower, face.upper)
                                    .mass(face.fluid * std::pow(h, 3)),
                                  face.fluid * ghost_tau(face, degree),
                                  face.fragment});
                             });
  }

  template <int dim>
  const ClosedChambers<dim> *
  Assembler<dim>::closed_chambers() const
  {
    const bool has_level = !formulation.has_pressure() ||
                           !formulation.volume_law.is_incompressible() ||
                           !fill.closed_chambers().any();
    return has_level ? nullptr : &fill.closed_chambers();
  }

  template <int dim>
  void
  Assembler<dim>::residual(GridState<dim> &state, BlockVector &residual)
  {
    const TimerTree::Scope scope(timer, "residual");
    sum_residual(state, residual, [](const unsigned int, const auto &) {
      return true;
    });
    if (const auto *closed = closed_chambers())
      closed->balance_rows(residual.block(1), state.mass);
    if (is_injected(Fault::residual) && residual.block(0).locally_owned_size())
      residual.block(0).local_element(0) =
        std::numeric_limits<double>::quiet_NaN();
  }

  template <int dim>
  void
  Assembler<dim>::reactions(GridState<dim> &state)
  {
    const TimerTree::Scope scope(timer, "residual");
    BlockVector            residual(state.solution);
    residual.zero_out_ghost_values();
    sum_residual(state,
                 residual,
                 [this](const unsigned int cell, const auto &unknowns) {
                   return occupancy.mesh_nodes.cut_walls.cuts(cell) ||
                          unknowns.zeros != nullptr ||
                          occupancy.constraints.any_fixed(unknowns) != 0;
                 });
  }

  template <int dim>
  template <typename IsWanted>
  void
  Assembler<dim>::sum_residual(GridState<dim> &state,
                               BlockVector    &residual,
                               const IsWanted &is_wanted)
  {
    residual       = 0.;
    state.reaction = 0.; // components may have been released
    state.reaction.zero_out_ghost_values();
    state.solid_reactions.clear();
    for_each_cell([&](const unsigned int cell, const auto degree) {
      const auto nodes = occupancy.template unknowns<degree>(cell);
      if (!is_wanted(cell, nodes))
        return;
      CellData<dim, degree> &data = this->template gather<degree>(cell, state);
      weak_form->residual(data);
      state.solid_reactions.insert(state.solid_reactions.end(),
                                   data.solid_reactions.begin(),
                                   data.solid_reactions.end());
      nodes.add_to_zeros(data.residual_u, state.reaction.begin());
      nodes.add(data.residual_u, residual.block(0).begin());
      if (formulation.has_pressure())
        nodes.add(data.residual_p, residual.block(1).begin());
    });
    ghost_penalty.add_residual(
      step, *inertia_offset, *rate_offset, state.solution, residual);
    residual.compress(VectorOperation::add);
    state.reaction.compress(VectorOperation::add);
    occupancy.constraints.for_each_fixed([&](const auto &direction) {
      direction.set(state.reaction,
                    direction.of(state.reaction) +
                      direction.of(residual.block(0)));
      direction.set(residual.block(0), 0.);
    });
  }

  template <int dim>
  void
  Assembler<dim>::residual_moments(const GridState<dim> &state,
                                   BlockVector          &sums)
  {
    sums = 0.;
    for (const unsigned int cell : occupancy.cells.occupied())
      with_degree(occupancy.degree(cell), [&](const auto degree) {
        auto &data = this->template gather<degree>(cell, state);
        formulation.residual_moments->residual(data);
        const auto nodes = occupancy.template unknowns<degree>(cell);
        nodes.add_to_nodes(data.residual_u, sums.block(0).begin());
        nodes.add(data.residual_p, sums.block(1).begin());
      });
    sums.compress(VectorOperation::add);
  }

  template <int dim>
  void
  Assembler<dim>::tangent(const GridState<dim> &state, BlockMatrix<dim> &matrix)
  {
    const TimerTree::Scope scope(timer, "tangent");
    matrix.set_zero();
    add_tangent(state, matrix);
    matrix.compress();
  }

  template <int dim>
  void
  Assembler<dim>::add_tangent(const GridState<dim> &state,
                              BlockMatrix<dim>     &matrix)
  {
    // where matrices of equal cells are equal those of the last one stay in
    // the workspace
    const bool                                uniform = tangents_are_uniform();
    std::array<CellGeometry<dim>, max_degree> last_geometries;
    const auto add_cell = [&](const unsigned int cell, const auto degree) {
      CellData<dim, degree> &data = std::get<degree - 1>(workspace);
      CellGeometry<dim>     &last = last_geometries[degree - 1];
      const auto unknowns         = occupancy.template unknowns<degree>(cell);
      const bool condensed =
        unknowns.matrix != nullptr || unknowns.zeros != nullptr;
      const bool oblique = occupancy.constraints.any_oblique(unknowns);
      const bool reusable =
        uniform && !condensed && !oblique && fill.is_full(cell);
      matrix.prefetch_cell(cell);
      if (!reusable ||
          !occupancy.locator.cells.geometry(cell).is_congruent(last))
        {
          this->template gather<degree>(cell, state);
          weak_form->tangent(data);
          if (condensed)
            data.condense(unknowns);
          if (oblique)
            data.project(unknowns, occupancy.constraints);
          last = reusable ? data.geometry : CellGeometry<dim>();
        }
      matrix.add_cell(cell, data);
    };
    for_each_cell(add_cell);
    ghost_penalty.add_tangent(step, matrix);
  }

  template <int dim>
  bool
  Assembler<dim>::tangents_are_uniform() const
  {
    return weak_form == formulation.projection.get() && !needs_start_speed &&
           formulation.volume_law.is_incompressible() &&
           !materials.are_several();
  }

  template <int dim>
  double
  Assembler<dim>::body_force_scale() const
  {
    if (!weak_form->has_body_force)
      return 0.;
    if (body_force.is_constant())
      return body_force.constant_value().norm();
    // not of all nodes: how many are numbered around the fluid depends on the
    // ranks and on earlier steps
    std::vector<char> has_fluid(occupancy.nodes.n_local(), 0);
    double            largest = 0.;
    const double      t       = time + step.theta * step.dt;
    for (const unsigned int cell : occupancy.cells.occupied())
      for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
        if (const unsigned int node = occupancy.nodes.of_cell(cell)[a];
            !has_fluid[node])
          {
            has_fluid[node] = 1;
            largest         = std::max(
              largest,
              body_force.value(occupancy.nodes.position(node), t).norm());
          }
    return Utilities::MPI::max(
      largest, occupancy.nodes.partitioner()->get_mpi_communicator());
  }

  template <int dim>
  double
  Assembler<dim>::ghost_tau(const GhostFace   &face,
                            const unsigned int degree) const
  {
    if (!formulation.has_pressure())
      return 0.;
    const double size = // of the smaller cell, the face belongs to it
      std::min(occupancy.locator.cells.geometry(face.lower).size(),
               occupancy.locator.cells.geometry(face.upper).size());
    return 1. / formulation.subscales->inverse_transient_tau(
                  tau_arguments(size,
                                degree,
                                materials.mean(face.lower, face.upper),
                                /*force=*/0.));
  }

  template class Assembler<2>;
  template class Assembler<3>;
} // namespace seiche
