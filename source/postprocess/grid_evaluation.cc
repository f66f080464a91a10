// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/grid_evaluation.h>
#include <seiche/space/point_batch.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    // |theta grad u| is a few tenths at most, so that the error is far below
    // the accuracy of the fields when the limit is reached
    constexpr unsigned int max_iterations = 8;
    constexpr double       tolerance      = 1e-10; // of a cell edge

    /// @p way in units of the cell
    template <int dim>
    bool
    is_small(const Tensor<1, dim> &way)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(way[d]) > tolerance)
          return false;
      return true;
    }
  } // namespace

  template <int dim>
  double
  level_at(const StepView<dim> &view,
           const unsigned int   cell,
           const Point<dim>    &unit)
  {
    const auto level = view.fill.surface().level_in(cell);
    double     at_vertices[Basis<dim, 1>::n_nodes];
    std::copy(level.begin(), level.end(), at_vertices);
    PointBatch<dim, 1, double> point;
    point.reinit_values(unit);
    return point.value(at_vertices);
  }

  template <int dim>
  GridEvaluation<dim>::GridEvaluation(const StepView<dim> &step)
    : view(step)
    , occupancy(step.occupancy)
    , cell(CellLocator<dim>::invalid)
    , shapes(step.occupancy.nodes_per_cell())
  {}

  template <int dim>
  void
  GridEvaluation<dim>::reinit(const unsigned int new_cell,
                              const Point<dim>  &new_unit)
  {
    cell = new_cell;
    unit = new_unit;
    with_degree(occupancy.fe.degree, [&](const auto degree) {
      PointBatch<dim, degree, double> point;
      point.reinit_values(unit);
      std::copy(std::begin(point.N), std::end(point.N), shapes.begin());
    });
    occupancy.condense(cell, shapes.data());
  }

  template <int dim>
  bool
  GridEvaluation<dim>::find(const Point<dim> &x, const double theta)
  {
    const CellLocator<dim> &locator = occupancy.locator;
    const auto [lower, upper] = locator.lines.domain().get_boundary_points();
    const CellGeometry<dim> domain(lower, upper);

    Point<dim> xi = domain.clamped(locator.periods.wrapped(x));
    cell          = locator.find(xi, cell);
    if (cell == CellLocator<dim>::invalid || !occupancy.cells.is_active(cell))
      return false;
    reinit(cell, locator.cells.geometry(cell).to_unit(xi));
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        const Point<dim> start =
          x - theta * vector_value(view.state.displacement());
        const Point<dim> next = domain.clamped(locator.periods.wrapped(start));
        const unsigned int next_cell = locator.find(next, cell);
        // into an obstacle or beyond what this rank knows: stay
        if (next_cell == CellLocator<dim>::invalid ||
            !occupancy.cells.is_active(next_cell))
          break;
        reinit(next_cell, locator.cells.geometry(next_cell).to_unit(next));
        if (is_small(locator.cells.geometry(cell).to_unit(
              locator.periods.shortest(next - xi))))
          break;
        xi = next;
      }
    return occupancy.cells.is_occupied(cell);
  }

  template <int dim>
  void
  GridEvaluation<dim>::find_in_cell(const unsigned int cell_at_start,
                                    const Point<dim>  &x,
                                    const double       theta)
  {
    const CellLocator<dim>  &locator  = occupancy.locator;
    const CellGeometry<dim> &geometry = locator.cells.geometry(cell_at_start);

    const Point<dim> end = locator.image(x, cell_at_start);
    Point<dim>       xi  = geometry.clamped(end);
    reinit(cell_at_start, geometry.to_unit(xi));
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        const Point<dim> next = geometry.clamped(
          end - theta * vector_value(view.state.displacement()));
        reinit(cell, geometry.to_unit(next));
        if (is_small(geometry.to_unit(next - xi)))
          break;
        xi = next;
      }
  }

  template <int dim>
  bool
  GridEvaluation<dim>::is_inside() const
  {
    return !view.fill.has_surface() || level_at(view, cell, unit) < 0.;
  }

  template <int dim>
  bool
  GridEvaluation<dim>::is_wet() const
  {
    return !view.fill.has_surface() || view.fill.inside_share(cell) > 0.;
  }

  template <int dim>
  double
  GridEvaluation<dim>::value(const Vector &field) const
  {
    const unsigned int *node = nodes();
    double              sum  = 0.;
    for (unsigned int a = 0; a < shapes.size(); ++a)
      sum += shapes[a] * field.local_element(node[a]);
    return sum;
  }

  template <int dim>
  Tensor<1, dim>
  GridEvaluation<dim>::vector_value(const Vector &field) const
  {
    Tensor<1, dim> result;
    with_degree(occupancy.degree(cell), [&](const auto degree) {
      double                          nodal[dim][Basis<dim, degree>::n_nodes];
      PointBatch<dim, degree, double> point;
      point.reinit_values(unit);
      occupancy.template unknowns<degree>(cell).read(field.begin(), nodal);
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = point.value(nodal[d]);
    });
    return result;
  }

  template <int dim>
  Point<dim>
  GridEvaluation<dim>::position() const
  {
    return occupancy.locator.cells.geometry(cell).to_real(unit);
  }

  template <int dim>
  const unsigned int *
  GridEvaluation<dim>::nodes() const
  {
    return occupancy.nodes.of_cell(cell);
  }

  template double
  level_at(const StepView<2> &, const unsigned int, const Point<2> &);
  template double
  level_at(const StepView<3> &, const unsigned int, const Point<3> &);
  template class GridEvaluation<2>;
  template class GridEvaluation<3>;
} // namespace seiche
