// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_test_log_h
#define seiche_simulation_test_log_h

#include <seiche/utilities/growing_file.h>

#include <nlohmann/json.hpp>

#include <string>

namespace seiche
{
  /**
   * @brief The compact log of test mode, without times and machine data, on the
   * screen and in a file "output" in the current directory, which the test
   * driver compares. Rank 0.
   */
  class TestLog
  {
  public:
    /// Begin the file; before, lines go to the screen alone. FileError.
    void
    open();

    void
    close();

    /// A step is done; parameters as of RunReport::progress().
    void
    step(const double       time,
         const double       dt,
         const double       energy,
         const unsigned int newton,
         const unsigned int krylov);

    /// Counts, ledger and errors of the summary of a run.
    void
    summary(const nlohmann::ordered_json &complete);

  private:
    void
    line(const std::string &text);

    GrowingFile file;
  };
} // namespace seiche

#endif
