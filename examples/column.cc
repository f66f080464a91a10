// SPDX-License-Identifier: LGPL-2.1-or-later
// A column of water collapses: a scene without a parameter file, whose steps the
// program takes itself. Prints where the water is and how fast its fastest point.
#include <seiche/points/point_cloud.h>
#include <seiche/simulation/stepped_run.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

namespace
{
  constexpr int dim = 2;

  /// The entries are those of doc/parameters.md.
  seiche::SceneEntries
  column(const double width, const double height)
  {
    seiche::SceneEntries scene;
    scene.set("Grid/Lower corner", "0, 0")
      .set("Grid/Upper corner", "1.6, 0.8")
      .set("Grid/Cell size", 0.05)
      .set("Body force/Acceleration", "0; -9.81")
      .set("Fluid/Density", 1000.)
      .set("Fluid/Dynamic viscosity", 0.001)
      .set("Fluid/Bulk modulus", "infinite")
      .set("Fluid body column/Lower corner", "0, 0")
      .set("Fluid body column/Upper corner",
           std::to_string(width) + ", " + std::to_string(height))
      .set("Front surge/Direction", "x")
      .set("Time/End time", 0.4)
      .set("Time/Step", 0.01);
    return scene;
  }

  /// Of the points of all ranks [m/s].
  double
  fastest(const seiche::PointCloud<dim> &points)
  {
    const double *u      = points.data(seiche::PointColumn::velocity, 0);
    const double *v      = points.data(seiche::PointColumn::velocity, 1);
    double        result = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      result = std::max(result, std::hypot(u[p], v[p]));
    return dealii::Utilities::MPI::max(result, MPI_COMM_WORLD);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      seiche::SteppedRun<dim> run(column(0.4, 0.6), "column");
      while (!run.finished())
        {
          run.step();
          const double speed = fastest(run.points());
          if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
            std::cout << "t " << run.time() << " s, front "
                      << run.value("front surge [m]") << " m, fastest point "
                      << speed << " m/s" << std::endl;
        }
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
