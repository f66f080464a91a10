// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/posix_file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace seiche
{
  void
  posix_file::fail(const std::string &filename,
                   const std::string &action,
                   const int          error,
                   const std::size_t  bytes)
  {
    const char *advice =
      (error == ENOSPC || error == EDQUOT || error == EFBIG) ?
        "free space there, or choose another folder with --output" :
        "check the folder and its permissions, or choose another one with "
        "--output";
    const char *cause =
      error != 0 ? std::strerror(error) : "the file is cut short";
    throw FileError(
      fmt::format("{}: cannot {} ({}){}; {}.",
                  filename,
                  action,
                  cause,
                  bytes > 0 ? fmt::format(" after {} bytes", bytes) : "",
                  advice));
  }



  std::size_t
  posix_file::write_all(const int         descriptor,
                        const char       *data,
                        const std::size_t size)
  {
    std::size_t done = 0;
    while (done < size)
      {
        const ssize_t n = ::write(descriptor, data + done, size - done);
        if (n < 0 && errno == EINTR)
          continue;
        if (n <= 0)
          break;
        done += n;
      }
    return done;
  }



  int
  posix_file::open_file(const std::string &filename, const int flags)
  {
    // opening a pipe would wait for who reads it
    int descriptor;
    do
      descriptor =
        ::open(filename.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666);
    while (descriptor < 0 && errno == EINTR);
    return descriptor;
  }



  bool
  posix_file::synchronise(const int descriptor)
  {
    // some file systems cannot synchronise; that is no loss of data
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
  }



  long long
  posix_file::size_of(const int descriptor)
  {
    struct stat status = {};
    return ::fstat(descriptor, &status) == 0 ?
             static_cast<long long>(status.st_size) :
             -1;
  }
} // namespace seiche
