// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_volume_update_h
#define seiche_transfer_volume_update_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// What changes the volume ratio J of a point in a step.
  enum class VolumeUpdate
  {
    at_the_point,     ///< det(I + grad u) there
    nodal_mean,       ///< of that, which keeps neighbours together
    from_the_pressure ///< J = phi^-1(-p/kappa), doc/theory.md (2.3a)
  };

  /// prm entries of subsection "Volume".
  struct VolumeParameters
  {
    std::string update = "automatic";

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// @p has_pressure_of_end: a finite bulk modulus, and a pressure among the
    /// unknowns that is the one of the end of the step.
    void
    check(const InputFile &input, const bool has_pressure_of_end) const;

    /// @p automatic: what the scene has if nothing is chosen.
    VolumeUpdate
    value(const VolumeUpdate automatic) const;
  };
} // namespace seiche

#endif
