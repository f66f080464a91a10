// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/postprocess/verdicts.h>
#include <seiche/scene/entry_values.h>

#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  namespace
  {
    const std::string of_alarms = "largest/";

    /// The number at a path "ledger/lost_points", whose last part may have
    /// slashes of its own (units, names of scores); null if there is none.
    const nlohmann::ordered_json *
    number_at(const nlohmann::ordered_json &summary, const std::string &path)
    {
      if (summary.contains(path))
        return summary[path].is_number() ? &summary[path] : nullptr;
      const std::size_t slash = path.find('/');
      const std::string part  = path.substr(0, slash);
      if (slash == std::string::npos || !summary.contains(part))
        return nullptr;
      return number_at(summary[part], path.substr(slash + 1));
    }
  } // namespace

  const std::string VerdictParameters::of_scores = "errors/";

  void
  VerdictParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Value",
                      value,
                      "A number of summary.json by its path: errors/NAME (of a "
                      "score), ledger/energy_max_relative_gain, "
                      "ledger/lost_points, largest/seen volume, "
                      "largest/overfull, rejected_steps, ... Of those below "
                      "largest/, which have a sign, the size is judged.",
                      dealii::Patterns::Anything(),
                      /*has_to_be_set=*/true);
    prm.add_parameter("At least", at_least_text, "Smallest value that passes.");
    prm.add_parameter("At most", at_most_text, "Largest value that passes.");
  }

  void
  VerdictParameters::check(const InputFile                &input,
                           const std::vector<std::string> &numbers)
  {
    const std::string section = std::string(kind) + " " + name;
    input.require(!at_least_text.empty() || !at_most_text.empty(),
                  section + "/At most",
                  "a verdict needs a bound: set it, or \"At least\".");
    if (!at_least_text.empty())
      at_least =
        entry_values::number(input, section + "/At least", at_least_text);
    if (!at_most_text.empty())
      at_most = entry_values::number(input, section + "/At most", at_most_text);
    input.require(at_least <= at_most,
                  section + "/At most",
                  "no number can be that small and reach \"At least\".");
    const std::string hint = nearest_hint(value, numbers);
    input.require(std::find(numbers.begin(), numbers.end(), value) !=
                    numbers.end(),
                  section + "/Value",
                  "summary.json will have no such number" +
                    (hint.empty() ? "." : hint) + " Numbers are " +
                    quoted_list(numbers) +
                    ". A column of statistics.csv (of a gauge, a probe, a "
                    "front) is judged by a Score: errors/NAME.");
  }

  nlohmann::ordered_json
  judge(const std::vector<VerdictParameters> &verdicts,
        const nlohmann::ordered_json         &summary)
  {
    nlohmann::ordered_json failed = nlohmann::ordered_json::array();
    for (const VerdictParameters &verdict : verdicts)
      {
        const auto *number = number_at(summary, verdict.value);
        if (number == nullptr)
          {
            failed.push_back(fmt::format("{}: summary.json has no number {}",
                                         verdict.name,
                                         verdict.value));
            continue;
          }
        const bool   has_sign     = verdict.value.rfind(of_alarms, 0) == 0;
        const double signed_value = number->get<double>();
        const double value = has_sign ? std::abs(signed_value) : signed_value;
        // not (a > b): what is not a number does not pass
        if (!(value >= verdict.at_least && value <= verdict.at_most))
          failed.push_back(
            fmt::format("{}: {} is {:.4g}, {} {:g}",
                        verdict.name,
                        verdict.value,
                        value,
                        value < verdict.at_least ? "at least" : "at most",
                        value < verdict.at_least ? verdict.at_least :
                                                   verdict.at_most));
      }
    return {{"passed", failed.empty()}, {"failed", failed}};
  }
} // namespace seiche
