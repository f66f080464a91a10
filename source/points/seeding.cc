// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/points/seeder.h>
#include <seiche/points/seeding.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  void
  SeedingParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Points");
    prm.add_parameter("Per cell and direction",
                      per_direction,
                      "Material points along each edge of a full cell of the "
                      "highest level of refinement. [-]",
                      dealii::Patterns::Integer(1, 100));
    prm.add_parameter("Jitter",
                      jitter,
                      "Points are displaced at random by up to this share of "
                      "their spacing in each direction, except at curved and "
                      "inclined surfaces; 0 gives a regular lattice. [-]",
                      dealii::Patterns::Double(0., 0.5));
    prm.add_parameter("Seed",
                      seed,
                      "Number that selects the random displacements. [-]",
                      dealii::Patterns::Integer(0));
    prm.leave_subsection();
  }



  void
  SeedingParameters::check(const InputFile &input) const
  {
    input.read_only_if(jitter > 0., "Points/Seed", "Points/Jitter");
    input.require(std::isfinite(jitter),
                  "Points/Jitter",
                  "must be a number from 0 to 0.5.");
  }



  template <int dim>
  SeedingResult
  seed_bodies(const SeedingParameters           &parameters,
              const std::vector<FluidBody<dim>> &bodies,
              const InputFile                   &input,
              const std::vector<Material>       &materials,
              PointCloud<dim>                   &points)
  {
    const double n_places =
      points.locator.lattice.n_lattice_cells() *
      dealii::Utilities::fixed_power<dim>(double(parameters.per_direction));
    input.require(n_places < std::pow(2., Seeder<dim>::id_bits),
                  "Points/Per cell and direction",
                  fmt::format("with the finest cells everywhere there would be "
                              "room for {:.3g} points; ids count to 2^{} in a "
                              "body. Choose fewer, larger cells or smaller "
                              "levels of refinement.",
                              n_places,
                              Seeder<dim>::id_bits));
    SeedingResult result;
    double        smallest_spacing = std::numeric_limits<double>::max();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const Material &material = materials[bodies[b].material];
        Seeder<dim>     seeder(parameters, bodies, b, material, points);
        for (unsigned int cell = 0; cell < points.locator.cells.n_owned();
             ++cell)
          seeder.fill(cell);
        smallest_spacing = std::min(smallest_spacing, seeder.smallest_spacing);
        input.require(dealii::Utilities::MPI::max(seeder.largest_share,
                                                  points.communicator) >=
                        BodyPieces<dim>::light,
                      FluidBodyParameters<dim>::path(bodies[b].name, "Shape"),
                      BodyPieces<dim>::message_if_empty);
        result.bodies.push_back(
          {bodies[b].name,
           dealii::Utilities::MPI::sum(seeder.n_points, points.communicator),
           dealii::Utilities::MPI::sum(seeder.mass, points.communicator),
           material.properties().mass(bodies[b].shape->volume())});
      }
    points.locate();
    result.n_points = points.n_global();
    result.half_spacing =
      0.5 * dealii::Utilities::MPI::min(smallest_spacing, points.communicator);
    return result;
  }



  template SeedingResult
  seed_bodies<2>(const SeedingParameters &,
                 const std::vector<FluidBody<2>> &,
                 const InputFile &,
                 const std::vector<Material> &,
                 PointCloud<2> &);
  template SeedingResult
  seed_bodies<3>(const SeedingParameters &,
                 const std::vector<FluidBody<3>> &,
                 const InputFile &,
                 const std::vector<Material> &,
                 PointCloud<3> &);
} // namespace seiche
