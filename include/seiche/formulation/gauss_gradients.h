// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_gauss_gradients_h
#define seiche_formulation_gauss_gradients_h

#include <seiche/space/point_batch.h>

#include <deal.II/base/quadrature_lib.h>

namespace seiche
{
  /// f(grad_n N, weight) at degree + 1 Gauss points per direction of a cell;
  /// weights sum to 1. For the mean over a cell of the integrand of
  /// doc/theory.md (6.3).
  template <int dim, int degree, typename Function>
  void
  for_each_gauss_gradient(const CellGeometry<dim> &geometry, const Function &f)
  {
    static const dealii::QGauss<dim> gauss(degree + 1);
    PointBatch<dim, degree, double>  point;
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        point.reinit(geometry, gauss.point(q));
        f(point.gradient_n, gauss.weight(q));
      }
  }
} // namespace seiche

#endif
