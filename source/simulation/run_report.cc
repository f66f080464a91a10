// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/run_report.h>
#include <seiche/simulation/summary_file.h>
#include <seiche/simulation/summary_text.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/result_names.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace seiche
{
  namespace
  {
    constexpr unsigned int warnings_kept = 100;
  } // namespace



  RunReport::RunReport(const Options &run_options,
                       const MPI_Comm mpi_communicator)
    : options(run_options)
    , communicator(mpi_communicator)
    , speaks(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    , progress_file(run_options.test_mode ? "" : run_options.directory)
    , remaining(run_options.end_time)
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
      test_log.open();
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
    remaining.measure(time, now);
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
    progress_file.update({time, options.end_time, dt, remaining.seconds()},
                         now);

    // one line per tenth in a test, per twentieth in a file
    const double parts = (options.test_mode ? 10. : 20.);
    const bool   new_part =
      std::floor(share * parts + 1e-6) > std::floor(last_share * parts + 1e-6);
    last_share = share;
    if (options.test_mode)
      {
        if (new_part)
          test_log.step(time, dt, energy, newton, krylov);
        return;
      }
    if (options.quiet ||
        !(progress_line.on_terminal ? (now - last_shown >= 1. || share >= 1.) :
                                      new_part))
      return;
    last_shown = now;
    progress_line.show(line + remaining.text_with_end());
  }



  std::string
  RunReport::time_left() const
  {
    return options.test_mode ? "" : remaining.text();
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
        progress_line.end();
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
    remaining.save_or_load(archive);
  }



  void
  RunReport::stop(const std::string &text)
  {
    if (!speaks)
      return;
    print(text);
    progress_file.end("stopped");
    test_log.close();
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
    progress_line.end();
    if (options.test_mode)
      test_log.summary(complete);
    repeat_warnings(complete);

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
        header(finished_text(complete, options.directory));
      }
    if (complete.contains("verdict")) // the last words
      header(verdict_text(complete));
    test_log.close();
    if (log.is_open())
      log.close();
  }



  void
  RunReport::repeat_warnings(nlohmann::ordered_json &complete)
  {
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
  }



  void
  RunReport::print(const std::string &text)
  {
    progress_line.end();
    header(text);
  }



  void
  RunReport::write_log(const std::string &text)
  {
    if (log.is_open())
      log.append(text);
    else if (!options.directory.empty())
      early_log += text;
  }
} // namespace seiche
