// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/svg_labels.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    constexpr double of_letter = 6.5, above = 10., below = 3.; // [px]

    /// Left, right, top, bottom of a text, about [px].
    std::array<double, 4>
    extent(const SvgLabels::At &at, const std::string &text)
    {
      const double width = of_letter * static_cast<double>(text.size());
      const double left  = at.place[0] - (at.anchor == "start" ? 0. :
                                          at.anchor == "end"   ? width :
                                                                 0.5 * width);
      return {{left, left + width, at.place[1] - above, at.place[1] + below}};
    }
  } // namespace

  SvgLabels::SvgLabels(SvgCanvas &svg_canvas)
    : canvas(svg_canvas)
  {}

  void
  SvgLabels::write(const At &at, const std::string &text)
  {
    taken.push_back(extent(at, text));
    canvas.text(at.place, text, at.anchor);
  }

  void
  SvgLabels::write_where_free(const std::vector<At> &places,
                              const std::string     &text)
  {
    const auto is_free = [&](const At &at) {
      const auto mine = extent(at, text);
      return std::none_of(taken.begin(), taken.end(), [&](const auto &other) {
        return mine[0] < other[1] && other[0] < mine[1] && mine[2] < other[3] &&
               other[2] < mine[3];
      });
    };
    const auto at = std::find_if(places.begin(), places.end(), is_free);
    if (at != places.end())
      write(*at, text);
  }
} // namespace seiche
