// SPDX-License-Identifier: LGPL-2.1-or-later
// A rank that waits in Open MPI's polls leaves its processor where more
// processes want to run than there are processors, and only there. The load is
// what this test says, in place of the C library's.
#include <seiche/utilities/waiting_rank.h>

#include <sched.h>
#include <sys/resource.h>

#include <chrono>
#include <iostream>
#include <thread>

namespace
{
  double load_of_test = 0.;

  /// How often a thread that polls for @p duration gives up its processor.
  long
  naps(const double load, const std::chrono::milliseconds duration)
  {
    load_of_test       = load;
    long        result = 0;
    std::thread waits([&]() {
      const auto end = std::chrono::steady_clock::now() + duration;
      while (std::chrono::steady_clock::now() < end)
        sched_yield();
      rusage used;
      getrusage(RUSAGE_THREAD, &used);
      result = used.ru_nvcsw;
    });
    waits.join();
    return result;
  }
} // namespace

extern "C" int
getloadavg(double values[], int) noexcept
{
  values[0] = load_of_test;
  return 1;
}

int
main()
{
  using namespace std::chrono_literals;
  seiche::let_waiting_ranks_sleep();
  const double processors = std::thread::hardware_concurrency();
  std::cout << "crowded machine: naps in 300 ms: "
            << (naps(2. * processors, 300ms) > 30 ? "yes" : "NO") << std::endl
            << "free machine: "
            << (naps(1. * processors, 300ms) < 10 ? "none" : "SOME")
            << std::endl
            << "one that waits for 0.1 ms: "
            << (naps(2. * processors, 0ms) < 10 ? "none" : "SOME") << std::endl;
}
