// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_spinning_body_h
#define tests_unit_spinning_body_h

#include <deal.II/base/point.h>

#include <string>

#include "scene_from_text.h"

// A body that spins and shears away from the walls.
namespace
{
  using namespace dealii;

  /// A body away from the walls, with finer cells in a part of it.
  template <int dim>
  std::string
  scene_text(const bool adaptive)
  {
    const auto in_3d = [](const char *text) {
      return std::string(dim == 3 ? text : "");
    };
    const std::string refinement =
      "subsection Refinement a\n set Criterion = fluid\n"
      "set Level = 0\nend\n"
      "subsection Refinement b\n set Criterion = box\n"
      "set Lower corner = 0.4, 0.5" +
      in_3d(", 0.5") + "\n set Upper corner = 0.5, 0.6" + in_3d(", 0.6") +
      "\n set Level = 1\nend\n";
    return "subsection Grid\n set Lower corner = " + corner<dim>("0") +
           "\n set Upper corner = " + corner<dim>("1") +
           "\n set Cell size = 0.1\nend\n"
           "subsection Fluid body a\n set Lower corner = 0.2, 0.3" +
           in_3d(", 0.4") + "\n set Upper corner = 0.7, 0.8" + in_3d(", 0.7") +
           "\n set Velocity = 1 - 2*y + 0.3*x; 2*x - 0.3*y" +
           in_3d("; 0.5*z + x") +
           "\nend\n"
           "subsection Points\n set Jitter = 0.4\n"
           "set Per cell and direction = 3\nend\n" +
           (adaptive ? refinement : "");
  }



  /// The body's velocity.
  template <int dim>
  Tensor<1, dim>
  linear_velocity(const Point<dim> &x)
  {
    Tensor<1, dim> v;
    v[0] = 1. - 2. * x[1] + 0.3 * x[0];
    v[1] = 2. * x[0] - 0.3 * x[1];
    if (dim == 3)
      v[2] = 0.5 * x[2] + x[0];
    return v;
  }
} // namespace

#endif
