// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/stop_signal.h>

#include <csignal>

namespace seiche
{
  namespace
  {
    struct StoppingSignal
    {
      int  number;
      bool repeats; ///< by itself: more of them ask for no more haste
    };

    constexpr StoppingSignal stopping_signals[] = {{SIGTERM, false},
                                                   {SIGINT, false},
                                                   {SIGUSR1, false},
                                                   {SIGHUP, false},
                                                   {SIGXCPU, true},
                                                   {SIGPIPE, true}};

    volatile std::sig_atomic_t was_received = 0;

    extern "C" void
    note_signal(int)
    {
      was_received = 1;
      // whoever asks twice does not want to wait
      for (const StoppingSignal &signal : stopping_signals)
        std::signal(signal.number, signal.repeats ? SIG_IGN : SIG_DFL);
    }
  } // namespace



  void
  stop_signal::install()
  {
    struct sigaction action = {}, before = {};
    action.sa_handler = note_signal;
    action.sa_flags   = SA_RESTART; // reading and writing go on
    sigemptyset(&action.sa_mask);
    for (const StoppingSignal &signal : stopping_signals)
      if (sigaction(signal.number, nullptr, &before) == 0 &&
          before.sa_handler != SIG_IGN) // as nohup has it
        sigaction(signal.number, &action, nullptr);
  }



  bool
  stop_signal::received()
  {
    return was_received != 0;
  }



  void
  stop_signal::ignore()
  {
    for (const StoppingSignal &signal : stopping_signals)
      std::signal(signal.number, SIG_IGN);
  }
} // namespace seiche
