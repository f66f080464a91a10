// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_hdf5_image_h
#define seiche_postprocess_hdf5_image_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief An HDF5 file made in memory, to be written by checked_file.
   *
   * The library prints a trace and goes on, or crashes at exit, when a disk is
   * full. Here it never touches the disk: the file is assembled by its memory
   * driver and handed out as bytes. Every call is checked; FileError names
   * what failed. Local.
   */
  class Hdf5Image
  {
  public:
    /// @p advice: what a user without enough memory can do (a sentence
    /// without its full stop), for messages.
    explicit Hdf5Image(const std::string &name_in_messages,
                       const std::string &advice = "");
    ~Hdf5Image();
    Hdf5Image(const Hdf5Image &) = delete;
    Hdf5Image &
    operator=(const Hdf5Image &) = delete;

    /// Scalar attribute of the file.
    void
    write_attribute(const std::string &attribute, const double value);
    void
    write_attribute(const std::string &attribute, const std::string &text);

    /// Array [rows] (columns = 1) or [rows][columns], row-major, with its
    /// unit as an attribute.
    void
    write_array(const std::string         &dataset,
                const std::vector<double> &values,
                const unsigned int         columns,
                const std::string         &unit);
    void
    write_array(const std::string                &dataset,
                const std::vector<std::uint64_t> &values);

    void
    write_bytes(const std::string               &dataset,
                const std::vector<std::uint8_t> &values);

    /// The file as bytes.
    std::vector<char>
    bytes() const;

  private:
    void
    write_dataset(const std::string &dataset,
                  const void        *values,
                  const std::size_t  rows,
                  const unsigned int columns,
                  const std::int64_t memory_type,
                  const std::int64_t file_type,
                  const std::string &unit);

    void
    write_text(const std::int64_t object,
               const std::string &attribute,
               const std::string &text);

    /// @p result if it is not negative, FileError otherwise.
    std::int64_t
    check(const std::int64_t result, const std::string &action) const;

    const std::string name, advice;
    std::int64_t      file; // hid_t
  };
} // namespace seiche

#endif
