// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_svg_canvas_h
#define seiche_utilities_svg_canvas_h

#include <array>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief A drawing in SVG: shapes in pixels from the upper left corner, each
   * with a style of CSS ("fill:#4a90c2;stroke:none").
   */
  class SvgCanvas
  {
  public:
    using Place = std::array<double, 2>; ///< right, down [px]

    SvgCanvas(const double width, const double height);

    void
    rectangle(const Place       &upper_left,
              const Place       &lower_right,
              const std::string &style);
    void
    line(const Place &from, const Place &to, const std::string &style);
    void
    circle(const Place &centre, const double radius, const std::string &style);
    /// Closed polygons as one shape.
    void
    polygons(const std::vector<std::vector<Place>> &outlines,
             const std::string                     &style);
    /// @p anchor: start, middle or end of the text is at the place.
    void
    text(const Place       &place,
         const std::string &content,
         const std::string &anchor = "start");

    /// The whole file.
    std::string
    str() const;

  private:
    std::string head, body;
  };
} // namespace seiche

#endif
