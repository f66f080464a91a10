// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/command_line.h>
#include <seiche/parameters/input_file.h>
#include <seiche/simulation/program.h>
#include <seiche/simulation/run.h>
#include <seiche/simulation/self_test.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/failure_text.h>
#include <seiche/utilities/printable.h>
#include <seiche/utilities/process_memory.h>
#include <seiche/utilities/waiting_rank.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>

namespace seiche
{
  namespace
  {
    constexpr std::size_t longest_line = 4000; // of a message

    /// A process that no launcher started needs neither Open MPI's daemon nor
    /// its network: half of the time before the first step, on the clock.
    void
    start_alone()
    {
      for (const char *rank :
           {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
        if (std::getenv(rank) != nullptr)
          return;
      const int keep = 0; // what the user has set
      setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
      setenv("OMPI_MCA_pml", "ob1", keep);
      setenv("OMPI_MCA_btl", "self", keep);
      // many starts at once would fall over each other making its folder
      setenv("OMPI_MCA_orte_create_session_dirs", "0", keep);
    }

    ExitCode
    run_command(const int argc, char **argv, const bool speaks)
    {
      const CommandLine command_line = parse_command_line(argc, argv);
      if (!command_line.text.empty() || command_line.print_parameters)
        {
          if (speaks)
            std::cout << (command_line.text.empty() ? parameter_text() :
                                                      command_line.text)
                      << std::flush;
          if (!std::cout)
            throw FileError("standard output cannot be written; free "
                            "space there, or give another file.");
          return ExitCode::finished;
        }
      if (command_line.self_test)
        return self_test(command_line.overrides);
      const InputFile input(command_line.filename, command_line.overrides);
      return input.dimension() == 2 ? run<2>(command_line, input) :
                                      run<3>(command_line, input);
    }

    /// True if all ranks have come here within two seconds: then all of them
    /// failed for the same reason and can end in the ordinary way.
    bool
    all_ranks_failed(const MPI_Comm communicator)
    {
      using namespace std::chrono_literals;
      MPI_Request request;
      if (MPI_Ibarrier(communicator, &request) != MPI_SUCCESS)
        return false;
      for (unsigned int i = 0; i < 2000; ++i)
        {
          int done = 0;
          if (MPI_Test(&request, &done, MPI_STATUS_IGNORE) != MPI_SUCCESS)
            return false;
          if (done != 0)
            return true;
          std::this_thread::sleep_for(1ms);
        }
      return false;
    }

    /// Say why the program ends, once, and end it on all ranks: others may be
    /// waiting for this one in a collective call, so they have to be killed.
    int
    end_after_failure(const std::string &message,
                      const ExitCode     code,
                      const MPI_Comm     communicator,
                      const bool         speaks)
    {
      const bool together = all_ranks_failed(communicator);
      // parts of what was read stand in it
      if (speaks || !together)
        std::cerr << printable(message, longest_line) << std::endl;
      if (!together)
        {
          // mpirun drops what it has not yet forwarded when it kills the ranks
          std::this_thread::sleep_for(std::chrono::milliseconds(300));
          MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
        }
      return static_cast<int>(code);
    }
  } // namespace

  void
  prepare_process()
  {
    keep_freed_memory();
    start_alone();
    let_waiting_ranks_sleep();
    // a limit of the file size shall be an error of write(), not a signal
    std::signal(SIGXFSZ, SIG_IGN);
  }

  int
  run_program(const int argc, char **argv)
  {
    MPI_Comm failures = MPI_COMM_NULL; // no other message may come between
    MPI_Comm_dup(MPI_COMM_WORLD, &failures);
    const bool speaks =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    const std::string internal_error =
      "seiche: internal error, please report it with the parameter file:\n";

    int code;
    try
      {
        code = static_cast<int>(run_command(argc, argv, speaks));
      }
    catch (const Error &error)
      {
        code =
          end_after_failure(error.what(), error.exit_code, failures, speaks);
      }
    catch (const std::exception &error)
      {
        const bool exhausted = is_exhausted_memory(error);
        code =
          end_after_failure((exhausted ? "seiche: " : internal_error) +
                              failure_text(error),
                            exhausted ? ExitCode::files : ExitCode::internal,
                            failures,
                            speaks);
      }
    catch (...) // Epetra throws numbers
      {
        code = end_after_failure(internal_error + "a library gave up.",
                                 ExitCode::internal,
                                 failures,
                                 speaks);
      }
    MPI_Comm_free(&failures);
    return code;
  }
} // namespace seiche
