// SPDX-License-Identifier: LGPL-2.1-or-later
// Freed memory stays with the process until it is given back, though pieces
// that are still in use lie between.
#include <seiche/utilities/process_memory.h>

#include <deal.II/base/utilities.h>

#include <iostream>
#include <memory>
#include <vector>

namespace
{
  /// Resident [MiB].
  double
  resident()
  {
    dealii::Utilities::System::MemoryStats stats;
    dealii::Utilities::System::get_memory_stats(stats);
    return stats.VmRSS / 1024.;
  }

  void
  print(const std::string &what, const bool is_so)
  {
    std::cout << what << ": " << (is_so ? "yes" : "no") << std::endl;
  }
} // namespace

int
main()
{
  seiche::keep_freed_memory();
  constexpr std::size_t piece = 100000; // bytes, below the limit of mmap

  const double                         start = resident();
  std::vector<std::unique_ptr<char[]>> pieces, markers;
  for (unsigned int i = 0; i < 640; ++i) // 61 MiB with holes
    {
      pieces.push_back(std::make_unique<char[]>(piece));
      markers.push_back(std::make_unique<char[]>(/*size=*/64));
    }
  const double full = resident();
  pieces.clear();
  const double freed = resident();
  seiche::return_freed_memory();
  const double returned = resident();

  print("60 MiB in use", full - start > 60.);
  print("kept when freed", freed - start > 60.);
  print("given back, holes too", returned - start < 6.);
}
