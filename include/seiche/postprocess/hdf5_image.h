// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_hdf5_image_h
#define seiche_postprocess_hdf5_image_h

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief An HDF5 file made in memory but for its long arrays, to be written by
   * checked_file.
   *
   * The library prints a trace and goes on, or crashes at exit, when a disk is
   * full. Here it never touches the disk: it makes the file, with holes for the
   * arrays, in memory (/dev/shm), and their values go straight to where
   * the file is written, so that they need not be in memory at once. Every call
   * is checked; FileError names what failed. Local.
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

    /// Takes the next bytes.
    using Sink = std::function<void(const char *data, const std::size_t size)>;

    /// Gives the bytes of an array, row-major, to a sink.
    using Source = std::function<void(const Sink &)>;

    /// Array [rows] (columns = 1) or [rows][columns] of double, with its unit
    /// as an attribute. @p source is called by write().
    void
    add_doubles(const std::string &dataset,
                const std::size_t  rows,
                const unsigned int columns,
                const std::string &unit,
                const Source      &source);

    /// Array [rows] of std::uint64_t.
    void
    add_integers(const std::string &dataset,
                 const std::size_t  rows,
                 const Source      &source);

    void
    write_bytes(const std::string               &dataset,
                const std::vector<std::uint8_t> &values);

    /// The file from its first byte to its last, once.
    void
    write(const Sink &sink);

  private:
    /// Open a new file in memory, or where temporary files are, with room for
    /// headers; its name.
    std::string
    make_file();

    bool
    has_room() const;

    void
    close();

    /// Of an array, whose place in the file it gets at once.
    void
    add_array(const std::string &dataset,
              const std::size_t  rows,
              const unsigned int columns,
              const std::int64_t type,
              const std::string &unit,
              const Source      &source);

    /// An identifier of a new dataset, to be closed.
    std::int64_t
    make_dataset(const std::string &dataset,
                 const std::size_t  rows,
                 const unsigned int columns,
                 const std::int64_t type,
                 const std::string &unit);

    /// Bytes [begin, end) of the file in memory.
    void
    copy(const std::size_t begin,
         const std::size_t end,
         const Sink       &sink) const;

    void
    write_text(const std::int64_t object,
               const std::string &attribute,
               const std::string &text);

    /// @p result if it is not negative, FileError otherwise.
    std::int64_t
    check(const std::int64_t result, const std::string &action) const;

    /// Where an array stands in the file.
    struct Hole
    {
      std::size_t begin, end;
      Source      source;
    };

    const std::string name, advice;
    int               descriptor;      // of the file in memory
    std::int64_t      file;            // hid_t
    std::size_t       arrays_size = 0; // all of them, whether in it or not
    std::vector<Hole> holes;
  };
} // namespace seiche

#endif
