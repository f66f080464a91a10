// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_solid_coupling_h
#define seiche_solve_solid_coupling_h

#include <seiche/grid/cell_materials.h>
#include <seiche/grid/wall_conditions.h>
#include <seiche/scene/body_force.h>
#include <seiche/solve/body_coupling.h>

namespace seiche
{
  /// Of solids that the fluid moves, each by its own wall; their weight is that
  /// of their mass in the scene's body force.
  template <int dim>
  class SolidCoupling : public BodyCoupling<dim>
  {
  public:
    /// Of those solids of the locator that are free, at least one. References
    /// must outlive the object.
    SolidCoupling(const Occupancy<dim>      &occupancy,
                  const WallConditions<dim> &wall_conditions,
                  const BodyForce<dim>      &body_force,
                  const CellMaterials<dim>  &materials,
                  const double               tolerance);

  private:
    using typename BodyCoupling<dim>::AddedInertia;
    using typename BodyCoupling<dim>::Direction;
    using BodyCoupling<dim>::directions;
    using BodyCoupling<dim>::occupancy;
    using BodyCoupling<dim>::step;

    /// Those of the fluid that the solids displace.
    std::vector<AddedInertia>
    added_inertias(const GridState<dim> &state) const override;

    std::vector<double>
    fluid_loads(const GridState<dim> &state) const override;

    std::vector<BodyStop>
    find_stops(const GridState<dim> &state) const override;

    double
    further_load(const Direction      &direction,
                 const GridState<dim> &state) const override;

    /// Of a body's weight, and of its moorings.
    double
    weight(const Direction &direction, const GridState<dim> &state) const;
    double
    mooring_load(const Direction &direction, const GridState<dim> &state) const;

    void
    apply(GridState<dim> &state) const override;

    /// About what a body turns at a time [s].
    dealii::Point<dim>
    centre(const Direction &direction, const double time) const;

    /// That of each direction.
    std::vector<dealii::Point<dim>>
    centres(const double time) const;

    std::vector<unsigned int>  solid_of_body; // number
    const WallConditions<dim> &wall_conditions;
    const BodyForce<dim>      &body_force;
    const CellMaterials<dim>  &materials;
  };
} // namespace seiche

#endif
