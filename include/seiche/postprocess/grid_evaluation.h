// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_grid_evaluation_h
#define seiche_postprocess_grid_evaluation_h

#include <seiche/postprocess/postprocessor.h>

#include <boost/container/small_vector.hpp>

namespace seiche
{
  /// Level set [cells] of the free surface, at t_n, in an active cell; negative
  /// inside. Needs the rule of cut cells.
  template <int dim>
  double
  level_at(const StepView<dim>      &view,
           const unsigned int        cell,
           const dealii::Point<dim> &unit);

  /**
   * @brief Values of nodal fields at a place of the grid.
   *
   * A place is a cell (local number of Cells, own or ghost, active) and
   * a position in it at t_n. It is set directly, or found from a position in
   * the configuration x_n + theta u of the finished step. The view must
   * outlive the object. Everything is local.
   */
  template <int dim>
  class GridEvaluation
  {
  public:
    using Vector = typename GridState<dim>::Vector;

    explicit GridEvaluation(const StepView<dim> &view);

    /// Go to a place given by cell and position in the unit cell.
    void
    reinit(const unsigned int cell, const dealii::Point<dim> &unit);

    /// Go to the material place xi with xi + theta u(xi) = @p x, by fixed-point
    /// steps from xi = x; xi is kept inside the domain. False if it lies in no
    /// occupied own or ghost cell (there is no fluid; no values then).
    bool
    find(const dealii::Point<dim> &x, const double theta);

    /// As find(), for a material point: xi stays in @p cell, which held the
    /// point at t_n.
    void
    find_in_cell(const unsigned int        cell,
                 const dealii::Point<dim> &x,
                 const double              theta);

    /// False beyond the free surface, where fields are no more than continued;
    /// true without one (material points).
    bool
    is_inside() const;

    /// False if the surface encloses nothing of the cell: air and spray.
    bool
    is_wet() const;

    /// Value of a scalar field.
    double
    value(const Vector &field) const;

    /// Value of a vector field.
    dealii::Tensor<1, dim>
    vector_value(const Vector &field) const;

    /// Position at t_n [m].
    dealii::Point<dim>
    position() const;

    /// Local nodes [occupancy.nodes_per_cell()] of the cell and the values of
    /// their shape functions here.
    const unsigned int *
    nodes() const;
    double
    shape_value(const unsigned int node_of_cell) const
    {
      return shapes[node_of_cell];
    }

  private:
    const StepView<dim>  &view;
    const Occupancy<dim> &occupancy;

    unsigned int                               cell;
    dealii::Point<dim>                         unit;
    boost::container::small_vector<double, 27> shapes;
  };
} // namespace seiche

#endif
