// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/hdf5_handle.h>
#include <seiche/postprocess/hdf5_image.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/posix_file.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <type_traits>

namespace seiche
{
  static_assert(std::is_same_v<hid_t, std::int64_t> ||
                  sizeof(hid_t) <= sizeof(std::int64_t),
                "identifiers of HDF5 are kept in 64 bits");
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
                "arrays go into files as they lie in memory");

  namespace
  {
    /// More than the headers and attributes of all arrays take.
    constexpr std::size_t metadata_size = std::size_t(1) << 14;
  } // namespace

  Hdf5Image::Hdf5Image(const std::string &name_in_messages,
                       const std::string &way_out)
    : name(name_in_messages)
    , advice(way_out)
    , descriptor(-1)
    , file(-1)
  {
    // failures are reported by check(), not by a trace on the screen
    check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "switch off the trace");
    const Hdf5Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "set up"),
                            H5Pclose);
    // all of it in one place, before the arrays
    check(H5Pset_meta_block_size(access.id, metadata_size), "set up");
    const std::string path = make_file();
    file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id);
    ::unlink(path.c_str());
    if (file < 0)
      close();
    check(file, "create a file");
  }

  std::string
  Hdf5Image::make_file()
  {
    // (not memfd_create(): HDF5 follows the link to it, which leads nowhere)
    const char       *temporary = std::getenv("TMPDIR");
    const std::string other     = temporary != nullptr ? temporary : "/tmp";
    int               error     = 0;
    for (const std::string &folder : {std::string("/dev/shm"), other})
      {
        std::string path = folder + "/seiche-XXXXXX";
        descriptor       = ::mkstemp(path.data());
        // room for what HDF5 could not do without when it closes the file
        if (descriptor >= 0 && has_room())
          return path;
        error = errno;
        if (descriptor >= 0)
          {
            ::close(descriptor);
            ::unlink(path.c_str());
          }
      }
    throw FileError("the header of \"" + name +
                    "\" is made in a temporary file, for which /dev/shm and " +
                    other + " have no room (" + std::strerror(error) +
                    "); free some, or set TMPDIR to a folder that has.");
  }

  bool
  Hdf5Image::has_room() const
  {
    return ::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, 0, 4 * metadata_size) ==
           0;
  }

  Hdf5Image::~Hdf5Image()
  {
    close();
  }

  void
  Hdf5Image::close()
  {
    if (file >= 0)
      H5Fclose(file);
    ::close(descriptor);
  }

  std::int64_t
  Hdf5Image::check(const std::int64_t result, const std::string &action) const
  {
    if (result < 0)
      throw FileError("HDF5 failed to " + action + " for \"" + name +
                      "\"; is there enough memory?" +
                      (advice.empty() ? "" : " " + advice + "."));
    return result;
  }

  void
  Hdf5Image::write_attribute(const std::string &attribute, const double value)
  {
    const Hdf5Handle space(check(H5Screate(H5S_SCALAR), "make a scalar"),
                           H5Sclose);
    const Hdf5Handle handle(check(H5Acreate2(file,
                                             attribute.c_str(),
                                             H5T_IEEE_F64LE,
                                             space.id,
                                             H5P_DEFAULT,
                                             H5P_DEFAULT),
                                  "make attribute " + attribute),
                            H5Aclose);
    check(H5Awrite(handle.id, H5T_NATIVE_DOUBLE, &value),
          "write attribute " + attribute);
  }

  void
  Hdf5Image::write_attribute(const std::string &attribute,
                             const std::string &text)
  {
    write_text(file, attribute, text);
  }

  void
  Hdf5Image::write_text(const std::int64_t object,
                        const std::string &attribute,
                        const std::string &text)
  {
    const Hdf5Handle type(check(H5Tcopy(H5T_C_S1), "make a text type"),
                          H5Tclose);
    check(H5Tset_size(type.id, text.size() + 1), "make a text type");
    const Hdf5Handle space(check(H5Screate(H5S_SCALAR), "make a scalar"),
                           H5Sclose);
    const Hdf5Handle handle(check(H5Acreate2(object,
                                             attribute.c_str(),
                                             type.id,
                                             space.id,
                                             H5P_DEFAULT,
                                             H5P_DEFAULT),
                                  "make attribute " + attribute),
                            H5Aclose);
    check(H5Awrite(handle.id, type.id, text.c_str()),
          "write attribute " + attribute);
  }

  std::int64_t
  Hdf5Image::make_dataset(const std::string &dataset,
                          const std::size_t  rows,
                          const unsigned int columns,
                          const std::int64_t type,
                          const std::string &unit)
  {
    // beyond this limit HDF5 would crash when it closes the file
    arrays_size += rows * columns * H5Tget_size(type);
    rlimit limit;
    if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 &&
        arrays_size + 4 * metadata_size > limit.rlim_cur)
      posix_file::fail(name, "write", EFBIG, 0);
    const hsize_t    size[2] = {rows, columns};
    const Hdf5Handle space(
      check(H5Screate_simple(columns > 1 ? 2 : 1, size, nullptr),
            "size dataset " + dataset),
      H5Sclose);
    const Hdf5Handle creation(check(H5Pcreate(H5P_DATASET_CREATE), "set up"),
                              H5Pclose);
    // the same data make the same bytes: no time stamps
    check(H5Pset_obj_track_times(creation.id, false), "set up");
    check(H5Pset_alloc_time(creation.id, H5D_ALLOC_TIME_EARLY), "set up");
    check(H5Pset_fill_time(creation.id, H5D_FILL_TIME_NEVER), "set up");
    const auto identifier = check(H5Dcreate2(file,
                                             dataset.c_str(),
                                             type,
                                             space.id,
                                             H5P_DEFAULT,
                                             creation.id,
                                             H5P_DEFAULT),
                                  "make dataset " + dataset);
    try
      {
        if (!unit.empty())
          write_text(identifier, "unit", unit);
      }
    catch (...)
      {
        H5Dclose(identifier); // or the file would not close
        throw;
      }
    return identifier;
  }

  void
  Hdf5Image::add_array(const std::string &dataset,
                       const std::size_t  rows,
                       const unsigned int columns,
                       const std::int64_t type,
                       const std::string &unit,
                       const Source      &source)
  {
    const Hdf5Handle handle(make_dataset(dataset, rows, columns, type, unit),
                            H5Dclose);
    if (rows == 0)
      return; // it has no place
    const haddr_t begin = H5Dget_offset(handle.id);
    check(begin != HADDR_UNDEF ? 0 : -1, "place dataset " + dataset);
    holes.push_back(
      {begin, begin + rows * columns * H5Tget_size(type), source});
  }

  void
  Hdf5Image::add_doubles(const std::string &dataset,
                         const std::size_t  rows,
                         const unsigned int columns,
                         const std::string &unit,
                         const Source      &source)
  {
    add_array(dataset, rows, columns, H5T_IEEE_F64LE, unit, source);
  }

  void
  Hdf5Image::add_integers(const std::string &dataset,
                          const std::size_t  rows,
                          const Source      &source)
  {
    add_array(dataset, rows, 1, H5T_STD_U64LE, "", source);
  }

  void
  Hdf5Image::write_bytes(const std::string               &dataset,
                         const std::vector<std::uint8_t> &values)
  {
    const Hdf5Handle handle(
      make_dataset(dataset, values.size(), 1, H5T_STD_U8LE, ""), H5Dclose);
    check(H5Dwrite(handle.id,
                   H5T_NATIVE_UINT8,
                   H5S_ALL,
                   H5S_ALL,
                   H5P_DEFAULT,
                   values.data()),
          "write dataset " + dataset);
  }

  void
  Hdf5Image::copy(const std::size_t begin,
                  const std::size_t end,
                  const Sink       &sink) const
  {
    std::vector<char> piece(std::size_t(1) << 16);
    for (std::size_t at = begin; at < end;)
      {
        const ssize_t n = ::pread(descriptor,
                                  piece.data(),
                                  std::min(piece.size(), end - at),
                                  at);
        check(n > 0 ? 0 : -1, "read its memory");
        sink(piece.data(), n);
        at += n;
      }
  }

  void
  Hdf5Image::write(const Sink &sink)
  {
    const auto id = file;
    file          = -1;
    check(H5Fclose(id), "complete the file");
    std::sort(holes.begin(), holes.end(), [](const Hole &a, const Hole &b) {
      return a.begin < b.begin;
    });
    std::size_t at = 0;
    for (const Hole &hole : holes)
      {
        copy(at, hole.begin, sink);
        std::size_t given = 0;
        hole.source([&](const char *data, const std::size_t size) {
          given += size;
          sink(data, size);
        });
        check(given == hole.end - hole.begin ? 0 : -1, "fill an array");
        at = hole.end;
      }
    copy(at, posix_file::size_of(descriptor), sink);
  }
} // namespace seiche
