// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/cofactor.h>
#include <seiche/formulation/fluid_at_wall.h>
#include <seiche/formulation/viscous_term.h>
#include <seiche/formulation/wall_drag_term.h>
#include <seiche/utilities/dual_number.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// What is needed of the fluid at a point of a wall that does not depend
    /// on its displacement.
    template <int dim>
    struct PointOfWall
    {
      Point<dim>       place;  // at t_n [m]
      Tensor<1, dim>   area;   // n dA at t_n [m^(dim-1)]
      Tensor<1, dim>   normal; // of the solid itself at t_n
      SolidInStep<dim> solid;
      const Material  *material;
      StepCoefficients step;
      double           e;             // [m]
      Tensor<1, dim>   rate;          // v = c_r u + this [m/s]
      Tensor<2, dim>   rate_gradient; // its gradient at t_n [1/s]
    };

    /// Of the fluid on the wall: int f.w + Q:grad_n w dA.
    template <int dim, typename Number>
    struct Forces
    {
      Tensor<1, dim, Number> f;     // [N]
      Tensor<2, dim, Number> Q;     // [N m]
      Point<dim, Number>     place; // [m]
    };

    double
    value_of(const double x)
    {
      return x;
    }

    template <unsigned int n>
    double
    value_of(const DualNumber<n> &x)
    {
      return x.value;
    }

    /// mu of a law, with its derivative where a Number has one.
    template <int dim, typename Number>
    Number
    viscosity(const ViscosityLaw &law, const Tensor<2, dim, Number> &rate)
    {
      if (law.is_constant)
        return law.scale;
      const Number    square = gamma_square<dim>(rate);
      const Viscosity mu     = law.at(Lanes(value_of(square)));
      return mu.value[0] + mu.slope[0] * (square - value_of(square));
    }

    template <int dim, typename Number>
    Number
    norm_of(const Tensor<1, dim, Number> &v)
    {
      const Number square = v * v;
      using std::sqrt;
      return value_of(square) > 0. ? Number(sqrt(square)) : Number(0.);
    }

    /// @p u and @p H: displacement [m] and its gradient at t_n.
    template <int dim, typename Number>
    Forces<dim, Number>
    forces(const PointOfWall<dim>       &wall,
           const Tensor<1, dim, Number> &u,
           const Tensor<2, dim, Number> &H)
    {
      const double           theta = wall.step.theta, c_r = wall.step.rate;
      Tensor<2, dim, Number> F, rate_gradient;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          {
            F[i][j]             = theta * H[i][j] + (i == j ? 1. : 0.);
            rate_gradient[i][j] = c_r * H[i][j] + wall.rate_gradient[i][j];
          }
      const Tensor<2, dim, Number> inverse = invert(F);
      const Tensor<2, dim, Number> cof     = cofactor(F);

      Forces<dim, Number>    result;
      Tensor<1, dim, Number> area, way, v, across;
      for (unsigned int i = 0; i < dim; ++i)
        {
          area[i] = 0.;
          for (unsigned int j = 0; j < dim; ++j)
            area[i] += cof[i][j] * wall.area[j];
          result.place[i] = wall.place[i] + theta * u[i];
        }
      for (unsigned int i = 0; i < dim; ++i)
        {
          way[i] = wall.solid.way.shift[i];
          for (unsigned int j = 0; j < dim; ++j)
            way[i] += wall.solid.way.turn[i][j] * result.place[j];
          v[i]      = c_r * u[i] + wall.rate[i] - way[i] / wall.step.dt;
          across[i] = c_r * (u[i] - way[i]);
        }
      Tensor<1, dim, Number> m;
      for (unsigned int i = 0; i < dim; ++i)
        {
          m[i] = 0.;
          for (unsigned int j = 0; j < dim; ++j)
            m[i] += cof[i][j] * wall.normal[j];
        }
      m               = m / norm_of<dim>(m);
      const Number dA = norm_of<dim>(area);

      const Tensor<2, dim, Number> e =
        shear_rate<dim, Number>(rate_gradient * inverse);
      const Number                 mu  = viscosity<dim>(*wall.material->law, e);
      const Tensor<1, dim, Number> T   = mu * (e * area);
      const Number                 T_n = m * T, v_n = m * across;
      const Tensor<1, dim, Number> T_t = T - T_n * m, v_t = v - (m * v) * m;

      // what T' is multiplied by
      Tensor<1, dim, Number> c = -v_n * m;
      result.f                 = -T_n * m + (mu / wall.e) * dA * v_n * m;
      const double L           = wall.solid.slip_length;
      if (std::isfinite(L))
        {
          const double share = wall.e / (L + wall.e);
          result.f += -share * T_t + mu * dA / (L + wall.e) * v_t;
          c -= share * v_t;
          if (value_of(mu) > 0.)
            c -= L * share / (mu * dA) * T_t;
        }

      // c.T' = mu (c_i n_j + c_j n_i - 2/3 c.n) dw_i/dx_j
      Tensor<2, dim, Number> Q_t;
      const Number           mean = (2. / 3.) * (c * area);
      for (unsigned int i = 0; i < dim; ++i)
        {
          for (unsigned int j = 0; j < dim; ++j)
            Q_t[i][j] = mu * (c[i] * area[j] + c[j] * area[i]);
          Q_t[i][i] -= mu * mean;
        }
      result.Q = Q_t * transpose(inverse);
      return result;
    }

    template <int dim, int degree>
    PointOfWall<dim>
    point_of_wall(const CellData<dim, degree>     &cell,
                  const WallPoint<dim>            &wall,
                  const double                     beta,
                  PointBatch<dim, degree, double> &point)
    {
      point.reinit(cell.geometry, wall.unit);
      PointOfWall<dim> result;
      result.place    = cell.geometry.to_real(wall.unit);
      result.area     = wall.area;
      result.normal   = wall.normal;
      result.solid    = (*cell.solids)[wall.solid];
      result.material = cell.wall_material;
      result.step     = cell.coefficients;
      result.e = cell.geometry.shortest_edge() / (beta * degree * degree);
      const StepCoefficients &step = cell.coefficients;
      const Tensor<1, dim>    u    = point.value(cell.displacement),
                           rate    = point.value(cell.rate_velocity);
      result.rate                  = rate - step.rate * u;
      result.rate_gradient =
        point.gradient(cell.rate_velocity) -
        cell.coefficients.rate * point.gradient(cell.displacement);
      return result;
    }
  } // namespace

  template <int dim, int degree>
  void
  WallDragTerm::add_cell_residual(CellData<dim, degree> &cell) const
  {
    if (cell.wall == nullptr || cell.wall_is_dry || !cell.fluid.is_viscous())
      return;
    PointBatch<dim, degree, double> point;
    for (const WallPoint<dim> &wall : *cell.wall)
      {
        if (fluid_leaves(cell, wall))
          continue;
        const auto at = point_of_wall(cell, wall, beta, point);
        const auto result =
          forces<dim, double>(at,
                              point.value(cell.displacement),
                              point.gradient(cell.displacement));
        for (unsigned int a = 0; a < cell.n_nodes; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            {
              cell.residual_u[i][a] += point.N[a] * result.f[i];
              for (unsigned int j = 0; j < dim; ++j)
                cell.residual_u[i][a] +=
                  result.Q[i][j] * point.gradient_n[j][a];
            }
        cell.solid_reactions.push_back(
          {wall.solid,
           result.place,
           -result.f,
           -(result.f * at.solid.way.at(result.place))});
      }
  }

  template <int dim, int degree>
  void
  WallDragTerm::add_cell_tangent(CellData<dim, degree> &cell) const
  {
    if (cell.wall == nullptr || cell.wall_is_dry ||
        !ViscousTerm::in_tangent(cell))
      return;
    // derivatives by u and by its gradient
    constexpr unsigned int n_inputs = dim + dim * dim;
    using Number                    = DualNumber<n_inputs>;
    PointBatch<dim, degree, double> point;
    for (const WallPoint<dim> &wall : *cell.wall)
      {
        if (fluid_leaves(cell, wall))
          continue;
        const auto             at = point_of_wall(cell, wall, beta, point);
        const auto             u_values = point.value(cell.displacement);
        const auto             H_values = point.gradient(cell.displacement);
        Tensor<1, dim, Number> u;
        Tensor<2, dim, Number> H;
        for (unsigned int k = 0; k < dim; ++k)
          {
            u[k] = Number(u_values[k], k);
            for (unsigned int l = 0; l < dim; ++l)
              H[k][l] = Number(H_values[k][l], dim + dim * k + l);
          }
        const auto result = forces<dim, Number>(at, u, H);

        // of an output by the displacement of node b in direction k
        const auto by_node = [&](const Number      &output,
                                 const unsigned int k,
                                 const unsigned int b) {
          double sum = output.slope[k] * point.N[b];
          for (unsigned int l = 0; l < dim; ++l)
            sum += output.slope[dim + dim * k + l] * point.gradient_n[l][b];
          return sum;
        };
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int b = 0; b < cell.n_nodes; ++b)
              {
                const double   df = by_node(result.f[i], k, b);
                Tensor<1, dim> dQ;
                for (unsigned int j = 0; j < dim; ++j)
                  dQ[j] = by_node(result.Q[i][j], k, b);
                for (unsigned int a = 0; a < cell.n_nodes; ++a)
                  {
                    double sum = point.N[a] * df;
                    for (unsigned int j = 0; j < dim; ++j)
                      sum += point.gradient_n[j][a] * dQ[j];
                    cell.uu[i][k][a][b] += sum;
                  }
              }
      }
  }

#define INSTANTIATE(dim, degree)                                         \
  template void WallDragTerm::add_cell_residual(CellData<dim, degree> &) \
    const;                                                               \
  template void WallDragTerm::add_cell_tangent(CellData<dim, degree> &) const;
  INSTANTIATE(2, 1)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 1)
  INSTANTIATE(3, 2)
#undef INSTANTIATE
} // namespace seiche
