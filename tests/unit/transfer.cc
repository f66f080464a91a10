// SPDX-License-Identifier: LGPL-2.1-or-later
// Mass, momentum, angular momentum and energy through each transfer, and
// what is exact for linear fields.
#include <seiche/grid/mesh_adaptation.h>
#include <seiche/transfer/interpolate.h>
#include <seiche/transfer/transfer.h>

#include <cmath>
#include <iomanip>

#include "scene_from_text.h"

namespace
{
  using seiche::PointColumn;

  const MPI_Comm communicator = MPI_COMM_WORLD;

  bool
  root()
  {
    return dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
  }



  double
  global_sum(const double value)
  {
    return dealii::Utilities::MPI::sum(value, communicator);
  }



  /// Sums over points or nodes, each with place, velocity and mass.
  template <int dim>
  struct Ledger
  {
    double                 mass = 0., energy = 0., spin = 0.;
    dealii::Tensor<1, dim> momentum;

    void
    add(const dealii::Point<dim>     &x,
        const dealii::Tensor<1, dim> &v,
        const double                  m)
    {
      mass += m;
      momentum += m * v;
      energy += 0.5 * m * v.norm_square();
      spin += m * (x[0] * v[1] - x[1] * v[0]);
    }
  };



  template <int dim>
  Ledger<dim>
  of_points(const seiche::PointCloud<dim> &points)
  {
    Ledger<dim> result;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        dealii::Tensor<1, dim> v;
        for (unsigned int d = 0; d < dim; ++d)
          v[d] = points.data(PointColumn::velocity, d)[p];
        result.add(points.position(p), v, points.data(PointColumn::mass)[p]);
      }
    return result;
  }



  template <int dim>
  Ledger<dim>
  of_nodes(const seiche::Occupancy<dim>                  &occupancy,
           const seiche::GridState<dim>                  &state,
           const typename seiche::GridState<dim>::Vector &velocity)
  {
    Ledger<dim> result;
    for (unsigned int node = 0; node < occupancy.n_own_nodes(); ++node)
      {
        dealii::Tensor<1, dim> v;
        for (unsigned int d = 0; d < dim; ++d)
          v[d] = velocity.local_element(dim * node + d);
        result.add(occupancy.node_position(node),
                   v,
                   state.mass.local_element(node));
      }
    return result;
  }



  template <int dim>
  void
  print(const std::string &name, const Ledger<dim> &l)
  {
    double momentum = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      momentum += (d + 1) * global_sum(l.momentum[d]);
    const double mass = global_sum(l.mass), energy = global_sum(l.energy),
                 spin = global_sum(l.spin);
    if (root())
      std::cout << "  " << name << ": mass " << mass << " momentum " << momentum
                << " energy " << energy << " spin " << spin << std::endl;
  }



  /// Finer cells in a part of the body: hanging nodes.
  template <int dim>
  std::string
  refinement_text()
  {
    const std::string z = dim == 3 ? ", 0.5" : "";
    return "subsection Refinement a\n set Criterion = fluid\n"
           "set Level = 0\nend\n"
           "subsection Refinement b\n set Criterion = box\n"
           "set Lower corner = 0.4, 0.5" +
           z + "\n set Upper corner = 0.5, 0.6" + (dim == 3 ? ", 0.6" : "") +
           "\n set Level = 1\nend\n";
  }



  /// A body away from the walls that spins and shears.
  template <int dim>
  std::string
  scene_text()
  {
    const std::string z = dim == 3 ? ", 0" : "";
    return "subsection Grid\n set Lower corner = 0, 0" + z +
           "\n set Upper corner = 1, 1" + (dim == 3 ? ", 1" : "") +
           "\n set Cell size = 0.1\nend\n"
           "subsection Fluid body a\n set Lower corner = 0.2, 0.3" +
           (dim == 3 ? ", 0.4" : "") + "\n set Upper corner = 0.7, 0.8" +
           (dim == 3 ? ", 0.7" : "") +
           "\n set Velocity = 1 - 2*y + 0.3*x; 2*x - 0.3*y" +
           (dim == 3 ? "; 0.5*z + x" : "") +
           "\nend\n"
           "subsection Points\n set Jitter = 0.4\n"
           "set Per cell and direction = 3\nend\n";
  }



  /// Momentum [kg m/s] of a nodal velocity seen by the points: sum_p m_p N v,
  /// which a consistent mass conserves.
  template <int dim>
  void
  print_momentum_at_points(const seiche::Occupancy<dim> &occupancy,
                           const seiche::GridState<dim> &state,
                           seiche::PointCloud<dim>       points)
  {
    seiche::interpolate_to_points(occupancy,
                                  state.velocity_n,
                                  PointColumn::velocity,
                                  points);
    print("nodes at points", of_points(points));
  }



  template <int dim>
  void
  test(const std::string &method,
       const bool         adaptive,
       const unsigned int degree = 1,
       const std::string &mass   = "automatic")
  {
    if (root())
      std::cout << dim << "D " << method << (adaptive ? ", hanging nodes" : "")
                << (degree == 2 ? ", degree 2" : "")
                << (mass == "automatic" ? "" : ", " + mass + " mass")
                << std::endl;
    const SceneFromText<dim>    scene(scene_text<dim>() +
                                   (adaptive ? refinement_text<dim>() : ""));
    seiche::BackgroundGrid<dim> grid(scene.grid_parameters, communicator);
    seiche::CellLocator<dim>    locator(grid);
    seiche::TransferParameters  parameters;
    parameters.method = method;
    parameters.mass   = mass;
    seiche::PointCloud<dim> points(locator,
                                   seiche::Transfer<dim>::columns(parameters),
                                   communicator);
    seiche::seed_bodies(scene.seeding,
                        scene.bodies,
                        scene.input,
                        material_of_density(100.),
                        points);
    if (adaptive)
      seiche::MeshAdaptation<dim>(grid, locator, points, /*gauss=*/true);
    seiche::Occupancy<dim> occupancy(locator, degree);
    occupancy.update(points);
    seiche::Fill<dim> fill(occupancy, seiche::QuadratureRule::cut_cells);
    fill.update(points);
    seiche::GridState<dim> state;
    state.reinit(occupancy,
                 /*with_pressure=*/true,
                 /*with_acceleration=*/
                 points.has(PointColumn::acceleration));
    state.dt                               = 0.01;
    const auto                       fluid = material_of_density(100.);
    const seiche::CellMaterials<dim> materials(fluid, occupancy);
    const seiche::Transfer<dim>      transfer(parameters,
                                         fill,
                                         materials,
                                         seiche::VolumeUpdate::at_the_point);
    for (std::size_t p = 0; p < points.size(); ++p)
      points.data(PointColumn::pressure)[p] = 7.;

    print("points", of_points(points));
    transfer.points_to_grid(points, state);
    print("nodes", of_nodes(occupancy, state, state.velocity_n));
    if (parameters.is_consistent(degree))
      print_momentum_at_points(occupancy, state, points);

    // largest error of the linear field at nodes, and the mean pressure
    double error = 0., pressure_error = 0.;
    for (unsigned int node = 0; node < occupancy.n_own_nodes(); ++node)
      if (state.mass.local_element(node) > 0.)
        {
          const auto &x = occupancy.node_position(node);
          error         = std::max(error,
                           std::abs(state.velocity_n.local_element(dim * node) -
                                    (1. - 2. * x[1] + 0.3 * x[0])));
          pressure_error =
            std::max(pressure_error,
                     std::abs(state.pressure_guess.local_element(node) - 7.));
        }
    error = dealii::Utilities::MPI::max(error, communicator);
    if (root())
      std::cout << "  linear velocity exact at nodes: "
                << (error < 1e-8 ? "yes" : "no") << ", pressure kept: "
                << (pressure_error < 1e-10 ? "yes" : "no") << std::endl;

    // a step with a known acceleration field, a = (1, 2 x, ...); its start
    // velocity differs from v_n, as with walls and the projection
    state.velocity_start.zero_out_ghost_values();
    for (unsigned int i = 0; i < dim * occupancy.n_own_nodes(); ++i)
      state.velocity_start.local_element(i) =
        state.velocity_n.local_element(i) + 0.25;
    state.velocity_start.update_ghost_values();
    for (auto *vector : {&state.acceleration_np1,
                         &state.velocity_np1,
                         &state.displacement(),
                         &state.pressure()})
      vector->zero_out_ghost_values();
    for (unsigned int node = 0; node < occupancy.n_own_nodes(); ++node)
      {
        const auto &x = occupancy.node_position(node);
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int i = dim * node + d;
            const double       a = d == 0 ? 1. : 2. * x[0];
            const double       v = state.velocity_start.local_element(i);
            state.acceleration_np1.local_element(i) = a;
            state.velocity_np1.local_element(i)     = v + state.dt * a;
            state.displacement().local_element(i) =
              state.dt * (v + 0.5 * state.dt * a);
          }
        state.pressure().local_element(node) = 3. + x[1];
      }
    for (auto *vector : {&state.acceleration_np1,
                         &state.velocity_np1,
                         &state.displacement(),
                         &state.pressure()})
      vector->update_ghost_values();
    const seiche::StepCheck check = transfer.check(state, points, /*limit=*/0.);
    transfer.grid_to_points(state, points);
    print("points after", of_points(points));
    double volume = 0., pressure = 0., gradient = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const double v0 = points.data(PointColumn::initial_volume)[p];
        volume += v0 * points.data(PointColumn::volume_ratio)[p];
        pressure += v0 * points.data(PointColumn::pressure)[p];
        if (points.has(PointColumn::velocity_gradient))
          for (unsigned int c = 0; c < dim * dim; ++c)
            gradient +=
              v0 * (c + 1) * points.data(PointColumn::velocity_gradient, c)[p];
      }
    volume   = global_sum(volume);
    pressure = global_sum(pressure);
    gradient = global_sum(gradient);
    if (root())
      std::cout << "  volume " << volume << " pressure " << pressure
                << " gradient " << gradient << " least det F "
                << check.min_det_F << " displacement " << check.max_displacement
                << " finite " << check.finite << std::endl;
    points.locate();
    occupancy.update(points);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::setprecision(10);
  for (const char *method : {"PIC",
                             "FLIP",
                             "FLIP acceleration",
                             "PIC/FLIP blend",
                             "APIC",
                             "TPIC",
                             "affine FLIP",
                             "Taylor least squares",
                             "XPIC",
                             "FMPM"})
    {
      test<2>(method, /*adaptive=*/false);
      test<3>(method, /*adaptive=*/false);
    }
  for (const char *method : {"FLIP acceleration", "affine FLIP"})
    {
      test<2>(method, /*adaptive=*/true);
      test<3>(method, /*adaptive=*/true);
    }
  for (const char *method : {"FLIP", "affine FLIP"})
    for (const unsigned int degree : {1, 2})
      for (const bool adaptive : {false, true})
        {
          test<2>(method, adaptive, degree, "consistent");
          test<3>(method, adaptive, degree, "consistent");
        }
  test<2>("affine FLIP", /*adaptive=*/true, 2, "lumped");
  test<3>("affine FLIP", /*adaptive=*/true, 2, "lumped");
}
