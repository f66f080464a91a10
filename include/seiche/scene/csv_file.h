// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_csv_file_h
#define seiche_scene_csv_file_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace seiche
{
  class InputFile;

  /**
   * @brief A CSV file that an entry names.
   *
   * Comma separated, one header line; empty lines and lines that start with
   * "#" are skipped.
   */
  class CsvFile
  {
  public:
    /// A line behind the header.
    struct Row
    {
      const CsvFile           &file;
      std::string              place; ///< `FILE:LINE: `, for messages
      std::vector<std::string> fields;

      /// InputError if the field is no finite number (whatever the locale).
      double
      number(const unsigned int column) const;
    };

    /// @p path: of the entry whose value is @p file, relative to the parameter
    /// file.
    CsvFile(const InputFile   &input,
            const std::string &path,
            const std::string &file);

    /// InputError if the file cannot be read or is no such table. Local.
    void
    for_each_row(const std::function<void(const Row &)> &take) const;

    /// InputError with the place of the entry.
    [[noreturn]] void
    fail(const std::string &problem) const;

    const std::string filename; ///< as the user would type it

  private:
    void
    check_header(const std::string              &line,
                 const std::vector<std::string> &fields,
                 const std::string              &place) const;

    const InputFile  &input;
    const std::string path;
  };

  /// InputError of the entry @p path if its file cannot be read: missing, a
  /// folder, larger than @p largest [bytes] or empty; else its name as the user would type it.
  std::string
  readable_file(const InputFile     &input,
                const std::string   &path,
                const std::string   &file,
                const std::uintmax_t largest = 64u << 20);
} // namespace seiche

#endif
