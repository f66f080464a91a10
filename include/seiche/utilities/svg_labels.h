// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_svg_labels_h
#define seiche_utilities_svg_labels_h

#include <seiche/utilities/svg_canvas.h>

#include <array>
#include <string>
#include <vector>

namespace seiche
{
  /// Texts of a drawing that do not cover each other.
  class SvgLabels
  {
  public:
    struct At
    {
      SvgCanvas::Place place;
      std::string      anchor; ///< as in SvgCanvas::text()
    };

    /// The canvas must outlive the object.
    explicit SvgLabels(SvgCanvas &canvas);

    void
    write(const At &at, const std::string &text);

    /// At the first of some places that is free of texts; not at all if there
    /// is none.
    void
    write_where_free(const std::vector<At> &places, const std::string &text);

  private:
    SvgCanvas &canvas;
    /// Of the texts so far: left, right, top, bottom [px].
    std::vector<std::array<double, 4>> taken;
  };
} // namespace seiche

#endif
