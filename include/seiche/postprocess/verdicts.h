// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_verdicts_h
#define seiche_postprocess_verdicts_h

#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of "Verdict NAME": a bound on a number of summary.json.
  struct VerdictParameters
  {
    static constexpr const char *kind = "Verdict";
    /// Path in summary.json of the results of scores.
    static const std::string of_scores;

    std::string name;
    std::string value;                       ///< path in summary.json
    std::string at_least_text, at_most_text; ///< numbers, or empty
    double      at_least = std::numeric_limits<double>::lowest();
    double      at_most  = std::numeric_limits<double>::max();

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// Read the bounds. @p numbers: paths of all that the summary will have.
    void
    check(const InputFile &input, const std::vector<std::string> &numbers);
  };

  /// "passed" (true or false) and "failed" (a text for each verdict that the
  /// summary does not keep, or whose number it does not have). Local.
  nlohmann::ordered_json
  judge(const std::vector<VerdictParameters> &verdicts,
        const nlohmann::ordered_json         &summary);
} // namespace seiche

#endif
