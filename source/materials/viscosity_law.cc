// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/materials/power_law.h>

namespace seiche
{
  namespace
  {
    class NewtonianLaw : public ViscosityLaw
    {
    public:
      NewtonianLaw()
        : ViscosityLaw(/*constant=*/true)
      {}

      Viscosity
      at(const Lanes &) const override
      {
        return {scale, 0.};
      }
    };

    /// One row of the table of laws.
    struct ViscosityLawEntry
    {
      const char *name;
      std::shared_ptr<ViscosityLaw> (*make)();
      const char *papers; ///< keys of doc/references.bib
      const char *description;
    };

    template <typename Law>
    std::shared_ptr<ViscosityLaw>
    make()
    {
      return std::make_shared<Law>();
    }

    constexpr std::array<ViscosityLawEntry, 2> viscosity_law_table = {
      {{"Newtonian", make<NewtonianLaw>, "", "the same at all shear rates"},
       {"power law",
        make<PowerLaw>,
        "bird1987",
        "K (gamma^2 + gamma_0^2)^((n - 1)/2), gamma the shear rate"}}};
  } // namespace

  std::string
  viscosity_law_names()
  {
    std::string names;
    for (const auto &entry : viscosity_law_table)
      names += (names.empty() ? "" : "|") + std::string(entry.name);
    return names;
  }

  std::string
  viscosity_law_descriptions()
  {
    std::string text;
    for (const auto &entry : viscosity_law_table)
      text += (text.empty() ? "" : "; ") + std::string(entry.name) + ": " +
              entry.description;
    return text;
  }

  std::vector<NamedViscosityLaw>
  make_viscosity_laws()
  {
    std::vector<NamedViscosityLaw> result;
    for (const auto &entry : viscosity_law_table)
      result.push_back({entry.name, entry.papers, entry.make()});
    return result;
  }
} // namespace seiche
