// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_cloud.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <map>

// The part of PointCloud that sends points to other ranks.
namespace seiche
{
  /// Points on their way to one rank: ids, and all components of the first
  /// point, of the second one, ...
  template <int dim>
  struct PointCloud<dim>::Packet
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



  template <int dim>
  void
  PointCloud<dim>::pack(const std::size_t point, Packet &packet)
  {
    packet.ids.push_back(point_ids[point]);
    for (const auto &array : arrays)
      packet.values.push_back(array[point]);
    point_cells[point] = invalid; // sort() drops it
  }



  template <int dim>
  void
  PointCloud<dim>::exchange(const std::map<unsigned int, Packet> &sent)
  {
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
            if (cell < locator.n_owned())
              point_cells.back() = cell;
          }
      }
  }



  template <int dim>
  void
  PointCloud<dim>::migrate(const std::vector<std::size_t> &emigrants)
  {
    std::map<unsigned int, Packet> sent;
    for (const std::size_t point : emigrants)
      pack(point, sent[locator.owner(point_cells[point])]);
    exchange(sent);
  }



  template <int dim>
  void
  PointCloud<dim>::redistribute(const std::vector<unsigned int> &new_owner)
  {
    AssertDimension(new_owner.size(), size());
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    std::map<unsigned int, Packet> sent;
    for (std::size_t p = 0; p < new_owner.size(); ++p)
      if (new_owner[p] == rank)
        point_cells[p] = locator.find(position(p));
      else
        pack(p, sent[new_owner[p]]);
    Census census;
    census.n_before = size();
    exchange(sent);
    sort();
    account(census);
  }



  template void
  PointCloud<2>::migrate(const std::vector<std::size_t> &);
  template void
  PointCloud<3>::migrate(const std::vector<std::size_t> &);
  template void
  PointCloud<2>::redistribute(const std::vector<unsigned int> &);
  template void
  PointCloud<3>::redistribute(const std::vector<unsigned int> &);
} // namespace seiche
