// SPDX-License-Identifier: LGPL-2.1-or-later
// Points crowded by a map: shifting evens out the fill, splitting and merging
// keep their bounds; a linear velocity stays exact, and what must be conserved
// is.
#include <seiche/grid/point_control.h>

#include <cmath>
#include <set>

#include "scene_from_text.h"

namespace
{
  using namespace dealii;
  using seiche::PointColumn;

  const MPI_Comm communicator = MPI_COMM_WORLD;

  template <int dim>
  std::string
  scene_text()
  {
    const std::string z  = dim == 3 ? ", 0" : "";
    const std::string z1 = dim == 3 ? ", 1" : "";
    return "subsection Grid\n set Lower corner = 0, 0" + z +
           "\n set Upper corner = 1, 1" + z1 +
           "\n set Cell size = " + (dim == 2 ? "0.125" : "0.25") +
           "\nend\n"
           "subsection Obstacle block\n set Lower corner = 0.5, 0" +
           z + "\n set Upper corner = 0.75, 0.25" + z1 +
           "\nend\n"
           "subsection Fluid body all\n set Lower corner = 0, 0" +
           z + "\n set Upper corner = 1, 1" + z1 +
           "\nend\n"
           "subsection Points\n set Per cell and direction = 3\nend\n";
  }



  template <int dim>
  Tensor<2, dim>
  gradient()
  {
    Tensor<2, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        result[c][d] = 0.5 * c - 0.3 * d + 0.1 * c * d + 0.2;
    return result;
  }



  /// Crowd the points and give them the velocity G x + 1, kinds of volumes.
  template <int dim>
  void
  disturb(seiche::PointCloud<dim> &points)
  {
    const Tensor<2, dim> G = gradient<dim>();
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        Point<dim> x = points.position(p);
        if (x[1] > 0.3)
          x[1] = 0.3 + 0.7 * std::pow((x[1] - 0.3) / 0.7, 1.25);
        const Tensor<1, dim> v = G * x;
        for (unsigned int c = 0; c < dim; ++c)
          {
            points.data(PointColumn::position, c)[p] = x[c];
            points.data(PointColumn::velocity, c)[p] = v[c] + 1.;
            for (unsigned int d = 0; d < dim; ++d)
              points.data(PointColumn::velocity_gradient, c * dim + d)[p] =
                G[c][d];
          }
        points.data(PointColumn::volume_ratio)[p] = 1. + 0.1 * x[0];
        points.data(PointColumn::pressure)[p]     = 3.;
      }
    points.locate();
  }



  template <int dim>
  void
  report(const seiche::PointCloud<dim> &points, const seiche::Fill<dim> &fill)
  {
    const Tensor<2, dim> G = gradient<dim>();
    double mass = 0., volume = 0., deviation = 0., least = 1e9, most = 0.;
    double error = 0., fullest = 0.;
    Tensor<1, dim> momentum;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const Tensor<1, dim> v = G * points.position(p);
        for (unsigned int c = 0; c < dim; ++c)
          {
            const double carried = points.data(PointColumn::velocity, c)[p];
            error = std::max(error, std::abs(carried - v[c] - 1.));
            momentum[c] += points.data(PointColumn::mass)[p] * carried;
            for (unsigned int d = 0; d < dim; ++d)
              error =
                std::max(error,
                         std::abs(points.data(PointColumn::velocity_gradient,
                                              c * dim + d)[p] -
                                  G[c][d]));
          }
        error =
          std::max(error, std::abs(points.data(PointColumn::pressure)[p] - 3.));
        mass += points.data(PointColumn::mass)[p];
        volume += points.data(PointColumn::initial_volume)[p] *
                  points.data(PointColumn::volume_ratio)[p];
      }
    const seiche::Occupancy<dim> &occupancy = fill.occupancy;
    for (unsigned int i = 0; i < occupancy.n_own_nodes(); ++i)
      {
        const double f = fill.nodal_fill().local_element(i) - 1.;
        deviation += occupancy.node_volume(i) * f * f;
        fullest = std::max(fullest, f + 1.);
      }
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        least = std::min<double>(least, points.n_points_in(cell));
        most  = std::max<double>(most, points.n_points_in(cell));
      }
    std::set<std::uint64_t> ids;
    std::uint64_t           sum = 0;
    for (const auto &own :
         Utilities::MPI::all_gather(communicator, points.ids()))
      for (const std::uint64_t id : own)
        {
          ids.insert(id);
          sum += id;
        }
    const auto total = [](const double value) {
      return Utilities::MPI::sum(value, communicator);
    };
    for (unsigned int c = 0; c < dim; ++c)
      momentum[c] = total(momentum[c]);
    mass      = total(mass);
    volume    = total(volume);
    deviation = std::sqrt(total(deviation));
    least     = Utilities::MPI::min(least, communicator);
    most      = Utilities::MPI::max(most, communicator);
    fullest   = Utilities::MPI::max(fullest, communicator);
    error     = Utilities::MPI::max(error, communicator);
    print("  points ",
          points.n_global(),
          ", ids ",
          ids.size(),
          " sum ",
          sum,
          ", in a cell ",
          least,
          " to ",
          most,
          "; fill: rms deviation ",
          deviation,
          ", largest ",
          fullest);
    print("  mass ",
          mass,
          " momentum ",
          momentum,
          " volume ",
          volume,
          "; linear fields exact: ",
          error < 1e-12 ? "yes" : "no");
  }



  template <int dim>
  void
  test(const std::string                    &name,
       const seiche::PointControlParameters &parameters)
  {
    print(dim, "D ", name);
    const SceneFromText<dim>    scene(scene_text<dim>());
    seiche::BackgroundGrid<dim> grid(scene.grid_parameters, communicator);
    seiche::CellLocator<dim>    locator(grid);
    seiche::PointCloud<dim>     points(locator,
                                   {PointColumn::velocity_gradient},
                                   communicator);
    seiche::seed_bodies(scene.seeding,
                        scene.bodies,
                        scene.input,
                        material_of_density(100.),
                        points);
    disturb(points);
    seiche::Occupancy<dim> occupancy(locator, /*degree=*/1);
    occupancy.update(points);
    seiche::Fill<dim> fill(occupancy, seiche::QuadratureRule::cut_cells);
    fill.update(points);
    seiche::PointControl<dim> control(parameters, points, occupancy, fill);
    report(points, fill);
    for (unsigned int step = 0; step < 4; ++step)
      control.update();
    report(points, fill);
    for (const auto &[what, value] : control.account())
      print("  ", what, " ", std::abs(value) < 1e-12 ? 0. : value);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  seiche::PointControlParameters   shifting, reseeding;
  shifting.sweeps     = 3;
  reseeding.reseeding = true;
  reseeding.fewest    = 8;
  reseeding.most      = 16;
  test<2>("shifting", shifting);
  test<2>("splitting", reseeding);
  reseeding.fewest = 4;
  reseeding.most   = 9;
  test<2>("merging", reseeding);
  shifting.reseeding = true;
  shifting.fewest    = 9;
  shifting.most      = 18;
  test<2>("both", shifting);
  reseeding.fewest = 24;
  reseeding.most   = 48;
  test<3>("splitting", reseeding);
  reseeding.fewest = 14;
  reseeding.most   = 28;
  test<3>("merging", reseeding);
  shifting.reseeding = false;
  test<3>("shifting", shifting);
}
