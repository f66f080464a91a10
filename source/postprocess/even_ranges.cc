// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/even_ranges.h>

#include <algorithm>
#include <array>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr std::size_t samples_a_rank = 1000; // shares within 0.1 %
  }                                              // namespace

  std::vector<std::uint64_t>
  even_ranges(const std::vector<std::uint64_t> &ids,
              const MPI_Comm                    communicator)
  {
    // ids of bodies lie far apart: samples, each for as many points of its rank
    std::vector<std::uint64_t> sorted = ids;
    std::sort(sorted.begin(), sorted.end());
    using Sample = std::array<std::uint64_t, 2>; // id, points
    std::vector<Sample> samples;
    const std::size_t   stride = sorted.size() / samples_a_rank + 1;
    for (std::size_t i = 0; i < sorted.size(); i += stride)
      samples.push_back({{sorted[i], std::min(stride, sorted.size() - i)}});
    std::vector<Sample> all;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(communicator, samples))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    std::sort(all.begin(), all.end());
    std::uint64_t n_points = 0;
    for (const Sample &sample : all)
      n_points += sample[1];

    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    std::vector<std::uint64_t> limits;
    std::uint64_t              before = 0;
    for (const auto &[id, n] : all)
      {
        while (limits.size() + 1 < n_ranks &&
               before * n_ranks >= (limits.size() + 1) * n_points)
          limits.push_back(id);
        before += n;
      }
    limits.resize(n_ranks - 1, std::numeric_limits<std::uint64_t>::max());
    return limits;
  }
} // namespace seiche
