// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_reference_table_h
#define seiche_postprocess_reference_table_h

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief A measured or computed curve, value against time, from a CSV file.
   *
   * Comma separated, one header line; lines that start with "#" and rows
   * whose two fields are empty (columns of unequal length) are skipped. The
   * times must increase.
   */
  class ReferenceTable
  {
  public:
    enum class Interpolation
    {
      linear,
      spline ///< modified Akima: cubic, no overshoot beside steps
    };

    /**
     * Read the file.
     *
     * @param filename      of the table
     * @param columns       of time and value, counted from 0
     * @param factors       by which both are multiplied, to SI units
     * @param interpolation between rows
     * @param fail          called with a text ("FILE:LINE: ...") if the file
     *                      is missing or malformed; must throw
     *
     * Local.
     */
    ReferenceTable(const std::string                 &filename,
                   const std::array<unsigned int, 2> &columns,
                   const std::array<double, 2>       &factors,
                   const Interpolation                interpolation,
                   const std::function<void(const std::string &)> &fail);

    /// True if @p time lies between the first and the last row.
    bool
    covers(const double time) const;

    double
    last_time() const
    {
      return times.back();
    }

    /// Value at a time that the table covers.
    double
    value(const double time) const;

  private:
    std::vector<double>           times, values;
    std::function<double(double)> spline; // empty if linear
  };
} // namespace seiche

#endif
