// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_frames_h
#define seiche_postprocess_frames_h

#include <seiche/postprocess/postprocessor_row.h>

namespace seiche
{
  /// Add what writes frames: grid, points, surface, series, and what pictures
  /// of them need. Nothing without an interval.
  template <int dim>
  void
  make_frames(const PostprocessorContext<dim> &context,
              const OutputParameters          &output,
              Postprocessors<dim>             &list);
} // namespace seiche

#endif
