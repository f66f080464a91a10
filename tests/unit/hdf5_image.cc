// SPDX-License-Identifier: LGPL-2.1-or-later
// What is written into an HDF5 image is read back from its file.
#include <seiche/postprocess/hdf5_image.h>
#include <seiche/utilities/checked_file.h>

#include <deal.II/base/mpi.h>

#include <hdf5.h>

#include <iostream>

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<double>        positions = {0., 1., 2., 3., 4., 5.};
  const std::vector<std::uint64_t> ids       = {7, (1ull << 60) + 1, 9};
  {
    seiche::Hdf5Image image("test");
    image.write_attribute("time", 0.25);
    image.write_attribute("origin", "unit test");
    const auto all_of = [](const auto &values) {
      return [&values](const seiche::Hdf5Image::Sink &sink) {
        for (const auto &value : values) // in pieces
          sink(reinterpret_cast<const char *>(&value), sizeof(value));
      };
    };
    image.add_integers("id", ids.size(), all_of(ids));
    image.add_doubles("position", 3, 2, "m", all_of(positions));
    image.add_doubles("none", 0, 1, "Pa", all_of(positions));
    image.write_bytes("state", {1, 2, 3});
    seiche::checked_file::write("test.h5", [&](std::ostream &out) {
      image.write([&out](const char *data, const std::size_t size) {
        out.write(data, size);
      });
    });
  }

  const hid_t file     = H5Fopen("test.h5", H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t position = H5Dopen2(file, "position", H5P_DEFAULT);
  const hid_t id       = H5Dopen2(file, "id", H5P_DEFAULT);
  const hid_t none     = H5Dopen2(file, "none", H5P_DEFAULT);
  const hid_t time     = H5Aopen(file, "time", H5P_DEFAULT);
  const hid_t unit     = H5Aopen(position, "unit", H5P_DEFAULT);
  const hid_t text     = H5Aget_type(unit);

  hsize_t                    size[2] = {0, 0};
  double                     value   = 0.;
  char                       name[8] = "";
  std::vector<double>        x(6);
  std::vector<std::uint64_t> i(3);
  H5Sget_simple_extent_dims(H5Dget_space(position), size, nullptr);
  H5Dread(position, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, x.data());
  H5Dread(id, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, i.data());
  H5Aread(time, H5T_NATIVE_DOUBLE, &value);
  H5Aread(unit, text, name);

  std::cout << "position " << size[0] << " x " << size[1] << " [" << name
            << "], same: " << (x == positions) << "\nid same: " << (i == ids)
            << "\ntime " << value << "\nempty dataset exists: " << (none >= 0)
            << std::endl;
  H5Fclose(file);
}
