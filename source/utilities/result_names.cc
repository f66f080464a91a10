// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/result_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <regex>

namespace seiche
{
  namespace
  {
    namespace names = result_names;

    constexpr const char *fixed_names[] = {names::statistics,
                                           names::summary,
                                           names::parameters,
                                           names::log,
                                           names::progress,
                                           names::timing,
                                           names::references,
                                           names::paraview,
                                           names::probes,
                                           names::failure};
    constexpr const char *all_series[]  = {names::points,
                                           names::grid,
                                           names::surface,
                                           names::walls};

    // what the functions below make
    const std::regex of_samples("probe_[^/]+\\.csv");
    const std::regex of_checkpoint("checkpoint-[0-9]+\\.h5");
    const std::regex
      of_frame("_[0-9]{6,}(\\.[0-9]{4,}\\.vtu|\\.vtu|\\.pvtu|\\.h5)");

    bool
    belongs_to_series(const std::string &name)
    {
      return std::any_of(
        std::begin(all_series), std::end(all_series), [&](const auto *series) {
          const std::string stem = series;
          return name == names::index(stem) ||
                 (name.rfind(stem, 0) == 0 &&
                  std::regex_match(name.substr(stem.size()), of_frame));
        });
    }
  } // namespace



  std::string
  result_names::samples(const std::string &probe)
  {
    return "probe_" + probe + ".csv";
  }



  std::string
  result_names::index(const std::string &series)
  {
    return series + ".pvd";
  }



  std::string
  result_names::frame(const std::string &series, const unsigned int number)
  {
    return fmt::format("{}_{:06d}", series, number);
  }



  std::string
  result_names::piece(const std::string &frame, const unsigned int rank)
  {
    return fmt::format("{}.{:04d}.vtu", frame, rank);
  }



  std::string
  result_names::checkpoint(const unsigned int step)
  {
    return fmt::format("checkpoint-{:06}.h5", step);
  }



  bool
  result_names::is_checkpoint(const std::string &name)
  {
    return std::regex_match(name, of_checkpoint);
  }



  bool
  result_names::is_result(const std::string &name)
  {
    const std::string whole = checked_file::final_name(name);
    return std::find(std::begin(fixed_names), std::end(fixed_names), whole) !=
             std::end(fixed_names) ||
           belongs_to_series(whole) || is_checkpoint(whole) ||
           std::regex_match(whole, of_samples);
  }
} // namespace seiche
