// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/transfer/volume_update.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace seiche
{
  namespace
  {
    struct Entry
    {
      const char  *name;
      VolumeUpdate value;
    };

    constexpr Entry table[] = {{"at the point", VolumeUpdate::at_the_point},
                               {"nodal mean", VolumeUpdate::nodal_mean},
                               {"from the pressure",
                                VolumeUpdate::from_the_pressure}};
  } // namespace

  void
  VolumeParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    std::string names = "automatic";
    for (const Entry &entry : table)
      names += std::string("|") + entry.name;
    prm.enter_subsection("Volume");
    prm.add_parameter(
      "Update",
      update,
      "What changes the volume ratio J of a point in a step. at the point: the "
      "displacement gradient there; nodal mean: its nodal mean, which keeps "
      "neighbours together (higher order, but at a free surface less "
      "accurate); from the pressure: that which the new pressure belongs to, "
      "for the mixed form with a finite Bulk modulus and Elastic pressure = "
      "end: volumes and pressures stay together however stiff the fluid is. "
      "automatic: from the pressure where that can be and Quadrature/Rule is "
      "cut cells, else nodal mean for incompressible fluid and for Element "
      "degree 2, else at the point",
      dealii::Patterns::Selection(names));
    prm.leave_subsection();
  }

  void
  VolumeParameters::check(const InputFile &input,
                          const bool       has_pressure_of_end) const
  {
    input.require(update != "from the pressure" || has_pressure_of_end,
                  "Volume/Update",
                  "needs Formulation/Name = displacement-pressure, a finite "
                  "Fluid/Bulk modulus and Time/Elastic pressure = end; choose "
                  "automatic");
  }

  VolumeUpdate
  VolumeParameters::value(const VolumeUpdate automatic) const
  {
    for (const Entry &entry : table)
      if (update == entry.name)
        return entry.value;
    return automatic;
  }
} // namespace seiche
