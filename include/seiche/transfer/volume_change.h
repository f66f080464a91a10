// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_volume_change_h
#define seiche_transfer_volume_change_h

#include <seiche/grid/grid_state.h>
#include <seiche/points/point_cloud.h>

namespace seiche
{
  /**
   * @brief Change of volume in a step, det(I + grad u), as a nodal field: mean
   * over the cells at a node of the value in the cell's centre, weighted by the
   * mass in the cell.
   *
   * The constraint of the mixed form holds for nodal averages; within a cell
   * det f varies, which is an error of the elements, not a change of density.
   * Points that follow the means keep a volume ratio near one
   * (doc/theory.md, "Relaxed volume"; compare the F-bar of de Souza Neto et al.
   * 1996 and the averaged nodal pressure of Bonet and Burton 1998).
   *
   * @return nodal values [-], ghosts too. Collective.
   */
  template <int dim>
  typename GridState<dim>::Vector
  nodal_volume_change(const Occupancy<dim>  &occupancy,
                      const PointCloud<dim> &points,
                      const GridState<dim>  &state);
} // namespace seiche

#endif
