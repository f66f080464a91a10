// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_constitutive_volume_law_h
#define seiche_constitutive_volume_law_h

#include <cmath>

namespace seiche
{
  /**
   * @brief Volumetric strain phi(J) of the pressure law p = -kappa phi(J).
   *
   * linear: phi = J - 1, p stays finite as J -> 0; logarithmic: phi = ln J, p
   * grows without bound. Equal for small strains; with infinite kappa both mean
   * J = 1.
   */
  struct VolumeLaw
  {
    bool logarithmic = false;

    double
    strain(const double J) const
    {
      return logarithmic ? std::log(J) : J - 1.;
    }

    /// J dphi/dJ: dphi = slope div_1 du.
    double
    slope(const double J) const
    {
      return logarithmic ? 1. : J;
    }
  };

  /// Volumetric strain at J_n + share (J_1 - J_n), share the time within the
  /// step, and its derivative: dphi = slope div_1 du.
  struct VolumeStrain
  {
    double value, slope;

    VolumeStrain(const VolumeLaw &law,
                 const double     share,
                 const double     J_n,
                 const double     J_1)
    {
      const double J = J_1 - (1. - share) * (J_1 - J_n);
      value          = law.strain(J);
      slope          = share * J_1 / J * law.slope(J);
    }
  };
} // namespace seiche

#endif
