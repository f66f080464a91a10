// SPDX-License-Identifier: LGPL-2.1-or-later
// Number, mass, spacing and jitter of the points at the start.
#include <iomanip>

#include "scene_from_text.h"

namespace
{
  template <int dim>
  void
  seed(const std::string &name, const std::string &text)
  {
    const SceneFromText<dim>          scene(text);
    const seiche::BackgroundGrid<dim> grid(scene.grid_parameters,
                                           MPI_COMM_WORLD);
    const seiche::CellLocator<dim>    locator(grid);
    seiche::PointCloud<dim>           points(locator,
                                   {seiche::PointColumn::velocity_gradient},
                                   MPI_COMM_WORLD);
    const seiche::SeedingResult       result =
      seiche::seed_bodies(scene.seeding,
                          scene.bodies,
                          scene.input,
                          material_of_density(2.),
                          points);

    double                  mass = 0.;
    dealii::Point<dim>      centre;
    dealii::Tensor<1, dim>  momentum;
    dealii::Tensor<2, dim>  gradient;
    std::set<std::uint64_t> ids(points.ids().begin(), points.ids().end());
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const double m = points.data(seiche::PointColumn::mass)[p];
        mass += m;
        centre += m * points.position(p);
        for (unsigned int d = 0; d < dim; ++d)
          {
            momentum[d] += m * points.data(seiche::PointColumn::velocity, d)[p];
            for (unsigned int e = 0; e < dim; ++e)
              gradient[d][e] +=
                m * points.data(seiche::PointColumn::velocity_gradient,
                                d * dim + e)[p];
          }
      }
    std::cout << name << ": points " << result.n_points << " different ids "
              << (ids.size() == points.size()) << " half spacing "
              << result.half_spacing << " mass " << mass << " centre "
              << centre / mass << "\n  velocity " << momentum / mass
              << " gradient " << gradient / mass << std::endl;
  }



  const std::string tank = "subsection Grid\n set Lower corner = 0, 0\n"
                           "set Upper corner = 3.22, 3.0\n"
                           "set Break points x = 1.2\n set Cells x = 24, 40\n"
                           "set Cells y = 60\nend\n";
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::setprecision(10);

  const std::string column =
    "subsection Fluid body column\n set Lower corner = 0, 0\n"
    "set Upper corner = 1.2, 0.6\n set Velocity = 2*y; -3*x + y\nend\n";
  seed<2>("column", tank + column);
  seed<2>("jittered",
          tank + column + "subsection Points\n set Jitter = 0.5\nend\n");
  seed<2>("faces between grid lines",
          tank + "subsection Fluid body a\n set Lower corner = 0.113, 0.201\n"
                 "set Upper corner = 1.307, 0.333\nend\n");
  seed<2>("first body wins",
          tank + column +
            "subsection Fluid body wide\n set Lower corner = 0.6, 0\n"
            "set Upper corner = 1.8, 0.6\nend\n");
  seed<2>("ball",
          tank + "subsection Fluid body ball\n set Shape = ball\n"
                 "set Centre = 1, 1\n set Radius = 0.5\nend\n");
  seed<2>("around an obstacle",
          tank + column +
            "subsection Obstacle a\n set Lower corner = 0.4, 0\n"
            "set Upper corner = 0.8, 0.3\nend\n");
  seed<3>("column",
          "subsection Grid\n set Lower corner = 0, 0, 0\n"
          "set Upper corner = 1.6, 0.4, 0.8\n set Cell size = 0.05\nend\n"
          "subsection Fluid body column\n set Lower corner = 0, 0, 0\n"
          "set Upper corner = 0.4, 0.4, 0.4\n set Velocity = z; x; 2*y\nend\n"
          "subsection Points\n set Per cell and direction = 2\nend\n");

  print_input_error([]() {
    seed<2>("nothing",
            tank + "subsection Fluid body drop\n set Shape = ball\n"
                   "set Centre = 1, 1\n set Radius = 0.001\nend\n");
  });
  print_input_error([]() {
    seed<2>("singular",
            tank + "subsection Fluid body drop\n set Shape = ball\n"
                   "set Centre = 1, 1\n set Radius = 0.5\n"
                   "set Velocity = log(0.9 - x); 0\nend\n");
  });
}
