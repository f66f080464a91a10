// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/seeder.h>
#include <seiche/scene/expression.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
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



    template <int dim>
    std::vector<const Shape<dim> *>
    shapes(const std::vector<FluidBody<dim>> &bodies)
    {
      std::vector<const Shape<dim> *> result;
      for (const FluidBody<dim> &body : bodies)
        result.push_back(body.shape.get());
      return result;
    }
  } // namespace



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
             shapes(body_list),
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
    const double step =
      1e-4 * points.locator.lattice.box(lattice_cell.cell, lattice_cell.offset)
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
          points.data(PointColumn::material)[points.size() - 1] = body.material;
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



  template class Seeder<2>;
  template class Seeder<3>;
} // namespace seiche
