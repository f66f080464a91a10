// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_csv_curve_h
#define seiche_scene_csv_curve_h

#include <string>
#include <vector>

namespace seiche
{
  class InputFile;

  /**
   * @brief Times and values of a CSV file, in SI units.
   *
   * A CsvFile; rows whose two fields are empty (columns of unequal length) are
   * skipped. The times must increase.
   */
  struct CsvCurve
  {
    /// Texts of the entries that choose a curve, and the paths of the entries.
    struct Entries
    {
      std::string file_path, file;       ///< relative to the parameter file
      std::string columns_path, columns; ///< of time and value, from 0
      std::string factors_path, factors; ///< of both, to SI units
    };

    /// Reads the file. InputError with the place of the entry, and the line of
    /// the file, if an entry or the file is not as it should be. Local.
    CsvCurve(const InputFile &input, const Entries &entries);

    std::string         filename; ///< as the user would type it
    std::vector<double> times, values;
  };
} // namespace seiche

#endif
