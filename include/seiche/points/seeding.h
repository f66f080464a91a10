// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_points_seeding_h
#define seiche_points_seeding_h

#include <seiche/materials/material.h>
#include <seiche/points/point_cloud.h>
#include <seiche/scene/fluid_body.h>

#include <vector>

namespace seiche
{
  /// How fluid bodies are filled with points (prm subsection "Points").
  struct SeedingParameters
  {
    unsigned int per_direction = 4;  // points per cell and direction
    double       jitter        = 0.; // +- this share of the point spacing
    unsigned int seed          = 1;

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input) const;
  };

  /// What became of a fluid body, all ranks.
  struct SeededBody
  {
    std::string   name;
    std::uint64_t n_points = 0;
    double        mass     = 0.; ///< [kg]
    /// Mass of the whole shape [kg], of which obstacles and earlier bodies may
    /// have taken a part; not a number if it is not known.
    double whole = 0.;
  };

  /// What the seeding of all bodies made, all ranks.
  struct SeedingResult
  {
    std::vector<SeededBody> bodies;
    std::uint64_t           n_points = 0;
    /// Half the smallest distance of lattice neighbours in any body [m].
    double half_spacing = 0.;
  };

  /**
   * Fill the bodies with points: every own cell that a region touches gets the
   * lattice of Region::lattice_box() with per_direction points per full cell
   * edge (fewer, at least one, in a cut box). A place that is in the body gets
   * a point in its middle, displaced by jitter (never out of its box); of one
   * that the surface cuts the point has the volume and the centre of the part
   * inside (BodyPieces; doc/theory.md (5.2)). Ids and jitter depend on the
   * lattice index and the seed only, not on ranks. If @p points carries a
   * velocity gradient, it is set from central differences of the velocity.
   * Overlapping bodies: the first one wins. Locates the points. InputError for
   * a body that gets no point. Collective.
   */
  template <int dim>
  SeedingResult
  seed_bodies(const SeedingParameters           &parameters,
              const std::vector<FluidBody<dim>> &bodies,
              const InputFile                   &input,
              const std::vector<Material>       &materials,
              PointCloud<dim>                   &points);
} // namespace seiche

#endif
