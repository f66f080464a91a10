// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/run_report.h>
#include <seiche/simulation/summary_file.h>
#include <seiche/utilities/readable.h>
#include <seiche/utilities/result_names.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <iostream>

namespace seiche
{
  namespace
  {
    std::string
    clock_time(const double seconds_from_now)
    {
      const std::time_t end =
        std::time(nullptr) + static_cast<std::time_t>(seconds_from_now);
      std::tm local{};
      localtime_r(&end, &local);
      return fmt::format("{:02}:{:02}", local.tm_hour, local.tm_min);
    }

    std::size_t
    terminal_width()
    {
      winsize size{};
      return (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1) ?
               size.ws_col - 1 :
               200;
    }

    // of a step; Krylov iterations depend on rounding and on preconditioners
    constexpr unsigned int newton_range = 10, krylov_range = 200;

    /// Counts differ a little between machines: "1-10", "11-100", ...
    std::string
    count_range(const double count, const unsigned int first)
    {
      if (count <= 0.)
        return "0";
      unsigned int lower = 0, upper = first;
      while (count > upper)
        {
          lower = upper;
          upper *= 10;
        }
      return fmt::format("{}-{}", lower + 1, upper);
    }

    /// Six digits; what is only rounding error is zero.
    std::string
    rounded(const double value)
    {
      return std::abs(value) < 1e-9 ? "0" : fmt::format("{:.6g}", value);
    }

    std::string
    rounded(const nlohmann::ordered_json &value)
    {
      if (value.is_number_float())
        return rounded(value.get<double>());
      if (!value.is_array())
        return value.dump();
      std::string text;
      for (const auto &entry : value)
        text += (text.empty() ? "" : " ") + rounded(entry);
      return text;
    }

    /// What the last line says of the alarms of a summary.
    std::string
    alarm_text(const nlohmann::ordered_json &summary)
    {
      std::string text;
      if (summary.contains("alarms"))
        for (const auto &[name, value] : summary["alarms"].items())
          text += fmt::format("{} {} {:.2g} %",
                              text.empty() ? "; BEWARE:" : ",",
                              name,
                              100. * value.get<double>());
      return text;
    }

    /// What a line says of the verdicts of a summary.
    std::string
    verdict_text(const nlohmann::ordered_json &summary)
    {
      std::string text;
      for (const auto &failed : summary["verdict"]["failed"])
        text += (text.empty() ? "FAILED: " : "; ") + failed.get<std::string>();
      return "verdict: " + (text.empty() ? "passed" : text);
    }

    constexpr unsigned int warnings_kept    = 100;
    constexpr double       longest_estimate = 1e8; // [s]
  }                                                // namespace



