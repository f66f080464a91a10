// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_box_part_h
#define seiche_scene_box_part_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <functional>

namespace seiche
{
  /**
   * @brief Volume and centre of the part of a box where a function is negative.
   */
  template <int dim>
  struct BoxPart
  {
    using Level = std::function<double(const dealii::Point<dim> &)>;

    double             share = 0.; ///< of the box's volume [0,1]
    dealii::Point<dim> centre;     ///< the box's if the share is zero
  };

  /**
   * By Gauss points in all directions but one, between the places where the
   * surface crosses the edges, and by exact lengths in that direction, the one
   * in which @p level changes most (compare R. I. Saye, SIAM J. Sci. Comput. 37
   * (2015) A993-A1019). Exact for planes; a box in which another rule gives
   * another volume (corners, edges) is divided. What is smaller than the box
   * and touches neither its vertices nor its centre may be missed. @p tolerance:
   * of the volume over the box's. Local.
   */
  template <int dim>
  BoxPart<dim>
  part_inside(const typename BoxPart<dim>::Level &level,
              const dealii::BoundingBox<dim>     &box,
              const double                        tolerance = 1e-6);
} // namespace seiche

#endif
