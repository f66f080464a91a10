// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_free_surface_parameters_h
#define seiche_formulation_free_surface_parameters_h

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of subsection "Free surface".
  struct FreeSurfaceParameters
  {
    double acceleration  = 0.1;  // gamma_a
    double pressure      = 0.1;  // gamma_p
    double velocity      = 0.1;  // gamma_v
    double velocity_time = 0.05; // T_v [s]
    double point_inertia = 1.;   // of the points' own extent

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const bool is_mixed) const;
  };
} // namespace seiche

#endif
