// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/directory_lock.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/posix_file.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace seiche
{
  using namespace posix_file;

  DirectoryLock::~DirectoryLock()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }



  void
  DirectoryLock::acquire(const std::string &directory)
  {
    const std::string name = directory + "/.lock";
    descriptor             = open_file(name, O_RDWR | O_CREAT);
    if (descriptor < 0)
      fail(name, "open", errno, 0);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
      return;
    // file systems without locks: a run must still be possible there
    if (errno != EWOULDBLOCK)
      return;
    ::close(descriptor);
    descriptor = -1;
    throw FileError(fmt::format(
      "{}: another run is writing into this folder; wait until it has ended, "
      "or choose another folder with --output.",
      directory));
  }
} // namespace seiche
