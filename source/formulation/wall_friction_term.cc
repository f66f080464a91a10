// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/fluid_at_wall.h>
#include <seiche/formulation/wall_friction_term.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// The nodes of a cell at a point of a wall.
    template <int dim, int degree>
    struct NodesAtWall
    {
      static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;

      double         weights[n_nodes];          // M [-]
      Point<dim>     place;                     // at t_n [m]
      Tensor<1, dim> way;                       // of the wall [m]
      double         factor;                    // c_f/2 rho dA [kg/m]
      double         end_rate;                  // of the velocities by u [1/s]
      std::array<Tensor<1, dim>, n_nodes> slip; // [m/s]
      Tensor<1, dim>                      normal;

      NodesAtWall(const CellData<dim, degree> &cell, const WallPoint<dim> &wall)
        : place(cell.geometry.to_real(wall.unit))
        , normal(wall.normal)
      {
        const SolidInStep<dim> &solid = (*cell.solids)[wall.solid];
        const StepCoefficients &step  = cell.coefficients;
        Basis<dim, degree>::bilinear_weights(wall.unit, weights);
        way = solid.way.at(place);
        factor =
          0.5 * solid.friction * cell.wall_material->density * wall.area.norm();
        // v_n+1 = v_n+theta + (1 - theta) dt a
        const double rest = (1. - step.theta) * step.dt;
        end_rate          = step.rate + rest * step.inertia;
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            for (unsigned int i = 0; i < dim; ++i)
              {
                double acceleration = cell.acceleration[i][a];
                if (cell.turns) // of the velocities in the tank's frame
                  for (unsigned int k = 0; k < dim; ++k)
                    acceleration -=
                      cell.coriolis[i][k] * cell.rate_velocity[k][a];
                slip[a][i] = cell.rate_velocity[i][a] + rest * acceleration -
                             way[i] / step.dt;
              }
            slip[a] -= (normal * slip[a]) * normal;
          }
      }

      /// What brakes the fluid at a node [N].
      Tensor<1, dim>
      force(const unsigned int a) const
      {
        return weights[a] * factor * slip[a].norm() * slip[a];
      }
    };

    template <int dim, int degree>
    bool
    has_friction(const CellData<dim, degree> &cell, const WallPoint<dim> &wall)
    {
      return (*cell.solids)[wall.solid].friction > 0. &&
             !fluid_leaves(cell, wall);
    }
  } // namespace

  template <int dim, int degree>
  void
  WallFrictionTerm::add_cell_residual(CellData<dim, degree> &cell) const
  {
    if (cell.wall == nullptr || cell.wall_is_dry)
      return;
    for (const WallPoint<dim> &wall : *cell.wall)
      if (has_friction(cell, wall))
        {
          const NodesAtWall<dim, degree> nodes(cell, wall);
          Tensor<1, dim>                 sum;
          for (unsigned int a = 0; a < cell.n_nodes; ++a)
            {
              const Tensor<1, dim> force = nodes.force(a);
              for (unsigned int i = 0; i < dim; ++i)
                cell.residual_u[i][a] += force[i];
              sum += force;
            }
          cell.solid_reactions.push_back(
            {wall.solid, nodes.place, -sum, -(sum * nodes.way)});
        }
  }

  template <int dim, int degree>
  void
  WallFrictionTerm::add_cell_tangent(CellData<dim, degree> &cell) const
  {
    if (cell.wall == nullptr || cell.wall_is_dry)
      return;
    for (const WallPoint<dim> &wall : *cell.wall)
      if (has_friction(cell, wall))
        {
          const NodesAtWall<dim, degree> nodes(cell, wall);
          for (unsigned int a = 0; a < cell.n_nodes; ++a)
            {
              const double         speed = nodes.slip[a].norm();
              const Tensor<1, dim> s = nodes.slip[a], &m = nodes.normal;
              for (unsigned int i = 0; speed > 0. && i < dim; ++i)
                for (unsigned int k = 0; k < dim; ++k)
                  cell.uu[i][k][a][a] +=
                    nodes.weights[a] * nodes.factor * nodes.end_rate *
                    (speed * ((i == k ? 1. : 0.) - m[i] * m[k]) +
                     s[i] * s[k] / speed);
            }
        }
  }

#define INSTANTIATE(dim, degree)                                             \
  template void WallFrictionTerm::add_cell_residual(CellData<dim, degree> &) \
    const;                                                                   \
  template void WallFrictionTerm::add_cell_tangent(CellData<dim, degree> &)  \
    const;
  INSTANTIATE(2, 1)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 1)
  INSTANTIATE(3, 2)
#undef INSTANTIATE
} // namespace seiche
