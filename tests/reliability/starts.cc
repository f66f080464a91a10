// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * The program, started many times at the price of one: the libraries are loaded
 * and MPI is initialised once, each start is a fork. For what needs no second
 * rank.
 *
 * starts SECONDS: a line of standard input is a file for what the start prints
 * and its arguments, separated by tabs. Answered by a line with the exit code,
 * or minus the signal (SIGALRM after SECONDS).
 */
#include <seiche/simulation/program.h>

#include <deal.II/base/mpi.h>

#include <boost/algorithm/string.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace
{
  [[noreturn]] void
  start(std::vector<std::string> &words, const unsigned int seconds)
  {
    const std::string printed = words[0];
    words[0]                  = "seiche";
    if (std::freopen("/dev/null", "r", stdin) == nullptr ||
        std::freopen(printed.c_str(), "w", stdout) == nullptr ||
        dup2(fileno(stdout), fileno(stderr)) < 0)
      _exit(99);
    alarm(seconds);
    std::vector<char *> arguments;
    for (std::string &word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int code = seiche::run_program(words.size(), arguments.data());
    std::cout << std::flush;
    _exit(code);
  }
} // namespace

int
main(int argc, char **argv)
{
  const unsigned int seconds = argc > 1 ? std::stoul(argv[1]) : 0;
  seiche::prepare_process();
  int                                      only_the_name = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(only_the_name, argv, 1);
  for (std::string line; std::getline(std::cin, line);)
    {
      std::vector<std::string> words;
      boost::split(words, line, boost::is_any_of("\t"));
      const pid_t child = fork();
      if (child == 0)
        start(words, seconds);
      int status = 0;
      if (child < 0 || waitpid(child, &status, 0) < 0)
        return 1;
      std::cout << (WIFSIGNALED(status) ? -WTERMSIG(status) :
                                          WEXITSTATUS(status))
                << std::endl;
    }
  return 0;
}
