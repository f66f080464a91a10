// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_checked_file_h
#define seiche_utilities_checked_file_h

#include <functional>
#include <ostream>
#include <string>

namespace seiche
{
  /**
   * @brief Writing files that are either whole or absent.
   *
   * Every file that matters is written under a temporary name in its own
   * directory, flushed, checked (state of the stream and size on the disk),
   * synchronised and renamed. Libraries that lose data silently on a full
   * disk are therefore never handed a file name, only a stream.
   */
  namespace checked_file
  {
    /// Create the directory with its parents; FileError if that fails or it
    /// is not writable. Local: call it on one rank.
    void
    make_directory(const std::string &directory);

    /// The name that a file has once it is whole; @p name itself if it is.
    std::string
    final_name(const std::string &name);

    /// Write @p filename by @p fill under the protocol above. FileError names
    /// the file, the bytes and the cause. Local.
    void
    write(const std::string                         &filename,
          const std::function<void(std::ostream &)> &fill);

    /// The same for a library that insists on a file name: @p fill gets the
    /// temporary name and returns only if all its calls succeeded; @p check
    /// re-opens it and returns false if something is missing.
    void
    write_by_name(const std::string                              &filename,
                  const std::function<void(const std::string &)> &fill,
                  const std::function<bool(const std::string &)> &check);

    constexpr std::size_t everything = -1;

    /// The first @p length bytes of a file; FileError if it is shorter. Local.
    std::string
    read(const std::string &filename, const std::size_t length = everything);

    /// The same, piece by piece to @p take(data, size).
    void
    read_in_pieces(
      const std::string                                          &filename,
      const std::function<void(const char *, const std::size_t)> &take,
      const std::size_t length = everything);
  } // namespace checked_file
} // namespace seiche

#endif
