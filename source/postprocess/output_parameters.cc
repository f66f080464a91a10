// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/output_parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  using namespace dealii;

  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter("Interval",
                      interval,
                      "Time between two frames of grid, points, surface and "
                      "walls; 0: no frames. [s]",
                      Patterns::Double(0.));
    prm.add_parameter("Grid",
                      grid,
                      "Write the occupied cells for ParaView (grid.pvd).");
    prm.add_parameter("Points",
                      points,
                      "Write the points for ParaView (points.pvd).");
    prm.add_parameter("Surface",
                      surface,
                      "Write the free surface for ParaView (surface.pvd); "
                      "only with Quadrature/Rule = cut cells.");
    prm.add_parameter("Point series",
                      series,
                      "Write the points in full precision, one HDF5 file a "
                      "frame.");
    prm.add_parameter("Mean level",
                      mean_level,
                      "Add the mean height of the free surface to the "
                      "statistics.");
    prm.add_parameter("Exit code by verdict",
                      verdict,
                      "A finished run that fails one of its \"Verdict NAME\" "
                      "ends with exit code 6.");
    prm.leave_subsection();
  }
} // namespace seiche
