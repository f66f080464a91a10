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

  using Duration = std::chrono::microseconds;

  /// Call @p poll until @p duration has passed.
  template <typename Poll>
  void
  repeat(const Duration duration, const Poll &poll)
  {
    const auto end = std::chrono::steady_clock::now() + duration;
    while (std::chrono::steady_clock::now() < end)
      poll();
  }

  /// How often a thread that waits @p times for @p duration, and works in
  /// between, gives up its processor.
  long
  naps(const double load, const Duration duration, const unsigned int times)
  {
    load_of_test       = load;
    long        result = 0;
    std::thread waits([&]() {
      for (unsigned int i = 0; i < times; ++i)
        {
          repeat(duration, sched_yield);
          repeat(Duration(50), []() {});
        }
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
  std::cout << "crowded machine, a long wait: "
            << (naps(2. * processors, 300ms, 1) > 5 ? "naps" : "NO NAPS")
            << std::endl
            << "the same, waits of 0.1 ms: "
            << (naps(2. * processors, 100us, 1000) < 50 ? "none" : "NAPS")
            << std::endl
            << "free machine, a long wait: "
            << (naps(1. * processors, 300ms, 1) < 5 ? "none" : "NAPS")
            << std::endl;
}
