// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/posix_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <locale>
#include <memory>
#include <streambuf>
#include <vector>

namespace seiche
{
  using namespace posix_file;

  namespace
  {
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



  void
  checked_file::read_in_pieces(
    const std::string                                          &filename,
    const std::function<void(const char *, const std::size_t)> &take,
    const std::size_t                                           length)
  {
    const int descriptor = open_file(filename, O_RDONLY);
    if (descriptor < 0)
      fail(filename, "open", errno, 0);
    const auto close_file = [](const int *file) { ::close(*file); };
    const std::unique_ptr<const int, decltype(close_file)> closing(&descriptor,
                                                                   close_file);
    std::vector<char> piece(std::size_t(1) << 20);
    std::size_t       done = 0;
    ssize_t           n    = 1;
    while (done < length && n > 0)
      {
        do
          n = ::read(descriptor,
                     piece.data(),
                     std::min(piece.size(), length - done));
        while (n < 0 && errno == EINTR);
        if (n <= 0)
          break;
        take(piece.data(), n);
        done += n;
      }
    if (n < 0)
      fail(filename, "read", errno, done);
    if (length != everything && done < length)
      fail(filename, "read", 0, done);
  }



  std::string
  checked_file::read(const std::string &filename, const std::size_t length)
  {
    std::string text;
    read_in_pieces(
      filename,
      [&text](const char *data, const std::size_t size) {
        text.append(data, size);
      },
      length);
    return text;
  }
} // namespace seiche
