// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_materials_fluid_parameters_h
#define seiche_materials_fluid_parameters_h

#include <seiche/materials/material.h>
#include <seiche/materials/volume_law.h>

namespace seiche
{
  /// prm entries of one material: of the subsection "Fluid" and of each
  /// "Material NAME".
  struct MaterialParameters
  {
    static constexpr const char *kind = "Material";

    std::string name; ///< empty: of the subsection Fluid

    /// Enters its subsection; set the name before.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Chooses the law. InputError for what makes no sense.
    void
    check(const InputFile &input);

    /// After check().
    const Material &
    material() const
    {
      return chosen;
    }

    /// The subsection.
    std::string
    section() const
    {
      return name.empty() ? "Fluid" : kind + (" " + name);
    }

  private:
    double                         density           = 0.; // [kg/m^3]
    double                         dynamic_viscosity = 0.; // [Pa s]
    std::string                    law_name          = "Newtonian";
    std::vector<NamedViscosityLaw> laws              = make_viscosity_laws();
    Material                       chosen;
  };

  /**
   * @brief prm entries of the fluid (subsection "Fluid"): its material and what
   * all materials of the scene share, the law (2.2) of doc/theory.md.
   */
  struct FluidParameters
  {
    MaterialParameters material;
    VolumeLaw          volume_law; ///< after check()

    void
    add_parameters(dealii::ParameterHandler &prm);

    bool
    is_incompressible() const
    {
      return volume_law.is_incompressible();
    }

    /// InputError for what makes no sense.
    void
    check(const InputFile &input);

  private:
    std::string bulk_modulus_text = "infinite";
    std::string volume_law_name   = "linear";
  };
} // namespace seiche

#endif
