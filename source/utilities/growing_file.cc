// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/growing_file.h>
#include <seiche/utilities/posix_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace seiche
{
  using namespace posix_file;

  GrowingFile::~GrowingFile()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }



  void
  GrowingFile::open(const std::string &name)
  {
    if (is_open())
      close();
    filename   = name;
    bytes      = 0;
    descriptor = open_file(filename, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND);
    if (descriptor < 0)
      fail(filename, "open", errno, 0);
  }



  void
  GrowingFile::continue_at(const std::string &name, const std::size_t length)
  {
    if (is_open())
      close();
    filename   = name;
    bytes      = length;
    descriptor = open_file(filename, O_WRONLY | O_APPEND);
    if (descriptor < 0)
      fail(filename, "open", errno, 0);
    const long long size = size_of(descriptor);
    if (size < static_cast<long long>(length))
      fail(filename, "go on with", 0, std::max(0LL, size));
    if (::ftruncate(descriptor, length) != 0)
      fail(filename, "shorten", errno, length);
  }



  void
  GrowingFile::synchronise()
  {
    if (is_open() && !posix_file::synchronise(descriptor))
      fail(filename, "synchronise", errno, bytes);
  }



  bool
  GrowingFile::is_open() const
  {
    return descriptor >= 0;
  }



  void
  GrowingFile::append(const std::string &text)
  {
    const std::size_t done = write_all(descriptor, text.data(), text.size());
    bytes += done;
    if (done < text.size())
      fail(filename, "write", errno, bytes);
  }



  void
  GrowingFile::close()
  {
    if (!is_open())
      return;
    const bool synchronised = posix_file::synchronise(descriptor);
    const int  error        = errno;
    const bool complete = size_of(descriptor) == static_cast<long long>(bytes);
    const bool closed   = ::close(descriptor) == 0;
    descriptor          = -1;
    if (!synchronised)
      fail(filename, "synchronise", error, bytes);
    if (!complete)
      fail(filename, "write", 0, bytes);
    if (!closed)
      fail(filename, "close", errno, bytes);
  }
} // namespace seiche
