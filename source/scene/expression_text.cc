// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/expression_text.h>

#include <fmt/format.h>

#include <cctype>
#include <vector>

namespace seiche
{
  namespace
  {
    bool
    is_name_start(const char c)
    {
      return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
    }



    bool
    is_digit(const char c)
    {
      return std::isdigit(static_cast<unsigned char>(c));
    }



    /// First character behind the number at @p i (with its exponent, so that
    /// the e of 1e3 is not taken for a name).
    std::size_t
    end_of_number(const std::string &text, std::size_t i)
    {
      while (i < text.size() && (is_digit(text[i]) || text[i] == '.'))
        ++i;
      if (i < text.size() && (text[i] == 'e' || text[i] == 'E'))
        {
          std::size_t j = i + 1;
          if (j < text.size() && (text[j] == '+' || text[j] == '-'))
            ++j;
          if (j < text.size() && is_digit(text[j]))
            {
              while (j < text.size() && is_digit(text[j]))
                ++j;
              i = j;
            }
        }
      return i;
    }



    bool
    is_comparison(const std::string &text, const std::size_t i)
    {
      const std::string before = "<>=!";
      return (i > 0 && before.find(text[i - 1]) != std::string::npos) ||
             (i + 1 < text.size() && text[i + 1] == '=');
    }
  } // namespace



  std::string
  problem_in_expression(const std::string &text, std::set<std::string> &names)
  {
    std::vector<bool> parentheses; // of a function?
    std::string       last_name;   // directly before the current character
    for (std::size_t i = 0; i < text.size();)
      {
        const char c = text[i];
        if (is_name_start(c))
          {
            std::size_t end = i;
            while (end < text.size() &&
                   (is_name_start(text[end]) || is_digit(text[end])))
              ++end;
            last_name = text.substr(i, end - i);
            if (last_name == "rand" || last_name == "rand_seed")
              return "random numbers are not reproducible and not allowed.";
            names.insert(last_name);
            i = end;
            continue;
          }
        if (is_digit(c) || c == '.')
          {
            i = std::max(end_of_number(text, i), i + 1);
            last_name.clear();
            continue;
          }
        if (std::isspace(static_cast<unsigned char>(c)))
          {
            ++i;
            continue;
          }
        if (c == '(')
          parentheses.push_back(!last_name.empty());
        else if (c == ')' && !parentheses.empty())
          parentheses.pop_back();
        else if (c == ',' && (parentheses.empty() || !parentheses.back()))
          return "a comma is allowed only between the arguments of a "
                 "function; separate components by \";\" and write 0.5, "
                 "not 0,5.";
        else if (c == '=' && !is_comparison(text, i))
          return "\"=\" assigns and is not allowed; compare with \"==\".";
        else if (std::string("+-*/^()<>=!&|?:,;").find(c) == std::string::npos)
          return fmt::format("the character \"{}\" is not allowed.", c);
        last_name.clear();
        ++i;
      }
    return "";
  }
} // namespace seiche
