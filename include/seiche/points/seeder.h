// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_points_seeder_h
#define seiche_points_seeder_h

#include <seiche/points/body_pieces.h>
#include <seiche/points/seeding.h>

#include <limits>
#include <vector>

namespace seiche
{
  /// Seeds the cells of this rank with one body.
  template <int dim>
  class Seeder
  {
  public:
    /// Of an id: the place on the lattice; the rest is the body.
    static constexpr unsigned int id_bits = 56;

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
} // namespace seiche

#endif
