// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/exceptions.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <locale>
#include <streambuf>

namespace seiche
{
  namespace
  {
    [[noreturn]] void
    fail(const std::string &filename,
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

    /// Bytes written of @p size: fewer on an error, which is left in errno.
    std::size_t
    write_all(const int descriptor, const char *data, const std::size_t size)
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
    open_file(const std::string &filename, const int flags)
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
    synchronise(const int descriptor)
    {
      // some file systems cannot synchronise; that is no loss of data
      return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
    }

    /// The new name survives a power cut only if the folder is on the disk.
    void
    rename_durably(const std::string &from, const std::string &to)
    {
      if (::rename(from.c_str(), to.c_str()) != 0)
        fail(to, "rename " + from, errno, 0);
      std::string folder = std::filesystem::path(to).parent_path().string();
      if (folder.empty())
        folder = ".";
      const int descriptor = open_file(folder, O_RDONLY | O_DIRECTORY);
      if (descriptor < 0)
        fail(folder, "open", errno, 0);
      const bool synchronised = synchronise(descriptor);
      const int  error        = errno;
      ::close(descriptor);
      if (!synchronised)
        fail(folder, "synchronise", error, 0);
    }

    const std::string ending_while_written = ".writing";

    std::string
    temporary_name(const std::string &filename)
    {
      return filename + ending_while_written;
    }

    /**
     * An output buffer on a file descriptor that counts bytes and remembers
     * the first error.
     */
    class DescriptorBuffer : public std::streambuf
    {
    public:
      explicit DescriptorBuffer(const int file_descriptor)
        : descriptor(file_descriptor)
      {
        setp(buffer.data(), buffer.data() + buffer.size());
      }

      std::size_t bytes = 0;
      int         error = 0;

    protected:
      int_type
      overflow(const int_type c) override
      {
        if (!flush_buffer())
          return traits_type::eof();
        if (!traits_type::eq_int_type(c, traits_type::eof()))
          {
            *pptr() = traits_type::to_char_type(c);
            pbump(1);
          }
        return traits_type::not_eof(c);
      }

      std::streamsize
      xsputn(const char *data, const std::streamsize size) override
      {
        if (size <= epptr() - pptr())
          {
            std::memcpy(pptr(), data, size);
            pbump(static_cast<int>(size));
            return size;
          }
        return flush_buffer() && write_out(data, size) ? size : 0;
      }

      int
      sync() override
      {
        return flush_buffer() ? 0 : -1;
      }

    private:
      bool
      write_out(const char *data, const std::size_t size)
      {
        const std::size_t done = write_all(descriptor, data, size);
        bytes += done;
        if (done < size && error == 0)
          error = (errno != 0 ? errno : EIO);
        return done == size;
      }

      bool
      flush_buffer()
      {
        const bool ok = write_out(pbase(), pptr() - pbase());
        setp(buffer.data(), buffer.data() + buffer.size());
        return ok;
      }

      const int                 descriptor;
      std::array<char, 1 << 16> buffer;
    };

    /// Removes a temporary file unless it became the final one.
    struct TemporaryFile
    {
      std::string name;
      int         descriptor = -1;
      bool        keep       = false;

      ~TemporaryFile()
      {
        if (descriptor >= 0)
          ::close(descriptor);
        if (!keep)
          ::unlink(name.c_str());
      }

      /// Closing may report a delayed error of the file system.
      bool
      close()
      {
        const int file = descriptor;
        descriptor     = -1;
        return ::close(file) == 0;
      }
    };

    /// Size on the disk; -1 if the file cannot be asked.
    long long
    size_of(const int descriptor)
    {
      struct stat status = {};
      return ::fstat(descriptor, &status) == 0 ?
               static_cast<long long>(status.st_size) :
               -1;
    }
  } // namespace



  std::string
  checked_file::final_name(const std::string &name)
  {
    const std::size_t ending = ending_while_written.size();
    return name.size() > ending && name.compare(name.size() - ending,
                                                ending,
                                                ending_while_written) == 0 ?
             name.substr(0, name.size() - ending) :
             name;
  }



  void
  checked_file::make_directory(const std::string &directory)
  {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (!error && !std::filesystem::is_directory(directory, error) && !error)
      error = std::make_error_code(std::errc::not_a_directory);
    if (error)
      fail(directory, "make this folder", error.value(), 0);
    if (::access(directory.c_str(), W_OK | X_OK) != 0)
      fail(directory, "write into this folder", errno, 0);
  }



  void
  checked_file::write(const std::string                         &filename,
                      const std::function<void(std::ostream &)> &fill)
  {
    TemporaryFile file{temporary_name(filename)};
    file.descriptor = open_file(file.name, O_WRONLY | O_CREAT | O_TRUNC);
    if (file.descriptor < 0)
      fail(filename, "open", errno, 0);

    DescriptorBuffer buffer(file.descriptor);
    {
      std::ostream stream(&buffer);
      stream.imbue(std::locale::classic());
      try
        {
          fill(stream);
        }
      catch (...)
        {
          // libraries that notice the failed stream do not know the cause
          if (buffer.error != 0)
            fail(filename, "write", buffer.error, buffer.bytes);
          throw;
        }
      stream.flush();
      if (!stream || buffer.error != 0)
        fail(filename, "write", buffer.error, buffer.bytes);
    }
    if (size_of(file.descriptor) != static_cast<long long>(buffer.bytes))
      fail(filename, "write", 0, buffer.bytes);
    if (!synchronise(file.descriptor))
      fail(filename, "synchronise", errno, buffer.bytes);
    if (!file.close())
      fail(filename, "close", errno, buffer.bytes);
    rename_durably(file.name, filename);
    file.keep = true;
  }



  void
  checked_file::write_by_name(
    const std::string                              &filename,
    const std::function<void(const std::string &)> &fill,
    const std::function<bool(const std::string &)> &check)
  {
    TemporaryFile file{temporary_name(filename)};
    fill(file.name);
    file.descriptor = open_file(file.name, O_RDONLY);
    if (file.descriptor < 0)
      fail(filename, "re-open", errno, 0);
    const std::size_t bytes = std::max(0LL, size_of(file.descriptor));
    if (bytes == 0 || !check(file.name))
      fail(filename, "write", 0, bytes);
    if (!synchronise(file.descriptor))
      fail(filename, "synchronise", errno, bytes);
    if (!file.close())
      fail(filename, "close", errno, bytes);
    rename_durably(file.name, filename);
    file.keep = true;
  }



  std::string
  checked_file::read(const std::string &filename, const std::size_t length)
  {
    const int descriptor = open_file(filename, O_RDONLY);
    if (descriptor < 0)
      fail(filename, "open", errno, 0);
    std::string text;
    ssize_t     n = 1;
    while (text.size() < length && n > 0)
      {
        const std::size_t begin = text.size();
        text.resize(
          begin + std::min<std::size_t>(length - begin, std::size_t(1) << 20));
        do
          n = ::read(descriptor, &text[begin], text.size() - begin);
        while (n < 0 && errno == EINTR);
        text.resize(begin + std::max<ssize_t>(n, 0));
      }
    const int error = errno;
    ::close(descriptor);
    if (n < 0)
      fail(filename, "read", error, text.size());
    if (length != static_cast<std::size_t>(-1) && text.size() < length)
      fail(filename, "read", 0, text.size());
    return text;
  }



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
    if (is_open() && !seiche::synchronise(descriptor))
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
    const bool synchronised = seiche::synchronise(descriptor);
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
