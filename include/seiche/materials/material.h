// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_materials_material_h
#define seiche_materials_material_h

#include <seiche/materials/viscosity_law.h>

namespace seiche
{
  /// rho and mu of doc/theory.md (2.1), for what sees a fluid without its law.
  struct FluidProperties
  {
    double density   = 0.; ///< at rest [kg/m^3]
    double viscosity = 0.; ///< [Pa s]

    bool
    is_viscous() const
    {
      return viscosity > 0.;
    }

    double
    mass(const double volume) const
    {
      return density * volume;
    }

    /// rho C_a of accelerations C_a u.
    double
    inertia(const double C_a) const
    {
      return density * C_a;
    }

    /// 2 mu c_r of velocities c_r u.
    double
    stiffness(const double c_r) const
    {
      return 2. * viscosity * c_r;
    }

    /// [m^2/s]
    double
    kinematic_viscosity() const
    {
      return viscosity / density;
    }
  };

  /// A fluid of the scene.
  struct Material
  {
    std::string                         name;
    double                              density = 0.; ///< at rest [kg/m^3]
    std::shared_ptr<const ViscosityLaw> law;

    /// At a shear rate, @p gamma_square [1/s^2].
    FluidProperties
    properties(const double gamma_square = 0.) const
    {
      return {density, law->viscosity(gamma_square)};
    }
  };
} // namespace seiche

#endif
