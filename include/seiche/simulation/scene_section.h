// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_scene_section_h
#define seiche_simulation_scene_section_h

#include <seiche/simulation/scene.h>
#include <seiche/utilities/svg_canvas.h>

#include <deal.II/base/point.h>

namespace seiche
{
  /// What is cut where, and where on the paper it is drawn.
  template <int dim>
  struct SectionView
  {
    unsigned int       across, up; ///< directions of space on the paper
    dealii::Point<dim> middle;     ///< a place of the section [m]
    SvgCanvas::Place   upper_left; ///< of the domain [px]
    double             scale;      ///< [px/m]
  };

  /// Draw a section of a scene at its start, with axes. Local.
  template <int dim>
  void
  draw_section(const Scene<dim>                  &scene,
               const std::vector<FluidBody<dim>> &bodies,
               const SectionView<dim>            &view,
               SvgCanvas                         &canvas);
} // namespace seiche

#endif
