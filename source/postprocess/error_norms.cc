// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/error_norms.h>
#include <seiche/postprocess/grid_evaluation.h>
#include <seiche/utilities/over_ranks.h>

#include <deal.II/base/quadrature_lib.h>

#include <limits>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  ErrorNorm<dim>::ErrorNorm(const Parameters                &error_parameters,
                            const PostprocessorContext<dim> &context)
    : parameters(error_parameters)
    , exact(
        error_parameters.exact_solution(context.input, context.grid.parameters))
    , region(error_parameters.region(context.input, context.grid.parameters))
    , pressure(context.pressure)
    , of_pressure(error_parameters.quantity == "pressure")
  {}

  template <int dim>
  void
  ErrorNorm<dim>::add(const Point<dim>     &x,
                      const Tensor<1, dim> &computed,
                      const double          weight)
  {
    if (!region.point_inside(x))
      return;
    Sample sample{computed, Tensor<1, dim>(), weight};
    for (unsigned int c = 0; c < parameters.n_components(); ++c)
      sample.exact[c] = exact.value(x, time, c);
    samples.push_back(sample);
  }

  template <int dim>
  void
  ErrorNorm<dim>::sample_nodes(const StepView<dim> &view)
  {
    const double theta = of_pressure ? view.pressure_theta : 1.;
    const auto  &field =
      of_pressure ? pressure->field(view) : view.state.velocity_np1;
    for (unsigned int node = 0; node < view.occupancy.nodes.n_own(); ++node)
      {
        // only nodes of occupied cells have mass
        const double mass = view.state.mass.local_element(node);
        if (mass <= 0.)
          continue;
        Point<dim>     x = view.occupancy.nodes.position(node);
        Tensor<1, dim> computed;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] +=
            theta * view.state.displacement().local_element(dim * node + d);
        for (unsigned int c = 0; c < parameters.n_components(); ++c)
          computed[c] =
            field.local_element(parameters.n_components() * node + c);
        add(view.occupancy.locator.periods.wrapped(x), computed, mass);
      }
  }

  template <int dim>
  void
  ErrorNorm<dim>::sample_gauss_points(const StepView<dim> &view)
  {
    const double        theta = of_pressure ? view.pressure_theta : 1.;
    const QGauss<dim>   quadrature(view.occupancy.fe.degree + 1);
    const auto         *p = of_pressure ? &pressure->field(view) : nullptr;
    GridEvaluation<dim> place(view);
    for (const unsigned int cell : view.occupancy.cells.occupied())
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          place.reinit(cell, quadrature.point(q));
          const Point<dim> x =
            place.position() +
            theta * place.vector_value(view.state.displacement());
          Tensor<1, dim> computed;
          if (of_pressure)
            computed[0] = place.value(*p);
          else
            computed = place.vector_value(view.state.velocity_np1);
          add(view.occupancy.locator.periods.wrapped(x),
              computed,
              view.occupancy.locator.cells.geometry(cell).measure *
                quadrature.weight(q));
        }
  }

  template <int dim>
  void
  ErrorNorm<dim>::sample_material_points(const StepView<dim> &view)
  {
    GridEvaluation<dim>             place(view);
    const double                   *p = view.points.data(PointColumn::pressure);
    std::array<const double *, dim> v;
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = view.points.data(PointColumn::velocity, d);
    for (std::size_t i = 0; i < view.points.size(); ++i)
      {
        Point<dim>     x = view.points.position(i);
        Tensor<1, dim> computed;
        if (of_pressure)
          {
            // back from the end of the step to the time of the pressure
            place.find_in_cell(view.points.cells()[i], x, /*theta=*/1.);
            x -= (1. - view.pressure_theta) *
                 place.vector_value(view.state.displacement());
            computed[0] = p[i];
          }
        else
          for (unsigned int d = 0; d < dim; ++d)
            computed[d] = v[d][i];
        add(view.occupancy.locator.periods.wrapped(x), computed, /*weight=*/1.);
      }
  }

  template <int dim>
  double
  ErrorNorm<dim>::evaluate(const MPI_Comm communicator)
  {
    // sum of weights, then weighted sums of the differences and of the exact
    // values: subtracting means first keeps their squares free of cancellation
    std::array<double, 1 + 2 * dim> means{};
    for (const Sample &sample : samples)
      {
        means[0] += sample.weight;
        for (unsigned int c = 0; c < dim; ++c)
          {
            means[1 + c] +=
              sample.weight * (sample.computed[c] - sample.exact[c]);
            means[1 + dim + c] += sample.weight * sample.exact[c];
          }
      }
    sum_over_ranks(means, communicator);
    const double   total = means[0];
    Tensor<1, dim> mean_error, mean_exact;
    if (parameters.remove_mean && total > 0.)
      for (unsigned int c = 0; c < dim; ++c)
        {
          mean_error[c] = means[1 + c] / total;
          mean_exact[c] = means[1 + dim + c] / total;
        }

    std::array<double, 2> squares{}; // of error and exact solution
    double                largest = 0.;
    for (const Sample &sample : samples)
      {
        const double error =
          (sample.computed - sample.exact - mean_error).norm_square();
        squares[0] += sample.weight * error;
        squares[1] += sample.weight * (sample.exact - mean_exact).norm_square();
        largest = std::max(largest, error);
      }
    sum_over_ranks(squares, communicator);
    largest = Utilities::MPI::max(largest, communicator);

    if (total <= 0. || (parameters.norm == "relative L2" && squares[1] <= 0.))
      return std::numeric_limits<double>::quiet_NaN();
    if (parameters.norm == "relative L2")
      return std::sqrt(squares[0] / squares[1]);
    return std::sqrt(parameters.norm == "rms" ? squares[0] / total : largest) /
           parameters.scale;
  }

  template <int dim>
  void
  ErrorNorm<dim>::execute(const StepView<dim> &view,
                          StatisticsTable     &statistics)
  {
    samples.clear();
    double error = std::numeric_limits<double>::quiet_NaN();
    // nothing has computed a pressure before the first step
    if (view.step > 0 || !of_pressure)
      {
        time = of_pressure ? view.pressure_time : view.time;
        if (parameters.sample == "nodes")
          sample_nodes(view);
        else if (parameters.sample == "Gauss points")
          sample_gauss_points(view);
        else
          sample_material_points(view);
        error = evaluate(view.points.communicator);
      }
    statistics.set(parameters.columns()[0], error);
  }

  template class ErrorNorm<2>;
  template class ErrorNorm<3>;
} // namespace seiche
