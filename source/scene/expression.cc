// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/expression.h>

#include <deal.II/base/numbers.h>

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>

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



    /// What muParser would accept although it cannot be meant; the text of
    /// the problem, or empty. Fills the names that occur.
    std::string
    find_problem(const std::string &text, std::set<std::string> &names)
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
          else if (std::string("+-*/^()<>=!&|?:,;").find(c) ==
                   std::string::npos)
            return fmt::format("the character \"{}\" is not allowed.", c);
          last_name.clear();
          ++i;
        }
      return "";
    }



    /// deal.II 9.4 prints what muParser says to the screen besides throwing;
    /// users get one message only, so the text is caught for it.
    class CaughtErrorStream
    {
    public:
      CaughtErrorStream()
        : original(std::cerr.rdbuf(text.rdbuf()))
      {}

      ~CaughtErrorStream()
      {
        std::cerr.rdbuf(original);
      }

      CaughtErrorStream(const CaughtErrorStream &) = delete;
      CaughtErrorStream &
      operator=(const CaughtErrorStream &) = delete;

      /// The line that starts with "Message:", without the ornaments.
      std::string
      message() const
      {
        const std::string all   = text.str();
        const std::size_t begin = all.find('<');
        const std::size_t end   = all.find(">\n");
        if (end == std::string::npos || begin >= end)
          return "not a valid expression";
        std::string result = all.substr(begin + 1, end - begin - 1);
        while (!result.empty() && result.back() == '.')
          result.pop_back();
        return result;
      }

    private:
      std::ostringstream text;
      std::streambuf    *original;
    };
  } // namespace



  template <int dim>
  Expression<dim>::Expression(const InputFile          &input_file,
                              const std::string        &entry_path,
                              const std::string        &text,
                              const unsigned int        n_components,
                              const dealii::Point<dim> &probe)
    : input(&input_file)
    , path(entry_path)
  {
    std::set<std::string> names;
    const std::string     problem = find_problem(text, names);
    input->require(problem.empty(), path, problem);
    input->require(text.find_first_not_of(" \t") != std::string::npos,
                   path,
                   "an expression is needed.");

    const unsigned int n_given = 1 + std::count(text.begin(), text.end(), ';');
    input->require(n_given == n_components,
                   path,
                   fmt::format("{} component(s) given, {} needed, separated "
                               "by \";\".",
                               n_given,
                               n_components));
    input->require(dim == 3 || names.count("z") == 0,
                   path,
                   "z does not exist because \"Dimension\" is 2; allowed are "
                   "x, y, t.");

    with_time = names.count("t") != 0;
    constant  = !with_time && names.count("x") == 0 && names.count("y") == 0 &&
               names.count("z") == 0;
    parse_and_probe(text, n_components, probe);
  }



  template <int dim>
  void
  Expression<dim>::parse_and_probe(const std::string        &text,
                                   const unsigned int        n_components,
                                   const dealii::Point<dim> &probe)
  {
    const CaughtErrorStream caught;
    std::vector<double>     values;
    try
      {
        parser = std::make_unique<dealii::FunctionParser<dim>>(n_components);
        parser->initialize(dim == 2 ? "x,y,t" : "x,y,z,t",
                           text,
                           {{"pi", dealii::numbers::PI},
                            {"e", dealii::numbers::E}},
                           /*time_dependent=*/true);
        // deal.II parses at the first evaluation, not before
        for (unsigned int c = 0; c < n_components; ++c)
          values.push_back(parser->value(probe, c));
      }
    catch (const std::exception &)
      {
        input->fail(path,
                    fmt::format("{}; allowed are x, y{}, t, pi, e, numbers, "
                                "+ - * / ^, comparisons and the functions of "
                                "muParser.",
                                caught.message(),
                                dim == 3 ? ", z" : ""));
      }
    for (unsigned int c = 0; c < n_components; ++c)
      value(probe, 0., c); // finite?
    if (constant)
      constant_values = values;
  }



  template <int dim>
  double
  Expression<dim>::value(const dealii::Point<dim> &x,
                         const double              t,
                         const unsigned int        component) const
  {
    if (component < constant_values.size())
      return constant_values[component];
    if (with_time)
      parser->set_time(t);
    double result = std::numeric_limits<double>::quiet_NaN();
    try
      {
        result = parser->value(x, component);
      }
    catch (const std::exception &)
      {
        // an evaluation that muParser gives up is reported as not finite
      }
    if (!std::isfinite(result))
      {
        std::string where = fmt::format("x = {:g}, y = {:g}", x[0], x[1]);
        if (dim == 3)
          where += fmt::format(", z = {:g}", x[dim - 1]);
        input->fail(path,
                    fmt::format("component {} is not finite at {}, t = {:g}.",
                                component + 1,
                                where,
                                t));
      }
    return result;
  }



  template <int dim>
  dealii::Tensor<1, dim>
  Expression<dim>::vector_value(const dealii::Point<dim> &x,
                                const double              t) const
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = value(x, t, d);
    return result;
  }



  template <int dim>
  bool
  Expression<dim>::is_constant() const
  {
    return constant;
  }



  template class Expression<2>;
  template class Expression<3>;
} // namespace seiche
