// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/printable.h>
#include <seiche/utilities/svg_canvas.h>

#include <fmt/format.h>

namespace seiche
{
  namespace
  {
    constexpr std::size_t longest_text = 200;

    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char c : printable(text, longest_text))
        if (c == '<')
          result += "&lt;";
        else if (c == '>')
          result += "&gt;";
        else if (c == '&')
          result += "&amp;";
        else
          result += c;
      return result;
    }
  } // namespace

  SvgCanvas::SvgCanvas(const double width, const double height)
    : head(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" "
                       "width=\"{0:.0f}\" height=\"{1:.0f}\" "
                       "viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                       "font-family=\"sans-serif\" font-size=\"12\">\n"
                       "<rect width=\"100%\" height=\"100%\" "
                       "fill=\"white\"/>\n",
                       width,
                       height))
  {}

  void
  SvgCanvas::rectangle(const Place       &upper_left,
                       const Place       &lower_right,
                       const std::string &style)
  {
    body += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
                        "height=\"{:.2f}\" style=\"{}\"/>\n",
                        upper_left[0],
                        upper_left[1],
                        lower_right[0] - upper_left[0],
                        lower_right[1] - upper_left[1],
                        style);
  }

  void
  SvgCanvas::line(const Place &from, const Place &to, const std::string &style)
  {
    body += fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" "
                        "y2=\"{:.2f}\" style=\"{}\"/>\n",
                        from[0],
                        from[1],
                        to[0],
                        to[1],
                        style);
  }

  void
  SvgCanvas::circle(const Place       &centre,
                    const double       radius,
                    const std::string &style)
  {
    body += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" "
                        "style=\"{}\"/>\n",
                        centre[0],
                        centre[1],
                        radius,
                        style);
  }

  void
  SvgCanvas::polygons(const std::vector<std::vector<Place>> &outlines,
                      const std::string                     &style)
  {
    body += fmt::format("<path style=\"{}\" d=\"", style);
    for (const auto &outline : outlines)
      {
        const char *command = "M";
        for (const Place &place : outline)
          {
            body += fmt::format("{}{:.2f} {:.2f}", command, place[0], place[1]);
            command = "L";
          }
        body += "Z";
      }
    body += "\"/>\n";
  }

  void
  SvgCanvas::text(const Place       &place,
                  const std::string &content,
                  const std::string &anchor)
  {
    body += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" "
                        "text-anchor=\"{}\">{}</text>\n",
                        place[0],
                        place[1],
                        anchor,
                        escaped(content));
  }

  std::string
  SvgCanvas::str() const
  {
    return head + body + "</svg>\n";
  }
} // namespace seiche
