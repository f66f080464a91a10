// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/waiting_rank.h>

#include <sched.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace
{
  using namespace std::chrono_literals;
  using Clock = std::chrono::steady_clock;

  /// Two calls that lie further apart do not belong to the same wait.
  constexpr auto longest_poll = 20us;

  /// A message between free processors takes less.
  constexpr auto awake = 200us;

  constexpr auto nap = 50us;

  /// Between two looks at what else runs.
  constexpr auto look_again = 1s;

  /// True if more processes want to run than there are processors: elsewhere
  /// nobody needs the processor of a rank that waits, and a nap only makes it
  /// answer late.
  bool
  is_crowded(const Clock::time_point now)
  {
    thread_local Clock::time_point looked;
    thread_local bool              crowded = false;
    if (now - looked > look_again)
      {
        looked      = now;
        double load = 0.; // of the last minute
        crowded     = getloadavg(&load, 1) == 1 &&
                  load > 1.25 * std::thread::hardware_concurrency();
      }
    return crowded;
  }
} // namespace

/// In place of the C library's, which Open MPI calls in each poll in vain.
extern "C" int
sched_yield() noexcept
{
  thread_local Clock::time_point begin, last;
  const Clock::time_point        now = Clock::now();
  if (now - last > longest_poll)
    begin = now;
  last = now;
  if (now - begin > awake && is_crowded(now))
    {
      std::this_thread::sleep_for(nap);
      last = Clock::now();
    }
  return 0;
}

namespace seiche
{
  void
  let_waiting_ranks_sleep()
  {
    setenv("OMPI_MCA_mpi_yield_when_idle", "1", /*overwrite=*/0);
  }
} // namespace seiche