  RunReport::RunReport(const Options &run_options,
                       const MPI_Comm mpi_communicator)
    : options(run_options)
    , communicator(mpi_communicator)
    , speaks(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    , on_terminal(isatty(STDOUT_FILENO) == 1)
    , progress_file(run_options.test_mode ? "" : run_options.directory)
    , rate_wall(wall_clock())
  {}



  void
  RunReport::open_files(const bool goes_on)
  {
    if (!options.directory.empty())
      {
        const std::string name = options.directory + "/" + result_names::log;
        if (goes_on && std::filesystem::exists(name))
          log.continue_at(name, std::filesystem::file_size(name));
        else
          log.open(name);
        log.append(early_log);
        for (const char *of_finished :
             {result_names::summary, result_names::timing})
          std::filesystem::remove(options.directory + "/" + of_finished);
      }
    if (options.test_mode)
      test_output.open("output");
  }



  void
  RunReport::header(const std::string &text)
  {
    if (!speaks)
      return;
    const std::string end = (!text.empty() && text.back() == '\n') ? "" : "\n";
    if (!options.test_mode && !options.quiet)
      std::cout << text << end << std::flush;
    write_log(text + end);
  }



  void
  RunReport::progress(const double       time,
                      const double       dt,
                      const unsigned int newton,
                      const unsigned int krylov,
                      const double       energy)
  {
    if (!speaks)
      return;
    const double now   = wall_clock();
    const double share = time < options.end_time ? time / options.end_time : 1.;

    // simulated seconds per wall second, averaged over some 20 steps
    const double new_rate =
      (time - rate_time) / std::max(now - rate_wall, 1e-9);
    rate      = (rate == 0. ? new_rate : rate + 0.05 * (new_rate - rate));
    rate_wall = now;
    rate_time = time;

    const std::string line =
      fmt::format("{:3.0f} % | t {:.4g} of {:.4g} s | dt {:.1e} | "
                  "Newton {}, Krylov {} | energy {}",
                  std::floor(100. * share + 1e-9),
                  time,
                  options.end_time,
                  dt,
                  newton,
                  krylov,
                  // at rest and without gravity there is nothing to relate to
                  std::isfinite(energy) ? fmt::format("{:.4f}", energy) : "-");
    write_log(line + "\n");
    const double left = seconds_left();
    progress_file.update({time, options.end_time, dt, left}, now);

    // one line per tenth in a test, per twentieth in a file
    const double parts = (options.test_mode ? 10. : 20.);
    const bool   new_part =
      std::floor(share * parts + 1e-6) > std::floor(last_share * parts + 1e-6);
    last_share = share;
    if (options.test_mode)
      {
        if (new_part)
          test_line(fmt::format("t {} dt {} energy {} Newton {} Krylov {}",
                                rounded(time),
                                rounded(dt),
                                rounded(energy),
                                count_range(newton, newton_range),
                                count_range(krylov, krylov_range)));
        return;
      }
    if (options.quiet ||
        !(on_terminal ? (now - last_shown >= 1. || share >= 1.) : new_part))
      return;
    last_shown = now;

    std::string text = line;
    if (left > 0. && left < longest_estimate)
      text += fmt::format(" | {} left, ends {}",
                          readable_duration(left),
                          clock_time(left));
    if (!on_terminal)
      {
        std::cout << text << std::endl;
        return;
      }
    text                    = text.substr(0, terminal_width());
    const std::size_t width = text.size();
    if (width < progress_width)
      text.append(progress_width - width, ' ');
    progress_width = width;
    std::cout << '\r' << text << std::flush;
  }



  double
  RunReport::seconds_left() const
  {
    return (options.end_time - rate_time) / std::max(rate, 1e-300);
  }



  std::string
  RunReport::time_left() const
  {
    const double left = seconds_left();
    if (options.test_mode || std::isnan(left))
      return "";
    return left < longest_estimate ?
             ", " + readable_duration(left) + " left" :
             ", more than " + readable_duration(longest_estimate) + " left";
  }



  void
  RunReport::note(const std::string &text, const std::string &detail)
  {
    if (speaks)
      print(text + (detail.empty() ? "" : " (" + detail + ")"));
  }



  void
  RunReport::warn(const std::string &text, const std::string &detail)
  {
    if (!speaks)
      return;
    const auto known =
      std::find_if(warnings.begin(), warnings.end(), [&](const auto &warning) {
        return warning.first == text;
      });
    if (known != warnings.end())
      {
        ++known->second;
        return;
      }
    // a text that is new in every step must not fill memory and screen
    if (warnings.size() == warnings_kept)
      return;
    warnings.emplace_back(text, 1);
    const std::string line =
      "warning: " + text + (detail.empty() ? "" : " (" + detail + ")");
    print(line);
    if (options.quiet)
      std::cerr << line << std::endl;
  }



  void
  RunReport::fail(const std::string &text) noexcept
  {
    try
      {
        if (!speaks)
          return;
        end_progress_line();
        write_log(text + "\n");
        progress_file.end("failed");
      }
    catch (...)
      {
        // the failure that is being reported matters more
      }
  }



  void
  RunReport::save_or_load(StateArchive &archive)
  {
    archive("warnings", warnings);
    archive("share", last_share);
    archive("time", rate_time);
    if (archive.loading())
      rate_wall = wall_clock();
  }



  void
  RunReport::stop(const std::string &text)
  {
    if (!speaks)
      return;
    print(text);
    progress_file.end("stopped");
    if (test_output.is_open())
      test_output.close();
    if (log.is_open())
      log.close();
  }



  void
  RunReport::finish(const nlohmann::ordered_json &summary,
                    const TimerTree              &timer)
  {
    nlohmann::ordered_json complete =
      complete_summary(summary, timer, communicator);
    if (!speaks)
      return;
    end_progress_line();
    if (options.test_mode)
      test_summary(complete);
    if (complete.contains("warnings")) // of scores
      for (const auto &text : complete["warnings"])
        print("warning: " + text.get<std::string>());
    for (const auto &[text, count] : warnings)
      {
        complete["warnings"].push_back(
          count > 1 ? fmt::format("{} times: {}", count, text) : text);
        if (count > 1)
          print(fmt::format("warning: {} times: {}", count, text));
      }

    const std::string times = timer.report();
    header("\n" + times);
    if (!options.directory.empty())
      {
        checked_file::write(options.directory + "/" + result_names::timing,
                            [&](std::ostream &stream) { stream << times; });
        checked_file::write(options.directory + "/" + result_names::summary,
                            [&](std::ostream &stream) {
                              stream << complete.dump(2) << '\n';
                            });
        progress_file.end("finished");
        header(
          fmt::format("finished{2}: results are in {0}/; look at "
                      "{0}/summary.json and {0}/statistics.csv{1}",
                      options.directory,
                      alarm_text(complete),
                      complete.contains("empty_since") ?
                        fmt::format(", for no fluid is left since t = "
                                    "{:.6g} s",
                                    complete["empty_since"].get<double>()) :
                        ""));
      }
    if (complete.contains("verdict")) // the last words
      header(verdict_text(complete));
    if (test_output.is_open())
      test_output.close();
    if (log.is_open())
      log.close();
  }



  void
  RunReport::print(const std::string &text)
  {
    end_progress_line();
    header(text);
  }



  void
  RunReport::end_progress_line()
  {
    if (progress_width > 0)
      std::cout << std::endl;
    progress_width = 0;
  }



  void
  RunReport::write_log(const std::string &text)
  {
    if (log.is_open())
      log.append(text);
    else if (!options.directory.empty())
      early_log += text;
  }



  void
  RunReport::test_line(const std::string &text)
  {
    std::cout << text << std::endl;
    if (test_output.is_open())
      test_output.append(text + "\n");
  }



  void
  RunReport::test_summary(const nlohmann::ordered_json &summary)
  {
    for (const char *key : {"dim",
                            "points",
                            "cells",
                            "occupied_cells_max",
                            "end_time",
                            "steps",
                            "rejected_steps",
                            "accepted_failing_steps",
                            "points_held_back"})
      if (summary.contains(key))
        test_line(fmt::format("{} {}", key, rounded(summary[key])));

    const double steps = std::max(1., summary.value("steps", 1.));
    for (const auto &[key, width] :
         {std::make_pair("newton_iterations", newton_range),
          std::make_pair("krylov_iterations", krylov_range)})
      if (summary.contains(key) && summary[key].is_number())
        test_line(
          fmt::format("{} per step {}",
                      key,
                      count_range(summary[key].get<double>() / steps, width)));

    for (const char *part : {"ledger", "errors"})
      if (summary.contains(part))
        for (const auto &[name, value] : summary[part].items())
          test_line(fmt::format("{} {} {}", part, name, rounded(value)));
  }
} // namespace seiche
