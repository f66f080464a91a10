// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/points/body_pieces.h>
#include <seiche/points/seeding.h>
#include <seiche/scene/expression.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

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



  namespace
  {
    /// Of an id: the place on the lattice; the rest is the body.
    constexpr unsigned int id_bits = 56;

    /// The finalizer of splitmix64 (Steele, Lea, Flood, OOPSLA 2014).
    std::uint64_t
    mix(std::uint64_t z)
    {
      z += 0x9e3779b97f4a7c15ull;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
      return z ^ (z >> 31);
    }



    /// Random number in [-1, 1) that depends on its arguments only: the same
    /// on every rank count and for every order of the points.
    double
    random_offset(const std::uint64_t seed,
                  const std::uint64_t id,
                  const unsigned int  direction)
    {
      const std::uint64_t bits = mix(mix(mix(seed) ^ id) ^ direction);
      return 2. * static_cast<double>(bits >> 11) / 9007199254740992. - 1.;
    }



    /// Seeds the cells of this rank with one body.
    template <int dim>
    class Seeder
    {
    public:
      Seeder(const SeedingParameters           &seeding_parameters,
             const std::vector<FluidBody<dim>> &body_list,
             const unsigned int                 index,
             const Material                    &body_material,
             PointCloud<dim>                   &target);

      /// Every cell of the finest lattice inside the cell.
      void
      fill(const unsigned int cell);

      double        smallest_spacing = std::numeric_limits<double>::max();
      double        largest_share    = 0.; ///< of a point, of its place [-]
      double        mass             = 0.; ///< [kg]
      std::uint64_t n_points         = 0;

    private:
      void
      fill_lattice(const typename BodyPieces<dim>::LatticeCell &lattice_cell);

      /// The place of a point that has all of its part of the lattice.
      dealii::Point<dim>
      displaced(const typename BodyPieces<dim>::Lattice &lattice,
                const dealii::Point<dim>                &place,
                const std::uint64_t                      id) const;

      /// dv_i/dx_j by central differences, for the last point.
      void
      set_velocity_gradient(const Expression<dim>    &velocity,
                            const dealii::Point<dim> &x,
                            const double              step);

      const SeedingParameters &parameters;
      const FluidBody<dim>    &body;
      const unsigned int       body_index;
      const FluidProperties    fluid;
      PointCloud<dim>         &points;
      BodyPieces<dim>          pieces;
    };



    template <int dim>
    std::vector<const Region<dim> *>
    regions(const std::vector<FluidBody<dim>> &bodies)
    {
      std::vector<const Region<dim> *> result;
      for (const FluidBody<dim> &body : bodies)
        result.push_back(body.region.get());
      return result;
    }



    template <int dim>
    Seeder<dim>::Seeder(const SeedingParameters           &seeding_parameters,
                        const std::vector<FluidBody<dim>> &body_list,
                        const unsigned int                 index,
                        const Material                    &body_material,
                        PointCloud<dim>                   &target)
      : parameters(seeding_parameters)
      , body(body_list[index])
      , body_index(index)
      , fluid(body_material.properties())
      , points(target)
      , pieces(target.locator,
               regions(body_list),
               index,
               seeding_parameters.per_direction)
    {}



    template <int dim>
    void
    Seeder<dim>::fill(const unsigned int cell)
    {
      if (pieces.is_apart_from(cell))
        return;
      const unsigned int  n = points.locator.lattice.size(cell);
      const std::uint64_t n_boxes =
        dealii::Utilities::fixed_power<dim>(std::uint64_t(n));
      for (std::uint64_t i = 0; i < n_boxes; ++i)
        {
          typename BodyPieces<dim>::LatticeCell lattice_cell;
          lattice_cell.cell  = cell;
          std::uint64_t rest = i;
          for (unsigned int d = 0; d < dim; ++d, rest /= n)
            lattice_cell.offset[d] = rest % n;
          fill_lattice(lattice_cell);
        }
    }



    template <int dim>
    void
    Seeder<dim>::fill_lattice(
      const typename BodyPieces<dim>::LatticeCell &lattice_cell)
    {
      const auto         &lattice = pieces.lattice(lattice_cell);
      const unsigned int  per     = parameters.per_direction;
      const std::uint64_t first_id =
        (static_cast<std::uint64_t>(body_index) << id_bits) |
        (points.locator.lattice.index(lattice_cell.cell, lattice_cell.offset) *
         dealii::Utilities::fixed_power<dim>(per));
      const double step = 1e-4 * points.locator.lattice
                                   .box(lattice_cell.cell, lattice_cell.offset)
                                   .side_length(0);

      for (unsigned int i = 0; i < lattice.n_all; ++i)
        {
          const auto piece = pieces.piece(lattice_cell, i);
          if (piece.volume == 0.)
            continue;
          const auto         k      = lattice.position(i);
          dealii::Point<dim> x      = piece.centre;
          std::uint64_t      id     = first_id;
          std::uint64_t      stride = 1;
          for (unsigned int d = 0; d < dim; ++d, stride *= per)
            {
              id += k[d] * stride;
              if (piece.is_whole)
                x[d] = lattice.origin[d] + (k[d] + 0.5) * lattice.spacing[d];
            }
          if (piece.is_whole)
            x = displaced(lattice, x, id);
          const Expression<dim> &velocity = *body.velocity;
          points.insert(id,
                        x,
                        velocity.vector_value(x, /*t=*/0.),
                        fluid.mass(piece.volume),
                        piece.volume);
          if (points.has(PointColumn::material))
            points.data(PointColumn::material)[points.size() - 1] =
              body.material;
          if (points.has(PointColumn::velocity_gradient))
            set_velocity_gradient(velocity, x, step);
          largest_share =
            std::max(largest_share, piece.volume / lattice.measure());
          for (unsigned int d = 0; d < dim; ++d)
            smallest_spacing = std::min(smallest_spacing, lattice.spacing[d]);
          mass += fluid.mass(piece.volume);
          ++n_points;
        }
    }



    template <int dim>
    dealii::Point<dim>
    Seeder<dim>::displaced(const typename BodyPieces<dim>::Lattice &lattice,
                           const dealii::Point<dim>                &place,
                           const std::uint64_t                      id) const
    {
      dealii::Point<dim> x = place;
      if (parameters.jitter > 0.)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double upper =
              lattice.origin[d] + lattice.n[d] * lattice.spacing[d];
            x[d] += parameters.jitter * lattice.spacing[d] *
                    random_offset(parameters.seed, id, d);
            x[d] = std::min(std::max(x[d], lattice.origin[d]), upper);
          }
      return x;
    }



    template <int dim>
    void
    Seeder<dim>::set_velocity_gradient(const Expression<dim>    &velocity,
                                       const dealii::Point<dim> &x,
                                       const double              step)
    {
      if (velocity.is_constant())
        return; // insertion has made it zero
      for (unsigned int j = 0; j < dim; ++j)
        {
          dealii::Point<dim> before = x, behind = x;
          before[j] -= step;
          behind[j] += step;
          const auto difference = velocity.vector_value(behind, /*t=*/0.) -
                                  velocity.vector_value(before, /*t=*/0.);
          for (unsigned int i = 0; i < dim; ++i)
            points.data(PointColumn::velocity_gradient,
                        i * dim + j)[points.size() - 1] =
              difference[i] / (2. * step);
        }
    }
  } // namespace



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
    input.require(n_places < std::pow(2., id_bits),
                  "Points/Per cell and direction",
                  fmt::format("with the finest cells everywhere there would be "
                              "room for {:.3g} points; ids count to 2^{} in a "
                              "body. Choose fewer, larger cells or smaller "
                              "levels of refinement.",
                              n_places,
                              id_bits));
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
           material.properties().mass(bodies[b].region->volume())});
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
