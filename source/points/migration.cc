// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_cloud.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cstring>
#include <map>

// The part of PointCloud that sends points to other ranks.
namespace seiche
{
  namespace
  {
    /// Points on their way to one rank: ids, and all components of the first
    /// point, of the second one, ...
    struct Packet
    {
      std::vector<std::uint64_t> ids;
      std::vector<double>        values;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &ids &values;
      }
    };
  } // namespace



  template <int dim>
  void
  PointCloud<dim>::migrate(const std::vector<std::size_t> &emigrants)
  {
    std::map<unsigned int, Packet> sent;
    for (const std::size_t point : emigrants)
      {
        Packet &packet = sent[locator.cells.owner(point_cells[point])];
        packet.ids.push_back(point_ids[point]);
        for (const auto &array : arrays)
          packet.values.push_back(array[point]);
        point_cells[point] = invalid; // sort() drops it
      }

    for (const auto &received :
         dealii::Utilities::MPI::some_to_some(communicator, sent))
      {
        const Packet &packet = received.second;
        const double *value  = packet.values.data();
        for (const std::uint64_t id : packet.ids)
          {
            for (auto &array : arrays)
              array.push_back(*value++);
            point_ids.push_back(id);
            point_cells.push_back(invalid);
            const unsigned int cell = locator.find(position(size() - 1));
            // a cell of a third rank would be an error of the sender's ghost
            // layer; the point is dropped, and the count in locate() tells
            if (cell < locator.cells.n_owned())
              point_cells.back() = cell;
          }
      }
  }



  template <int dim>
  std::vector<char>
  PointCloud<dim>::pack_cell(const unsigned int cell) const
  {
    std::vector<char> bytes;
    const auto        append = [&bytes](const auto &value) {
      const char *begin = reinterpret_cast<const char *>(&value);
      bytes.insert(bytes.end(), begin, begin + sizeof(value));
    };
    for (const std::size_t p : points_in(cell))
      {
        append(point_ids[p]);
        for (const auto &array : arrays)
          append(array[p]);
      }
    return bytes;
  }



  template <int dim>
  void
  PointCloud<dim>::replace(const std::vector<char> &packed)
  {
    const std::uint64_t n_before = global_size;
    const std::size_t   n =
      packed.size() / (sizeof(std::uint64_t) + arrays.size() * sizeof(double));
    point_ids.resize(n);
    point_cells.assign(n, invalid);
    for (auto &array : arrays)
      array.resize(n);
    const char *next = packed.data();
    const auto  read = [&next](auto &value) {
      std::memcpy(&value, next, sizeof(value));
      next += sizeof(value);
    };
    for (std::size_t p = 0; p < n; ++p)
      {
        read(point_ids[p]);
        for (auto &array : arrays)
          read(array[p]);
      }
    relocate();
    AssertThrow(global_size == n_before,
                dealii::ExcMessage("Points were lost on the way between ranks "
                                   "when the cells were shared out."));
  }



  template void
  PointCloud<2>::migrate(const std::vector<std::size_t> &);
  template void
  PointCloud<3>::migrate(const std::vector<std::size_t> &);
  template std::vector<char>
  PointCloud<2>::pack_cell(const unsigned int) const;
  template std::vector<char>
  PointCloud<3>::pack_cell(const unsigned int) const;
  template void
  PointCloud<2>::replace(const std::vector<char> &);
  template void
  PointCloud<3>::replace(const std::vector<char> &);
} // namespace seiche
