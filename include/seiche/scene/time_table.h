// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_time_table_h
#define seiche_scene_time_table_h

#include <seiche/scene/csv_curve.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /**
   * @brief A curve, value against time, from a CSV file: a measured reference,
   * or a signal that moves something.
   */
  class TimeTable
  {
  public:
    enum class Interpolation
    {
      linear,
      akima, ///< modified Akima: one derivative, no overshoot beside steps
      cubic  ///< natural cubic spline: two continuous derivatives
    };

    /// InputError as CsvCurve, or if the interpolation needs more rows. Local.
    TimeTable(const InputFile         &input,
              const CsvCurve::Entries &entries,
              const Interpolation      interpolation);

    /// True if @p time lies between the first and the last row.
    bool
    covers(const double time) const;

    double
    first_time() const
    {
      return times.front();
    }

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

  /// prm entries of "Table NAME": a signal that expressions call as NAME(t).
  struct TableParameters
  {
    static constexpr const char *kind = "Table";

    std::string name;
    std::string file;
    std::string columns       = "0, 1";
    std::string factors       = "1, 1";
    std::string interpolation = "cubic spline";

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Reads the table; InputError for what is wrong in it. A table that no
    /// expression calls is warned about.
    void
    check(const InputFile &input) const;

    TimeTable
    read(const InputFile &input) const;

    bool
    is_linear() const
    {
      return interpolation == "linear";
    }

    /// The tables of a scene, with the values that its file gives them.
    static std::vector<TableParameters>
    all(const InputFile &input);
  };
} // namespace seiche

#endif
