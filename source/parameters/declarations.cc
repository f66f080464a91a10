// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/declarations.h>
#include <seiche/parameters/nearest_name.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <cctype>
#include <regex>
#include <set>
#include <sstream>

namespace seiche
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// ParameterHandler reports paths with "_20" for a blank and "." for "/".
    std::string
    demangled(const std::string &path)
    {
      std::string result;
      for (std::size_t i = 0; i < path.size(); ++i)
        if (path[i] == '.')
          result += '/';
        else if (path[i] == '_' && i + 2 < path.size() &&
                 std::isxdigit(static_cast<unsigned char>(path[i + 1])) &&
                 std::isxdigit(static_cast<unsigned char>(path[i + 2])))
          {
            result +=
              static_cast<char>(std::stoi(path.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          result += path[i];
      return result;
    }

    void
    collect(const Json                  &node,
            const std::string           &prefix,
            const std::set<std::string> &mandatory,
            std::vector<Declaration>    &result)
    {
      for (const auto &[name, child] : node.items())
        {
          const std::string path = prefix + name;
          if (child.contains("pattern_description"))
            result.push_back({path,
                              child.value("default_value", ""),
                              child.value("documentation", ""),
                              child.value("pattern_description", ""),
                              mandatory.count(path) > 0});
          else if (!child.contains("alias"))
            collect(child, path + "/", mandatory, result);
        }
    }

    void
    collect_values(const Json                         &node,
                   const std::string                  &prefix,
                   std::map<std::string, std::string> &result)
    {
      for (const auto &[name, child] : node.items())
        if (child.contains("pattern_description"))
          result[prefix + name] = child.value("value", "");
        else if (!child.contains("alias"))
          collect_values(child, prefix + name + "/", result);
    }

    Json
    printed(const dealii::ParameterHandler &prm)
    {
      std::stringstream text;
      prm.print_parameters(text,
                           dealii::ParameterHandler::JSON |
                             dealii::ParameterHandler::KeepDeclarationOrder);
      return Json::parse(text.str());
    }

    /// ` >= 0`, ` between 0 and 1` or nothing for limits as deal.II prints
    /// them; its largest numbers mean that there is no limit, a tiny lower one
    /// that zero is excluded.
    std::string
    range_in_words(const std::string &lower, const std::string &upper)
    {
      const bool has_lower =
        !(lower == "-MAX_DOUBLE" || lower == "-2147483648");
      const bool has_upper = !(upper == "MAX_DOUBLE" || upper == "2147483647" ||
                               upper == "4294967295");
      const bool positive  = has_lower &&
                            lower.find("e-") != std::string::npos &&
                            std::stod(lower) > 0. && std::stod(lower) < 1e-30;
      if (positive)
        return " > 0" + (has_upper ? " and <= " + upper : "");
      if (has_lower && has_upper)
        return " between " + lower + " and " + upper;
      if (has_lower)
        return " >= " + lower;
      if (has_upper)
        return " <= " + upper;
      return "";
    }

    std::vector<std::string>
    selection(const std::string &pattern)
    {
      const std::string begin = "[Selection ";
      if (pattern.compare(0, begin.size(), begin) != 0)
        return {};
      const std::size_t end = pattern.rfind(']');
      return dealii::Utilities::split_string_list(
        pattern.substr(begin.size(), end - begin.size()), '|');
    }

    std::string
    pattern_in_words(const std::string &pattern)
    {
      static const std::regex number(
        R"(\[(Double|Integer range|Integer) ?(?:(\S+)\.\.\.(\S+) \(inclusive\))?\])");
      static const std::regex list(
        R"(\[List of <(.*)> of length (\d+)\.\.\.(\d+) \(inclusive\)(?: separated by <(.+)>)?\])");

      std::smatch part;
      if (std::regex_match(pattern, part, number))
        return (part[1] == "Double" ? "a number" : "an integer") +
               (part[2].matched ? range_in_words(part[2], part[3]) : "");
      if (std::regex_match(pattern, part, list))
        {
          const std::string count =
            part[2] == part[3] ? part[2].str() + " values" : "a list of values";
          return count + " separated by \"" +
                 (part[4].matched ? part[4].str() : ",") + "\", each " +
                 pattern_in_words(part[1]);
        }
      if (pattern == "[Bool]")
        return "true or false";
      if (pattern.compare(0, 9, "[FileName") == 0)
        return "a file name";
      if (pattern == "[Anything]")
        return "a text as described";
      const std::vector<std::string> names = selection(pattern);
      return names.empty() ? pattern : "one of " + quoted_list(names);
    }
  } // namespace



  std::string
  Declaration::allowed() const
  {
    return pattern_in_words(pattern);
  }



  std::vector<std::string>
  Declaration::choices() const
  {
    return selection(pattern);
  }



  bool
  Declaration::is_file() const
  {
    return pattern.compare(0, 9, "[FileName") == 0;
  }



  bool
  Declaration::accepts(const std::string &value) const
  {
    return dealii::Patterns::pattern_factory(pattern)->match(value);
  }



  std::string
  Declaration::unit() const
  {
    static const std::regex bracket(R"(\[[^\[\]]*\])");
    std::string             last;
    for (std::sregex_iterator i(text.begin(), text.end(), bracket), end;
         i != end;
         ++i)
      last = i->str();
    return last;
  }



  std::vector<Declaration>
  declarations(const dealii::ParameterHandler &prm)
  {
    std::set<std::string> mandatory;
    for (const std::string &path : prm.get_entries_wrongly_not_set())
      mandatory.insert(demangled(path));

    std::vector<Declaration> result;
    collect(printed(prm), "", mandatory, result);
    return result;
  }



  std::map<std::string, std::string>
  current_values(const dealii::ParameterHandler &prm)
  {
    std::map<std::string, std::string> result;
    collect_values(printed(prm), "", result);
    return result;
  }



  std::string
  entry_name(const std::string &path)
  {
    return path.substr(path.rfind('/') + 1);
  }



  std::string
  subsection_name(const std::string &path)
  {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
  }


  std::string
  Declaration::allowed_text() const
  {
    return "Allowed: " + allowed() + (unit().empty() ? "" : " " + unit()) + ".";
  }



  std::string
  Declaration::meaning_text() const
  {
    std::string meaning  = text;
    const auto  trim_end = [&meaning]() {
      while (!meaning.empty() &&
             (meaning.back() == '.' || meaning.back() == ' '))
        meaning.pop_back();
    };
    trim_end();
    const std::string its_unit = unit();
    if (!its_unit.empty() && meaning.size() > its_unit.size() &&
        meaning.compare(meaning.size() - its_unit.size(),
                        its_unit.size(),
                        its_unit) == 0)
      {
        meaning.resize(meaning.size() - its_unit.size());
        trim_end();
      }
    return meaning.empty() ? "" : " Meaning: " + meaning + ".";
  }



  std::string
  entry_in_words(const std::string &path)
  {
    const std::string subsection = subsection_name(path);
    return "entry \"" + entry_name(path) + "\"" +
           (subsection.empty() ? "" : " in \"" + subsection + "\"");
  }
} // namespace seiche
