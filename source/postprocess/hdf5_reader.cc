// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/hdf5_handle.h>
#include <seiche/postprocess/hdf5_reader.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/regular_file.h>

#include <limits>

namespace seiche
{
  Hdf5Reader::Hdf5Reader(const std::string &name)
    : filename(name)
    , file(-1)
  {
    if (const std::string problem =
          problem_of_file(name, std::numeric_limits<std::uintmax_t>::max());
        !problem.empty())
      throw FileError(name + ": " + problem + ".");
    // failures are reported by check(), not by a trace on the screen
    check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "HDF5 does not start");
    file = check(H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                 "it is not an HDF5 file");
  }

  Hdf5Reader::~Hdf5Reader()
  {
    H5Fclose(file);
  }

  std::int64_t
  Hdf5Reader::check(const std::int64_t result, const std::string &problem) const
  {
    if (result < 0)
      throw FileError(filename + ": " + problem + ".");
    return result;
  }

  std::size_t
  Hdf5Reader::n_rows(const std::string &dataset) const
  {
    const std::string problem = "it has no dataset \"" + dataset + "\"";
    const Hdf5Handle  handle(check(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT),
                                  problem),
                            H5Dclose);
    const Hdf5Handle  space(check(H5Dget_space(handle.id), problem), H5Sclose);
    hsize_t           size[2] = {0, 0};
    if (check(H5Sget_simple_extent_ndims(space.id), problem) > 2)
      check(-1, "\"" + dataset + "\" has more than two dimensions");
    check(H5Sget_simple_extent_dims(space.id, size, nullptr), problem);
    return size[0];
  }

  void
  Hdf5Reader::read(const std::string &dataset,
                   const unsigned int columns,
                   const std::size_t  begin,
                   const std::size_t  end,
                   const std::int64_t memory_type,
                   void              *values) const
  {
    const std::string problem = "dataset \"" + dataset +
                                "\" is missing or has not the size that it "
                                "should have";
    const Hdf5Handle handle(check(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT),
                                  problem),
                            H5Dclose);
    const Hdf5Handle space(check(H5Dget_space(handle.id), problem), H5Sclose);
    const hsize_t    start[2] = {begin, 0};
    const hsize_t    count[2] = {end - begin, columns};
    const int        n_dims   = columns > 1 ? 2 : 1;
    if (H5Sget_simple_extent_ndims(space.id) != n_dims)
      check(-1, problem);
    check(H5Sselect_hyperslab(
            space.id, H5S_SELECT_SET, start, nullptr, count, nullptr),
          problem);
    const Hdf5Handle memory(check(H5Screate_simple(n_dims, count, nullptr),
                                  "memory is exhausted"),
                            H5Sclose);
    check(
      H5Dread(handle.id, memory_type, memory.id, space.id, H5P_DEFAULT, values),
      problem);
  }

  std::vector<double>
  Hdf5Reader::doubles(const std::string &dataset,
                      const unsigned int columns,
                      const std::size_t  begin,
                      const std::size_t  end) const
  {
    std::vector<double> values((end - begin) * columns);
    read(dataset, columns, begin, end, H5T_NATIVE_DOUBLE, values.data());
    return values;
  }

  std::vector<std::uint64_t>
  Hdf5Reader::integers(const std::string &dataset,
                       const std::size_t  begin,
                       const std::size_t  end) const
  {
    std::vector<std::uint64_t> values(end - begin);
    read(dataset, 1, begin, end, H5T_NATIVE_UINT64, values.data());
    return values;
  }

  std::vector<std::uint8_t>
  Hdf5Reader::bytes(const std::string &dataset) const
  {
    std::vector<std::uint8_t> values(n_rows(dataset));
    read(dataset, 1, 0, values.size(), H5T_NATIVE_UINT8, values.data());
    return values;
  }
} // namespace seiche
