// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_term_list_h
#define seiche_formulation_term_list_h

#include <seiche/formulation/term.h>

#include <memory>
#include <tuple>

namespace seiche
{
  /// The weak form of some terms; they are fused: one loop over the points.
  template <int dim, typename... Terms>
  class TermList : public WeakForm<dim>
  {
  public:
    explicit TermList(const Terms &...list)
      : WeakForm<dim>((Terms::has_body_force || ...),
                      (Terms::is_viscous || ...),
                      (list.acts_on_faces() || ...))
      , terms(list...)
    {}

    void
    residual(CellData<dim, 1> &cell) const override
    {
      sum_residual(cell);
    }
    void
    residual(CellData<dim, 2> &cell) const override
    {
      sum_residual(cell);
    }
    void
    tangent(CellData<dim, 1> &cell) const override
    {
      sum_tangent(cell);
    }
    void
    tangent(CellData<dim, 2> &cell) const override
    {
      sum_tangent(cell);
    }

    GhostCoefficients
    ghost_coefficients(const GhostFaceData &face) const override
    {
      GhostCoefficients sums;
      for_each([&](const auto &term) { term.add_ghost(face, sums); });
      return sums;
    }

  private:
    static constexpr bool has_pressure = (Terms::has_pressure || ...);

    template <typename Action>
    void
    for_each(const Action &action) const
    {
      std::apply([&](const auto &...term) { (action(term), ...); }, terms);
    }

    /// action(state) at each batch of points.
    template <int degree, typename Action>
    void
    for_each_batch(const CellData<dim, degree> &cell,
                   const Action                &action) const
    {
      bool needs_gradient = false;
      for_each([&](const auto &term) {
        needs_gradient |= term.needs_velocity_gradient(cell);
      });
      PointKinematics<dim, degree> point;
      cell.quadrature.for_each_batch([&](const unsigned int q,
                                         const unsigned int n_points,
                                         const Material    &material) {
        point.evaluate(cell, q);
        Lanes volume_ratio = 1.;
        for_each([&](const auto &term) {
          volume_ratio *= term.volume_ratio(cell, q);
        });
        PointState<dim, degree> state(
          cell, point, q, n_points, material, volume_ratio);
        state.acceleration = point.value(cell.acceleration);
        if constexpr (has_pressure)
          state.evaluate_pressure();
        if (needs_gradient)
          state.velocity_gradient =
            point.gradient(cell.rate_velocity, point.gradient_t);
        for_each([&](const auto &term) { term.evaluate(state); });
        action(state);
      });
    }

    // All calls are inlined: what terms leave at the points stays in registers.
    template <int degree>
    [[gnu::flatten]] void
    sum_residual(CellData<dim, degree> &cell) const
    {
      NodalSums<dim, degree> sums;
      for_each_batch(cell, [&](const PointState<dim, degree> &state) {
        PointForces<dim> forces;
        for_each([&](const auto &term) { term.add_residual(state, forces); });
        sums.template add<has_pressure>(state.point, forces);
        for_each(
          [&](const auto &term) { term.add_nodal_residual(state, sums); });
      });
      sums.template store<has_pressure>(cell);
      for_each([&](const auto &term) { term.add_cell_residual(cell); });
    }

    template <int degree>
    [[gnu::flatten]] void
    sum_tangent(CellData<dim, degree> &cell) const
    {
      cell.clear();
      for_each_batch(cell, [&](PointState<dim, degree> &state) {
        for_each([&](const auto &term) { term.linearize(state); });
        TangentSums<dim, degree> sums;
        for_each(
          [&](const auto &term) { term.add_tangent(state, sums, cell); });
        sums.add_to_displacement(state, cell);
        if constexpr (has_pressure)
          sums.add_to_pressure(state, cell);
      });
      for_each([&](const auto &term) { term.add_cell_tangent(cell); });
    }

    const std::tuple<Terms...> terms;
  };

  template <int dim, typename... Terms>
  std::shared_ptr<const WeakForm<dim>>
  make_weak_form(const Terms &...terms)
  {
    return std::make_shared<const TermList<dim, Terms...>>(terms...);
  }
} // namespace seiche

#endif
