// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/nearest_name.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    char
    lower_case(const char c)
    {
      return (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
    }
  } // namespace



  unsigned int
  edit_distance(const std::string &a, const std::string &b)
  {
    // Optimal string alignment: three rows of the table are enough.
    std::vector<unsigned int> before(b.size() + 1), above(b.size() + 1),
      row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
      above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
      {
        const char a_i = lower_case(a[i - 1]);
        row[0]         = i;
        for (std::size_t j = 1; j <= b.size(); ++j)
          {
            const char b_j = lower_case(b[j - 1]);
            row[j]         = std::min({above[j] + 1,
                                       row[j - 1] + 1,
                                       above[j - 1] + (a_i == b_j ? 0 : 1)});
            if (i > 1 && j > 1 && a_i == lower_case(b[j - 2]) &&
                b_j == lower_case(a[i - 2]))
              row[j] = std::min(row[j], before[j - 2] + 1);
          }
        before.swap(above);
        above.swap(row);
      }
    return above[b.size()];
  }



  std::string
  nearest_name(const std::string &name, const std::vector<std::string> &known)
  {
    // longer than any entry, and the table would grow with it
    if (name.size() > 200)
      return "";
    std::string  nearest;
    unsigned int smallest =
      std::max<unsigned int>(2, (name.size() + 2) / 3) + 1;
    for (const std::string &candidate : known)
      {
        const unsigned int distance = edit_distance(name, candidate);
        if (distance < smallest && distance < candidate.size())
          {
            smallest = distance;
            nearest  = candidate;
          }
      }
    return nearest;
  }



  std::string
  nearest_hint(const std::string &name, const std::vector<std::string> &known)
  {
    const std::string nearest = nearest_name(name, known);
    return nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?";
  }



  std::string
  quoted_list(const std::vector<std::string> &names)
  {
    std::string text;
    for (const std::string &name : names)
      text += (text.empty() ? "\"" : ", \"") + name + "\"";
    return text;
  }
} // namespace seiche
