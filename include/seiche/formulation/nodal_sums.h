// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_nodal_sums_h
#define seiche_formulation_nodal_sums_h

#include <seiche/formulation/point_kinematics.h>

namespace seiche
{
  /// What the test functions w and q multiply at several points: sums over the
  /// terms of a residual, with the points' masses and volumes.
  template <int dim>
  struct PointForces
  {
    dealii::Tensor<1, dim, Lanes> force;         ///< w [N]
    dealii::Tensor<2, dim, Lanes> stress;        ///< grad_t w [N m]
    Lanes                         pressure = 0.; ///< -div_t w [N m]
    Lanes                         volume   = 0.; ///< q [m^dim]
    dealii::Tensor<1, dim, Lanes> flux;          ///< grad_t q [m^(dim+1)]
  };

  /// The residual of a cell, summed over its batches of points.
  template <int dim, int degree>
  struct NodalSums
  {
    static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;

    Lanes u[dim][n_nodes] = {}; ///< [N]
    Lanes p[n_nodes]      = {}; ///< [m^dim]

    template <bool has_pressure>
    void
    add(const PointKinematics<dim, degree> &point, PointForces<dim> &forces)
    {
      for (unsigned int i = 0; i < dim; ++i)
        forces.stress[i][i] -= forces.pressure;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            Lanes force = forces.force[i] * point.N[a];
            for (unsigned int j = 0; j < dim; ++j)
              force += forces.stress[i][j] * point.gradient_t[j][a];
            u[i][a] += force;
          }
      if constexpr (has_pressure)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            Lanes volume = forces.volume * point.N[a];
            for (unsigned int i = 0; i < dim; ++i)
              volume += forces.flux[i] * point.gradient_t[i][a];
            p[a] += volume;
          }
    }

    template <bool has_pressure>
    void
    store(CellData<dim, degree> &cell) const
    {
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          for (unsigned int i = 0; i < dim; ++i)
            cell.residual_u[i][a] = sum(u[i][a]);
          if constexpr (has_pressure)
            cell.residual_p[a] = sum(p[a]);
        }
    }
  };
} // namespace seiche

#endif
