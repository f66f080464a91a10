// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_table_row_h
#define tests_unit_table_row_h

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

#include "verdict.h"

/// A line of a table of properties: a name, then verdicts and scores.
class TableRow
{
public:
  TableRow(const std::string &name, const unsigned int name_width)
  {
    text << std::left << std::setw(name_width) << name << std::right;
  }

  void
  add(const std::string &cell)
  {
    text << std::setw(8) << cell;
  }

  void
  verdict(const bool right)
  {
    add(::verdict(right));
  }

  /// Three digits behind the point; no zero has a sign, and NaN is "none".
  void
  score(const double value)
  {
    std::ostringstream rounded;
    rounded << std::round(1000. * value) / 1000. + 0.;
    add(std::isnan(value) ? "none" : rounded.str());
  }

  /// The first three digits; what is below 1e-6 is zero.
  void
  digits(const double value)
  {
    std::ostringstream rounded;
    if (std::abs(value) < 1e-6)
      rounded << 0;
    else
      {
        const double unit =
          std::pow(10., std::floor(std::log10(std::abs(value))) - 2.);
        rounded << std::round(value / unit) * unit;
      }
    add(rounded.str());
  }

  std::ostringstream text;
};

#endif
