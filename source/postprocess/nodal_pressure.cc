// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/grid_evaluation.h>
#include <seiche/postprocess/nodal_pressure.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  NodalPressure<dim>::begin_step()
  {
    is_current = false;
  }

  template <int dim>
  const typename NodalPressure<dim>::Vector &
  NodalPressure<dim>::field(const StepView<dim> &view)
  {
    if (view.state.has_pressure())
      return view.state.pressure();
    if (is_current)
      return mean;

    mean.reinit(view.occupancy.nodes.partitioner());
    Vector              mass(view.occupancy.nodes.partitioner());
    GridEvaluation<dim> place(view);
    const double       *point_mass = view.points.data(PointColumn::mass);
    const double *point_pressure   = view.points.data(PointColumn::pressure);
    for (std::size_t i = 0; i < view.points.size(); ++i)
      {
        place.find_in_cell(view.points.cells()[i],
                           view.points.position(i),
                           /*theta=*/1.);
        const unsigned int *node = place.nodes();
        for (unsigned int a = 0; a < view.occupancy.nodes_per_cell(); ++a)
          {
            const double weight = place.shape_value(a) * point_mass[i];
            mass.local_element(node[a]) += weight;
            mean.local_element(node[a]) += weight * point_pressure[i];
          }
      }
    mass.compress(VectorOperation::add);
    mean.compress(VectorOperation::add);
    for (unsigned int i = 0; i < view.occupancy.nodes.n_own(); ++i)
      if (mass.local_element(i) > 0.)
        mean.local_element(i) /= mass.local_element(i);
    mean.update_ghost_values();
    is_current = true;
    return mean;
  }

  template class NodalPressure<2>;
  template class NodalPressure<3>;
} // namespace seiche
