// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_materials_volume_law_h
#define seiche_materials_volume_law_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  /**
   * @brief Pressure law p = -kappa phi(J), with the volumetric strain phi(J)
   * (doc/theory.md (2.2)).
   *
   * linear: phi = J - 1, p stays finite as J -> 0; logarithmic: phi = ln J, p
   * grows without bound. Equal for small strains; with infinite kappa both mean
   * J = 1. All materials of a scene have the same.
   */
  struct VolumeLaw
  {
    /// kappa [Pa]; infinity in the mixed form only
    double bulk_modulus = std::numeric_limits<double>::infinity();
    bool   logarithmic  = false;

    bool
    is_incompressible() const
    {
      return std::isinf(bulk_modulus);
    }

    template <typename Number>
    Number
    strain(const Number J) const
    {
      using std::log;
      return logarithmic ? log(J) : J - 1.;
    }

    /// J of a strain. The linear law knows no strain below -1: pressures above
    /// kappa, as in an impact on soft fluid.
    double
    ratio(const double strain) const
    {
      constexpr double least = 0.05;
      return logarithmic ? std::exp(strain) : std::max(least, 1. + strain);
    }

    /// J dphi/dJ: dphi = slope div_1 du.
    template <typename Number>
    Number
    slope(const Number J) const
    {
      return logarithmic ? Number(1.) : J;
    }
  };

  /// Volumetric strain at J_n + share (J_1 - J_n), share the time within the
  /// step, and its derivative: dphi = slope div_1 du.
  template <typename Number>
  struct VolumeStrain
  {
    Number value, slope;

    VolumeStrain(const VolumeLaw &law,
                 const double     share,
                 const Number     J_n,
                 const Number     J_1)
    {
      const Number J = J_1 - (1. - share) * (J_1 - J_n);
      value          = law.strain(J);
      slope          = share * J_1 / J * law.slope(J);
    }
  };
} // namespace seiche

#endif
