// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_tank_coupling_h
#define seiche_solve_tank_coupling_h

#include <seiche/scene/tank_motion.h>
#include <seiche/solve/body_coupling.h>

namespace seiche
{
  /// Of a tank that the fluid moves by all of its walls. Only the fluid's
  /// accelerations depend on those of the tank, in whose frame it is.
  template <int dim>
  class TankCoupling : public BodyCoupling<dim>
  {
  public:
    /// References must outlive the object.
    TankCoupling(TankMotion<dim>      &tank,
                 const Occupancy<dim> &occupancy,
                 const double          tolerance);

  private:
    using typename BodyCoupling<dim>::AddedInertia;
    using BodyCoupling<dim>::directions;
    using BodyCoupling<dim>::occupancy;
    using BodyCoupling<dim>::step;

    /// Those of the fluid as a part of the tank.
    std::vector<AddedInertia>
    added_inertias(const GridState<dim> &state) const override;

    std::vector<double>
    fluid_loads(const GridState<dim> &state) const override;

    const TankMotion<dim> &tank;
  };
} // namespace seiche

#endif
