// SPDX-License-Identifier: LGPL-2.1-or-later
// The points of all ranks in a file: in the order of their ids, each with its
// own columns, whole in spite of many messages, shared out among the ranks
// though the ids of two bodies lie far apart; and a writer that fails leaves no
// rank waiting.
#include <seiche/postprocess/hdf5_reader.h>
#include <seiche/postprocess/ordered_points.h>
#include <seiche/utilities/checked_file.h>

#include <cmath>

#include "scene_from_text.h"

namespace
{
  constexpr unsigned int dim = 2;

  double
  mark_of(const std::uint64_t id)
  {
    return 1. + double(id % 100003);
  }

  void
  write(const seiche::OrderedPoints<dim> &ordered, const std::string &name)
  {
    seiche::Hdf5Image image(name);
    ordered.add_to(image);
    seiche::checked_file::write(name, [&](std::ostream &out) {
      image.write([&out](const char *data, const std::size_t size) {
        out.write(data, size);
      });
    });
  }

  void
  read(const std::string &name, const std::size_t n)
  {
    const seiche::Hdf5Reader reader(name);
    const auto               ids = reader.integers("id", 0, n);
    const auto gradient = reader.doubles("velocity_gradient", dim * dim, 0, n);
    bool       ascend = reader.n_rows("id") == n, own = true;
    for (std::size_t i = 0; i < n; ++i)
      {
        ascend = ascend && (i == 0 || ids[i] > ids[i - 1]);
        for (unsigned int c = 0; c < dim * dim; ++c)
          own = own && gradient[dim * dim * i + c] == mark_of(ids[i]) + c;
      }
    print(n,
          " points, in order ",
          verdict(ascend),
          ", columns together ",
          verdict(own));
  }
  template <typename Action>
  void
  fails(const std::string &name, const Action &action)
  {
    bool failed = false;
    try
      {
        action();
      }
    catch (const seiche::FileError &)
      {
        failed = true;
      }
    print(name, " fails ", verdict(failed));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // more rows a rank than a message holds
  SeededScene<dim> seeded(
    "subsection Grid\n set Lower corner = 0, 0\n"
    "set Upper corner = 4, 4\n set Cell size = 0.05\nend\n"
    "subsection Fluid body a\n set Lower corner = 0, 0\n"
    "set Upper corner = 4, 3\nend\n"
    "subsection Fluid body b\n set Lower corner = 0, 3\n"
    "set Upper corner = 1, 3.5\nend\n"
    "subsection Points\n"
    "set Per cell and direction = 7\nend\n",
    1000.,
    {seiche::PointColumn::velocity_gradient});
  auto &points = seeded.points;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (unsigned int c = 0; c < dim * dim; ++c)
      points.data(seiche::PointColumn::velocity_gradient, c)[p] =
        mark_of(points.ids()[p]) + c;
  const std::size_t n = points.n_global();

  const seiche::OrderedPoints<dim> ordered(points);
  ordered.while_rows_are_handed_out([&]() { write(ordered, "points.h5"); });
  if (dealii::Utilities::MPI::this_mpi_process(points.communicator) == 0)
    read("points.h5", n);

  fails("a writer without its folder", [&]() {
    ordered.while_rows_are_handed_out(
      [&]() { write(ordered, "no such folder/points.h5"); });
  });
  fails("a writer whose disk is full after some rows", [&]() {
    ordered.while_rows_are_handed_out([&]() {
      seiche::Hdf5Image image("points.h5");
      ordered.add_to(image);
      std::size_t room = n * 8;
      image.write([&room](const char *, const std::size_t size) {
        if (size > room)
          throw seiche::FileError("full");
        room -= size;
      });
    });
  });
}
