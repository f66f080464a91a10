// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_materials_material_h
#define seiche_materials_material_h

#include <seiche/materials/viscosity_law.h>

namespace seiche
{
  /// A fluid, as the weak forms see it: rho and mu of doc/theory.md (2.1).
  struct Material
  {
    std::string                         name;
    double                              density = 0.; ///< at rest [kg/m^3]
    std::shared_ptr<const ViscosityLaw> law;
  };
} // namespace seiche

#endif
