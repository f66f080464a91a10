// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_problems.h>
#include <seiche/utilities/exceptions.h>

#include <fmt/format.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    constexpr std::size_t most_shown = 20;
  }



  void
  throw_problems(const std::vector<std::string> &problems)
  {
    if (problems.empty())
      return;
    std::string message;
    for (std::size_t i = 0; i < std::min(problems.size(), most_shown); ++i)
      message += (i > 0 ? "\n" : "") + problems[i];
    if (problems.size() > most_shown)
      message +=
        fmt::format("\n... and {} more.", problems.size() - most_shown);
    throw InputError(message);
  }



  void
  require_all(const std::vector<std::function<void()>> &checks)
  {
    std::vector<std::string> problems;
    for (const auto &check : checks)
      try
        {
          check();
        }
      catch (const InputError &error)
        {
          // a table may be read by several
          if (std::find(problems.begin(), problems.end(), error.what()) ==
              problems.end())
            problems.emplace_back(error.what());
        }
    throw_problems(problems);
  }
} // namespace seiche
