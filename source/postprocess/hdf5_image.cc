// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/hdf5_handle.h>
#include <seiche/postprocess/hdf5_image.h>
#include <seiche/utilities/exceptions.h>

#include <type_traits>

namespace seiche
{
  static_assert(std::is_same_v<hid_t, std::int64_t> ||
                  sizeof(hid_t) <= sizeof(std::int64_t),
                "identifiers of HDF5 are kept in 64 bits");

  Hdf5Image::Hdf5Image(const std::string &name_in_messages,
                       const std::string &way_out)
    : name(name_in_messages)
    , advice(way_out)
    , file(-1)
  {
    // failures are reported by check(), not by a trace on the screen
    check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "switch off the trace");
    const Hdf5Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "set up"),
                            H5Pclose);
    check(H5Pset_fapl_core(access.id,
                           /*increment=*/std::size_t(1) << 20,
                           /*backing_store=*/false),
          "set up the memory driver");
    file = check(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id),
                 "create");
  }

  Hdf5Image::~Hdf5Image()
  {
    H5Fclose(file);
    // HDF5 keeps freed buffers by size, and those of a checkpoint grow
    H5garbage_collect();
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

  void
  Hdf5Image::write_dataset(const std::string &dataset,
                           const void        *values,
                           const std::size_t  rows,
                           const unsigned int columns,
                           const std::int64_t memory_type,
                           const std::int64_t file_type,
                           const std::string &unit)
  {
    const hsize_t    size[2] = {rows, columns};
    const Hdf5Handle space(
      check(H5Screate_simple(columns > 1 ? 2 : 1, size, nullptr),
            "size dataset " + dataset),
      H5Sclose);
    // the same data make the same bytes: no time stamps
    const Hdf5Handle creation(check(H5Pcreate(H5P_DATASET_CREATE), "set up"),
                              H5Pclose);
    check(H5Pset_obj_track_times(creation.id, false), "set up");
    const Hdf5Handle handle(check(H5Dcreate2(file,
                                             dataset.c_str(),
                                             file_type,
                                             space.id,
                                             H5P_DEFAULT,
                                             creation.id,
                                             H5P_DEFAULT),
                                  "make dataset " + dataset),
                            H5Dclose);
    check(
      H5Dwrite(handle.id, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
      "write dataset " + dataset);
    if (!unit.empty())
      write_text(handle.id, "unit", unit);
  }

  void
  Hdf5Image::write_array(const std::string         &dataset,
                         const std::vector<double> &values,
                         const unsigned int         columns,
                         const std::string         &unit)
  {
    write_dataset(dataset,
                  values.data(),
                  values.size() / columns,
                  columns,
                  H5T_NATIVE_DOUBLE,
                  H5T_IEEE_F64LE,
                  unit);
  }

  void
  Hdf5Image::write_array(const std::string                &dataset,
                         const std::vector<std::uint64_t> &values)
  {
    write_dataset(dataset,
                  values.data(),
                  values.size(),
                  1,
                  H5T_NATIVE_UINT64,
                  H5T_STD_U64LE,
                  "");
  }

  void
  Hdf5Image::write_bytes(const std::string               &dataset,
                         const std::vector<std::uint8_t> &values)
  {
    write_dataset(dataset,
                  values.data(),
                  values.size(),
                  1,
                  H5T_NATIVE_UINT8,
                  H5T_STD_U8LE,
                  "");
  }

  std::vector<char>
  Hdf5Image::bytes() const
  {
    check(H5Fflush(file, H5F_SCOPE_GLOBAL), "complete the file");
    const auto size =
      check(H5Fget_file_image(file, nullptr, 0), "measure the file");
    std::vector<char> image(size);
    check(H5Fget_file_image(file, image.data(), image.size()), "copy the file");
    return image;
  }
} // namespace seiche
