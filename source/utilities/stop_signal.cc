// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/stop_signal.h>

#include <csignal>

namespace seiche
{
  namespace
  {
    constexpr int stopping_signals[] = {SIGTERM, SIGINT, SIGUSR1};

    volatile std::sig_atomic_t was_received = 0;

    extern "C" void
    note_signal(int)
    {
      was_received = 1;
      // whoever asks twice does not want to wait
      for (const int signal : stopping_signals)
        std::signal(signal, SIG_DFL);
    }
  } // namespace



  void
  stop_signal::install()
  {
    struct sigaction action = {};
    action.sa_handler       = note_signal;
    action.sa_flags         = SA_RESTART; // reading and writing go on
    sigemptyset(&action.sa_mask);
    for (const int signal : stopping_signals)
      sigaction(signal, &action, nullptr);
  }



  bool
  stop_signal::received()
  {
    return was_received != 0;
  }
} // namespace seiche
