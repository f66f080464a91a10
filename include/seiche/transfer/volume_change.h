// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_volume_change_h
#define seiche_transfer_volume_change_h

#include <seiche/grid/fill.h>
#include <seiche/grid/grid_state.h>
#include <seiche/points/point_cloud.h>

namespace seiche
{
  /**
   * @brief Change of volume in a step, det(I + grad u), as a nodal field: mean
   * over the points' cells, weighted by N_I V (degree 2: by V).
   *
   * In a cell with Gauss points it is the value in the middle, which is close
   * to their mean, else the mean of the points. With the same N_I on the way
   * back to the points the sum of their volumes changes as much as the cells
   * say (degree 1).
   *
   * The constraint of the mixed form holds for nodal averages; within a cell
   * det f varies, which is an error of the elements, not a change of density.
   * Points that follow the means keep a volume ratio near one
   * (doc/theory.md (2.4); compare the F-bar of de Souza Neto et al.
   * 1996 and the averaged nodal pressure of Bonet and Burton 1998).
   *
   * @return nodal values [-], ghosts too. Collective.
   */
  template <int dim>
  typename GridState<dim>::Vector
  nodal_volume_change(const Fill<dim>       &fill,
                      const PointCloud<dim> &points,
                      const GridState<dim>  &state);
} // namespace seiche

#endif
