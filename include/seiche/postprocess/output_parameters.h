// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_output_parameters_h
#define seiche_postprocess_output_parameters_h

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /// prm entries of "Output" that choose frames, and what has no name.
  struct OutputParameters
  {
    double interval   = 0.; ///< [s], 0: no frames
    bool   grid       = true;
    bool   points     = true;
    bool   surface    = true;
    bool   series     = false;
    bool   mean_level = false;
    bool   verdict    = false; ///< decides over the exit code

    void
    add_parameters(dealii::ParameterHandler &prm);
  };
} // namespace seiche

#endif
