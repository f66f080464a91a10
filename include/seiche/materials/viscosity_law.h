// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_materials_viscosity_law_h
#define seiche_materials_viscosity_law_h

#include <seiche/utilities/lanes.h>

#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// What a law says of several points.
  struct Viscosity
  {
    Lanes value = 0.; ///< mu [Pa s]
    Lanes slope = 0.; ///< dmu/d(gamma^2) [Pa s^3]
  };

  /**
   * @brief Viscosity of a fluid as a function of its shear rate: the deviatoric
   * stress is s = 2 mu(gamma) d, d = dev(sym(grad v)), gamma^2 = 2 d:d (a
   * generalised Newtonian fluid; doc/theory.md (2.1)).
   *
   * One is chosen for each material from the table in viscosity_law.cc.
   */
  class ViscosityLaw
  {
  public:
    /// @p constant: mu is scale at all shear rates; at() is not always asked.
    explicit ViscosityLaw(const bool constant)
      : is_constant(constant)
    {}

    virtual ~ViscosityLaw() = default;

    /// At points with these gamma^2 [1/s^2]. Local.
    virtual Viscosity
    at(const Lanes &gamma_square) const = 0;

    /// Entries that no other law reads, in the subsection of the material.
    virtual void
    add_parameters(dealii::ParameterHandler &prm)
    {
      (void)prm;
    }

    /// @p chosen: false if the material has another law, whose entries then are
    /// without effect.
    virtual void
    check(const InputFile   &input,
          const std::string &section,
          const bool         chosen) const
    {
      (void)input;
      (void)section;
      (void)chosen;
    }

    /// mu [Pa s] at one place.
    double
    viscosity(const double gamma_square) const
    {
      return at(Lanes(gamma_square)).value[0];
    }

    const bool is_constant;

    /// The entry "Dynamic viscosity": mu [Pa s], or what a law makes of it.
    double scale = 0.;
  };

  /// Names of the laws, as a pattern, and what the manual says of them.
  std::string
  viscosity_law_names();
  std::string
  viscosity_law_descriptions();

  /// A law of each name, and the papers to cite with it.
  struct NamedViscosityLaw
  {
    std::string                   name, papers;
    std::shared_ptr<ViscosityLaw> law;
  };
  std::vector<NamedViscosityLaw>
  make_viscosity_laws();
} // namespace seiche

#endif
