// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_posix_file_h
#define seiche_utilities_posix_file_h

#include <cstddef>
#include <string>

namespace seiche
{
  /// Calls of the system on open files, by which checked_file, GrowingFile and
  /// DirectoryLock notice every error.
  namespace posix_file
  {
    /// FileError that names the file, the action, the cause (@p error: errno,
    /// or 0: it is cut short) and the @p bytes before it.
    [[noreturn]] void
    fail(const std::string &filename,
         const std::string &action,
         const int          error,
         const std::size_t  bytes);

    /// Bytes written of @p size: fewer on an error, which is left in errno.
    std::size_t
    write_all(const int descriptor, const char *data, const std::size_t size);

    /// Descriptor; negative on an error, which is left in errno.
    int
    open_file(const std::string &filename, const int flags);

    /// False on an error, which is left in errno.
    bool
    synchronise(const int descriptor);

    /// Size on the disk; -1 if the file cannot be asked.
    long long
    size_of(const int descriptor);
  } // namespace posix_file
} // namespace seiche

#endif
