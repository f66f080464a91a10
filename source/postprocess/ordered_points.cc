// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/even_ranges.h>
#include <seiche/postprocess/ordered_points.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <numeric>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr std::size_t   rows_a_message = std::size_t(1) << 16;
    constexpr std::uint64_t no_array       = -1;
    constexpr int           tag            = 7001; // of requests and rows

    /// Counts of numbers that go to each rank and come from it.
    struct Exchange
    {
      const MPI_Comm   communicator;
      std::vector<int> sent, sent_begin, received, received_begin;

      Exchange(const MPI_Comm comm, const std::vector<int> &counts)
        : communicator(comm)
        , sent(counts)
        , sent_begin(counts.size(), 0)
        , received(counts.size())
        , received_begin(counts.size(), 0)
      {
        const int error = MPI_Alltoall(
          sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, communicator);
        AssertThrowMPI(error);
        AssertThrow(std::accumulate(received.begin(), received.end(), 0.) <=
                      std::numeric_limits<int>::max(),
                    ExcMessage("more than 2^31 points on a rank"));
        std::partial_sum(sent.begin(), sent.end() - 1, sent_begin.begin() + 1);
        std::partial_sum(received.begin(),
                         received.end() - 1,
                         received_begin.begin() + 1);
      }

      /// @p values, those for rank 0 first.
      template <typename Number>
      std::vector<Number>
      operator()(const std::vector<Number> &values) const
      {
        const auto          type = Utilities::MPI::mpi_type_id_for_type<Number>;
        std::vector<Number> result(std::size_t(received_begin.back()) +
                                   received.back());
        const int           error = MPI_Alltoallv(values.data(),
                                        sent.data(),
                                        sent_begin.data(),
                                        type,
                                        result.data(),
                                        received.data(),
                                        received_begin.data(),
                                        type,
                                        communicator);
        AssertThrowMPI(error);
        return result;
      }
    };
  } // namespace

  template <int dim>
  OrderedPoints<dim>::OrderedPoints(const PointCloud<dim> &point_cloud)
    : points(point_cloud)
    , ids(point_cloud.ids())
  {
    arrays.push_back({nullptr, {}});
    for (const PointColumnInfo &info : point_column_table)
      if (points.has(info.column))
        {
          arrays.push_back({&info, {}});
          for (unsigned int c = 0; c < n_components(info.column, dim); ++c)
            arrays.back().components.push_back(points.data(info.column, c));
        }
    if (Utilities::MPI::n_mpi_processes(points.communicator) > 1)
      exchange();

    order.resize(ids.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(),
              order.end(),
              [&](const std::size_t a, const std::size_t b) {
                return ids[a] < ids[b];
              });
    rows_of_rank =
      Utilities::MPI::gather(points.communicator, std::uint64_t(ids.size()));
  }

  template <int dim>
  void
  OrderedPoints<dim>::exchange()
  {
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(points.communicator);
    const auto limits  = even_ranges(ids, points.communicator);
    const auto rank_of = [&limits](const std::uint64_t id) {
      return std::upper_bound(limits.begin(), limits.end(), id) -
             limits.begin();
    };

    std::vector<int> counts(n_ranks, 0);
    for (const std::uint64_t id : ids)
      ++counts[rank_of(id)];
    std::vector<std::size_t> next(n_ranks, 0), place(ids.size());
    std::partial_sum(counts.begin(), counts.end() - 1, next.begin() + 1);
    for (std::size_t i = 0; i < ids.size(); ++i)
      place[next[rank_of(ids[i])]++] = i;

    const Exchange exchanged(points.communicator, counts);
    const auto     by_rank = [&](const auto *values) {
      std::vector<std::remove_cv_t<std::remove_reference_t<decltype(*values)>>>
        result(place.size());
      for (std::size_t i = 0; i < place.size(); ++i)
        result[i] = values[place[i]];
      return exchanged(result);
    };
    for (Array &array : arrays)
      for (const double *&component : array.components)
        {
          received.push_back(by_rank(component));
          component = received.back().data();
        }
    ids = by_rank(ids.data());
  }

  template <int dim>
  void
  OrderedPoints<dim>::while_rows_are_handed_out(
    const std::function<void()> &write) const
  {
    if (Utilities::MPI::this_mpi_process(points.communicator) != 0)
      return hand_out();
    /// However @p write ends.
    struct End
    {
      const MPI_Comm     communicator;
      const unsigned int n_ranks;

      ~End()
      {
        const Request nothing = {no_array, 0, 0};
        for (unsigned int rank = 1; rank < n_ranks; ++rank)
          MPI_Send(&nothing, 3, MPI_UINT64_T, rank, tag, communicator);
      }
    };
    const End end = {points.communicator,
                     static_cast<unsigned int>(rows_of_rank.size())};
    write();
  }

  template <int dim>
  void
  OrderedPoints<dim>::hand_out() const
  {
    std::exception_ptr failure;
    while (true)
      {
        Request request;
        MPI_Recv(&request,
                 3,
                 MPI_UINT64_T,
                 0,
                 tag,
                 points.communicator,
                 MPI_STATUS_IGNORE);
        if (request.array == no_array)
          break;
        std::vector<char> asked; // none: there is no memory for them
        try
          {
            asked = rows(arrays[request.array], request.begin, request.end);
          }
        catch (const std::bad_alloc &)
          {
            failure = std::current_exception();
          }
        MPI_Send(
          asked.data(), asked.size(), MPI_BYTE, 0, tag, points.communicator);
      }
    if (failure)
      std::rethrow_exception(failure);
  }

  template <int dim>
  std::vector<char>
  OrderedPoints<dim>::rows(const Array      &array,
                           const std::size_t begin,
                           const std::size_t end) const
  {
    std::vector<char> result((end - begin) * array.bytes_of_row());
    char             *to     = result.data();
    const auto        append = [&to](const auto &value) {
      std::memcpy(to, &value, sizeof(value));
      to += sizeof(value);
    };
    for (std::size_t i = begin; i < end; ++i)
      if (array.info == nullptr)
        append(ids[order[i]]);
      else
        for (const double *component : array.components)
          append(component[order[i]]);
    return result;
  }

  template <int dim>
  void
  OrderedPoints<dim>::for_all_rows(const std::size_t array,
                                   const Sink       &sink) const
  {
    for (unsigned int rank = 0; rank < rows_of_rank.size(); ++rank)
      for (std::size_t begin = 0; begin < rows_of_rank[rank];
           begin += rows_a_message)
        {
          const std::size_t end =
            std::min<std::size_t>(rows_of_rank[rank], begin + rows_a_message);
          if (rank == 0)
            {
              const std::vector<char> own = rows(arrays[array], begin, end);
              sink(own.data(), own.size());
              continue;
            }
          // before rows are asked for: they must be received
          std::vector<char> theirs((end - begin) *
                                   arrays[array].bytes_of_row());
          const Request     request = {array, begin, end};
          MPI_Send(&request, 3, MPI_UINT64_T, rank, tag, points.communicator);
          MPI_Status status;
          MPI_Recv(theirs.data(),
                   theirs.size(),
                   MPI_BYTE,
                   rank,
                   tag,
                   points.communicator,
                   &status);
          int n_bytes = 0;
          MPI_Get_count(&status, MPI_BYTE, &n_bytes);
          if (n_bytes == 0)
            throw std::bad_alloc();
          sink(theirs.data(), theirs.size());
        }
  }

  template <int dim>
  void
  OrderedPoints<dim>::add_to(Hdf5Image &image) const
  {
    const std::size_t n =
      std::accumulate(rows_of_rank.begin(), rows_of_rank.end(), std::size_t(0));
    for (std::size_t k = 0; k < arrays.size(); ++k)
      {
        const PointColumnInfo *info   = arrays[k].info;
        const auto             source = [this, k](const Sink &sink) {
          for_all_rows(k, sink);
        };
        if (info == nullptr)
          image.add_integers("id", n, source);
        else
          image.add_doubles(
            info->name, n, arrays[k].components.size(), info->unit, source);
      }
  }

  template class OrderedPoints<2>;
  template class OrderedPoints<3>;
} // namespace seiche
