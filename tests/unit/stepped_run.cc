// SPDX-License-Identifier: LGPL-2.1-or-later
// A run without a parameter file: its steps are those of the program, and what
// is wrong with its scene is said as for a file.
#include <seiche/points/point_cloud.h>
#include <seiche/simulation/stepped_run.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace
{
  template <int dim>
  seiche::SceneEntries
  falling_box(const double step)
  {
    const bool           in_3d = dim == 3;
    seiche::SceneEntries scene;
    scene.set("Grid/Lower corner", in_3d ? "0, 0, 0" : "0, 0")
      .set("Grid/Upper corner", in_3d ? "1, 1, 1.5" : "1, 1.5")
      .set("Grid/Cell size", 0.25)
      .set("Body force/Acceleration", in_3d ? "0; 0; -10" : "0; -10")
      .set("Fluid/Density", 1.)
      .set("Fluid/Dynamic viscosity", 0.)
      .set("Fluid/Bulk modulus", "infinite")
      .set("Fluid body box/Lower corner",
           in_3d ? "0.25, 0.25, 0.5" : "0.25, 0.5")
      .set("Fluid body box/Upper corner", in_3d ? "0.75, 0.75, 1" : "0.75, 1")
      .set("Front lower/Direction", in_3d ? "z" : "y")
      .set("Front lower/Sense", "lower")
      .set("Time/End time", 0.2)
      .set("Time/Step", step);
    return scene;
  }

  const char *
  in_words(const bool condition)
  {
    return condition ? "yes" : "no";
  }

  /// Free fall, v = -10 m/s^2 t; the surface of a body of two cells is rounder
  /// than the body, 0.5 m - 5 m/s^2 t^2 at its lower end.
  template <int dim>
  void
  fall()
  {
    const std::string       folder = "run_" + std::to_string(dim);
    seiche::SteppedRun<dim> run(falling_box<dim>(0.1), folder);
    while (!run.finished())
      {
        run.step();
        const double  t = run.time();
        const double *speed =
          run.points().data(seiche::PointColumn::velocity, dim - 1);
        const double front = run.value("front lower [m]");
        std::cout << dim << "D t " << t << " speed right: "
                  << in_words(std::abs(speed[0] + 10. * t) < 2e-3)
                  << ", front right: "
                  << in_words(std::abs(front - 0.5 + 5. * t * t) < 0.05)
                  << ", points " << run.points().size() << std::endl;
      }
    for (const char *name :
         {"statistics.csv", "summary.json", "methods.bib", "parameters.prm"})
      std::cout << name
                << (std::filesystem::exists(folder + "/" + name) ? "" : " not")
                << " written" << std::endl;
    try
      {
        run.step();
      }
    catch (const std::logic_error &error)
      {
        std::cout << error.what() << std::endl;
      }
    try
      {
        run.value("front");
      }
    catch (const std::out_of_range &error)
      {
        std::cout << std::string(error.what()).substr(0, 42) << std::endl;
      }
  }

  void
  say_what_is_wrong(const seiche::SceneEntries &scene)
  {
    try
      {
        const seiche::SteppedRun<2> run(scene, "refused");
        std::cout << "accepted" << std::endl;
      }
    catch (const seiche::InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  fall<2>();
  fall<3>();
  say_what_is_wrong(falling_box<2>(-1.));
  say_what_is_wrong(falling_box<2>(0.1).set("Fluid/Densty", 1.));
  say_what_is_wrong(falling_box<2>(0.1).set("Fluid/Density", 2.));
  say_what_is_wrong(falling_box<2>(0.1).set("/Density", 2.));
  std::cout << "refused" << (std::filesystem::exists("refused") ? "" : " not")
            << " written" << std::endl;
}
