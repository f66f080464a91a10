// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_hdf5_reader_h
#define seiche_postprocess_hdf5_reader_h

#include <cstdint>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief Reads what Hdf5Image has written, also in parts.
   *
   * Every call is checked; FileError names what is missing. Local.
   */
  class Hdf5Reader
  {
  public:
    explicit Hdf5Reader(const std::string &filename);
    ~Hdf5Reader();
    Hdf5Reader(const Hdf5Reader &) = delete;
    Hdf5Reader &
    operator=(const Hdf5Reader &) = delete;

    /// Number of rows of a dataset.
    std::size_t
    n_rows(const std::string &dataset) const;

    /// The rows [begin, end) of a dataset [rows] or [rows][columns], row-major.
    std::vector<double>
    doubles(const std::string &dataset,
            const unsigned int columns,
            const std::size_t  begin,
            const std::size_t  end) const;
    std::vector<std::uint64_t>
    integers(const std::string &dataset,
             const std::size_t  begin,
             const std::size_t  end) const;
    std::vector<std::uint8_t>
    bytes(const std::string &dataset) const;

  private:
    /// @p values has room for (end - begin) * columns of @p memory_type.
    void
    read(const std::string &dataset,
         const unsigned int columns,
         const std::size_t  begin,
         const std::size_t  end,
         const std::int64_t memory_type,
         void              *values) const;

    /// @p result if it is not negative, FileError otherwise.
    std::int64_t
    check(const std::int64_t result, const std::string &problem) const;

    const std::string filename;
    std::int64_t      file; // hid_t
  };
} // namespace seiche

#endif
