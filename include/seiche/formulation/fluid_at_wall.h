// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_fluid_at_wall_h
#define seiche_formulation_fluid_at_wall_h

#include <seiche/formulation/cell_data.h>
#include <seiche/formulation/cofactor.h>

namespace seiche
{
  /// The fluid at a point of a wall of a solid (doc/theory.md (8.10)).
  template <int dim, int degree>
  struct FluidAtWall
  {
    PointBatch<dim, degree, double> point;
    double                 gradient_t[dim][Basis<dim, degree>::n_nodes];
    dealii::Point<dim>     place; // in the configuration of the forces [m]
    dealii::Tensor<1, dim> way_of_wall;    // g [m]
    dealii::Tensor<1, dim> relative;       // u - g [m]
    dealii::Tensor<2, dim> relative_slope; // its derivative by u
    dealii::Tensor<1, dim> area;           // n_t dA [m^(dim-1)]
    dealii::Tensor<1, dim> solid_area;     // m_t dA
    double                 stiffness;      // of the latter [Pa/m^dim]
    double                 pressure;       // [Pa]

    static constexpr double gamma = 1.; // of the penalty [-]

    /// True if the condition of the wall lets fluid leave it.
    static bool
    may_leave(const CellData<dim, degree> &cell, const WallPoint<dim> &wall)
    {
      return cell.wall_may_be_left && (*cell.solids)[wall.solid].may_be_left;
    }

    FluidAtWall(const CellData<dim, degree> &cell, const WallPoint<dim> &wall)
    {
      point.reinit(cell.geometry, wall.unit);
      const double                 theta = cell.coefficients.theta;
      const RigidWay<dim>         &way   = (*cell.solids)[wall.solid].way;
      const dealii::Tensor<1, dim> u     = point.value(cell.displacement);
      place          = cell.geometry.to_real(wall.unit) + theta * u;
      way_of_wall    = way.at(place);
      relative       = u - way_of_wall;
      relative_slope = identity_plus<dim, double>(-theta * way.turn);
      const dealii::Tensor<2, dim> F =
        identity_plus<dim, double>(theta * point.gradient(cell.displacement));
      const dealii::Tensor<2, dim> turn = cofactor(F);
      const double                 dA   = wall.area.norm();
      area                              = turn * wall.area;
      solid_area                        = turn * (dA * wall.normal);
      stiffness = gamma * cell.geometry.shortest_edge() *
                  cell.fluid.inertia(cell.coefficients.inertia) / dA;
      if (cell.wall_is_dry)
        area = 0.; // drops fill no cell
      pressure = cell.wall_is_dry ? 0. : point.value(cell.pressure);
      const dealii::Tensor<2, dim> inverse = dealii::invert(F);
      for (unsigned int a = 0; a < point.n_nodes; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          {
            gradient_t[i][a] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              gradient_t[i][a] += inverse[j][i] * point.gradient_n[j][a];
          }
    }

    /// True where the wall would have to pull the fluid (8.10a), @p pressing
    /// [Pa] being what presses it beside the pressure.
    bool
    leaves(const CellData<dim, degree> &cell,
           const WallPoint<dim>        &wall,
           const double                 pressing = 0.) const
    {
      return may_leave(cell, wall) &&
             pressure + pressing + stiffness * (solid_area * relative) < 0.;
    }

    /// (u - g).area, of one of both, by the displacements of the nodes along
    /// k.
    Row<Basis<dim, degree>::n_nodes>
    through_slope(const CellData<dim, degree>  &cell,
                  const dealii::Tensor<1, dim> &of_area,
                  const unsigned int            k) const
    {
      auto along = relative[0] * load_row(gradient_t[0]); // gradient.(u - g)
      for (unsigned int i = 1; i < dim; ++i)
        along += relative[i] * load_row(gradient_t[i]);
      return (of_area * relative_slope)[k] * load_row(point.N) +
             cell.coefficients.theta *
               ((of_area * relative) * load_row(gradient_t[k]) -
                of_area[k] * along);
    }
  };

  /// FluidAtWall::leaves() in a step, quickly where no fluid may.
  template <int dim, int degree>
  bool
  fluid_leaves(const CellData<dim, degree> &cell, const WallPoint<dim> &wall)
  {
    using Fluid = FluidAtWall<dim, degree>;
    return Fluid::may_leave(cell, wall) && Fluid(cell, wall).leaves(cell, wall);
  }
} // namespace seiche

#endif
