// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace seiche
{
  namespace entry_values
  {
    std::vector<double>
    numbers(const InputFile   &input,
            const std::string &path,
            const std::string &text)
    {
      const std::string   separators = ", \t";
      std::vector<double> result;
      std::size_t         begin = text.find_first_not_of(separators);
      while (begin != std::string::npos)
        {
          const std::size_t end =
            std::min(text.find_first_of(separators, begin), text.size());
          std::string word = text.substr(begin, end - begin);
          if (word.size() > 1 && word[0] == '+')
            word.erase(0, 1); // from_chars knows no plus sign
          double      value  = 0.;
          const char *last   = word.data() + word.size();
          const auto  parsed = std::from_chars(word.data(), last, value);
          input.require(parsed.ec == std::errc() && parsed.ptr == last &&
                          std::isfinite(value),
                        path,
                        fmt::format("\"{}\" is not a finite number; allowed "
                                    "are numbers separated by commas.",
                                    word));
          result.push_back(value);
          begin = text.find_first_not_of(separators, end);
        }
      return result;
    }



    double
    number(const InputFile   &input,
           const std::string &path,
           const std::string &text)
    {
      const std::vector<double> list = numbers(input, path, text);
      input.require(list.size() == 1,
                    path,
                    fmt::format("{} number(s) given; exactly one is needed.",
                                list.size()));
      return list[0];
    }



    std::vector<unsigned int>
    counts(const InputFile   &input,
           const std::string &path,
           const std::string &text)
    {
      std::vector<unsigned int> result;
      for (const double value : numbers(input, path, text))
        {
          input.require(value >= 1. && value == std::floor(value) &&
                          value <= std::numeric_limits<int>::max(),
                        path,
                        fmt::format("{} is not a positive integer.", value));
          result.push_back(static_cast<unsigned int>(value));
        }
      return result;
    }



    template <int dim>
    dealii::Point<dim>
    point(const InputFile   &input,
          const std::string &path,
          const std::string &text)
    {
      const std::vector<double> list = numbers(input, path, text);
      input.require(list.size() == dim,
                    path,
                    fmt::format("{} number(s) given; {} needed because "
                                "\"Dimension\" is {}.",
                                list.size(),
                                dim,
                                dim));
      dealii::Point<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = list[d];
      return result;
    }



    template dealii::Point<2>
    point<2>(const InputFile &, const std::string &, const std::string &);
    template dealii::Point<3>
    point<3>(const InputFile &, const std::string &, const std::string &);
  } // namespace entry_values
} // namespace seiche
