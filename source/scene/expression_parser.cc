// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/expression_parser.h>

#include <deal.II/base/mu_parser_internal.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <regex>

namespace seiche
{
  mu::Parser
  expression_parser::parser_with_functions()
  {
    using namespace dealii::internal::FunctionParser;
    mu::Parser parser;
    parser.DefineFun("if", mu_if);
    parser.DefineFun("int", mu_int);
    parser.DefineFun("ceil", mu_ceil);
    parser.DefineFun("floor", mu_floor);
    parser.DefineFun("cot", mu_cot);
    parser.DefineFun("csc", mu_csc);
    parser.DefineFun("sec", mu_sec);
    parser.DefineFun("log", mu_log);
    parser.DefineFun("pow", mu_pow);
    parser.DefineFun("erf", mu_erf);
    parser.DefineFun("erfc", mu_erfc);
    parser.DefineOprt("|", mu_or, 1);
    parser.DefineOprt("&", mu_and, 2);
    parser.DefineConst("pi", dealii::numbers::PI);
    parser.DefineConst("e", dealii::numbers::E);
    return parser;
  }



  const std::vector<std::string> &
  expression_parser::variables()
  {
    static const std::vector<std::string> names = {"x", "y", "z", "t"};
    return names;
  }



  std::vector<std::string>
  expression_parser::components_of(const std::string &text)
  {
    static const std::regex blanks("([A-Za-z0-9_])\\s+\\(");
    return dealii::Utilities::split_string_list(
      std::regex_replace(text, blanks, "$1("), ';');
  }



  std::string
  expression_parser::message_of(const mu::ParserError &error)
  {
    std::string message = error.GetMsg();
    while (!message.empty() && message.back() == '.')
      message.pop_back();
    return message;
  }
} // namespace seiche
