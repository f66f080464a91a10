// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/expression.h>
#include <seiche/scene/expression_parser.h>
#include <seiche/scene/expression_text.h>
#include <seiche/scene/sample_times.h>
#include <seiche/scene/time_table.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

namespace seiche
{
  using namespace expression_parser;

  namespace
  {
    /// "the tables s(t), w(t) of this file", or how to have one.
    std::string
    tables_of(const InputFile &input)
    {
      std::string text;
      for (const std::string &name : input.instances(TableParameters::kind))
        text += (text.empty() ? "" : ", ") + name + "(t)";
      return text.empty() ? "tables of this file, of which there is none "
                            "(subsection \"Table NAME\": NAME(t))" :
                            "the tables of this file: " + text;
    }



    /// A table as a function of muParser's.
    struct Signal
    {
      const InputFile  &input;
      const std::string path; ///< of the entry that calls it
      const std::string name;
      const TimeTable   table;

      static double
      value(void *signal, const double t)
      {
        const Signal    &here  = *static_cast<const Signal *>(signal);
        const TimeTable &table = here.table;
        if (std::isfinite(t) && !table.covers(t))
          here.input.fail(
            here.path,
            fmt::format("table {} has rows from {:.6g} s to {:.6g} s and is "
                        "asked for {:.6g} s: give it more rows, or set an "
                        "earlier Time/End time; to ask for some times only "
                        "write (t < 1 ? 0 : {}(t)), as if() computes both "
                        "values.",
                        here.name,
                        table.first_time(),
                        table.last_time(),
                        t,
                        here.name));
        return std::isfinite(t) ? table.value(t) : t;
      }
    };
  } // namespace



  bool
  is_known_in_expressions(const std::string &name)
  {
    static const mu::Parser parser = parser_with_functions();
    return name.rfind("rand", 0) == 0 ||
           std::count(variables().begin(), variables().end(), name) > 0 ||
           parser.GetConst().count(name) > 0 ||
           parser.GetFunDef().count(name) > 0;
  }



  template <int dim>
  struct Expression<dim>::Parser
  {
    std::array<double, dim + 1> variables{}; // x, y[, z], t
    std::deque<Signal>          signals;
    std::vector<mu::Parser>     components;
  };



  template <int dim>
  Expression<dim>::Expression(const InputFile          &input_file,
                              const std::string        &entry_path,
                              const std::string        &text,
                              const unsigned int        n_components,
                              const dealii::Point<dim> &probe_point)
    : input(&input_file)
    , path(entry_path)
    , probe(probe_point)
    , parser(std::make_unique<Parser>())
  {
    std::set<std::string> names;
    const std::string     problem = problem_in_expression(text, names);
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
    parser->components.assign(n_components, parser_with_functions());
    define_tables(names);
    parse(text);
    std::vector<double> values;
    for (unsigned int c = 0; c < n_components; ++c)
      values.push_back(value(probe, 0., c)); // finite?
    if (constant)
      constant_values = values;
  }



  template <int dim>
  Expression<dim>::Expression(Expression &&) = default;

  template <int dim>
  Expression<dim>::~Expression() = default;



  template <int dim>
  void
  Expression<dim>::define_tables(const std::set<std::string> &names)
  {
    for (const TableParameters &table : TableParameters::all(*input))
      if (names.count(table.name) > 0)
        {
          with_corners = with_corners || table.is_linear();
          parser->signals.push_back(
            {*input, path, table.name, table.read(*input)});
          for (mu::Parser &component : parser->components)
            component.DefineFunUserData(table.name,
                                        &Signal::value,
                                        &parser->signals.back(),
                                        /*a_bAllowOpt=*/false);
        }
  }



  template <int dim>
  void
  Expression<dim>::parse(const std::string &text)
  {
    std::vector<std::string> names = variables();
    if (dim == 2)
      names.erase(names.begin() + 2);
    try
      {
        const std::vector<std::string> texts = components_of(text);
        for (unsigned int c = 0; c < parser->components.size(); ++c)
          {
            mu::Parser &component = parser->components[c];
            for (unsigned int i = 0; i < names.size(); ++i)
              component.DefineVar(names[i], &parser->variables[i]);
            component.SetExpr(c < texts.size() ? texts[c] : "");
            component.Eval(); // parses
          }
      }
    catch (const mu::ParserError &error)
      {
        input->fail(path,
                    fmt::format("{}; allowed are x, y{}, t, pi, e, numbers, "
                                "+ - * / ^, comparisons, the functions of "
                                "muParser and {}.",
                                message_of(error),
                                dim == 3 ? ", z" : "",
                                tables_of(*input)));
      }
  }



  template <int dim>
  double
  Expression<dim>::value(const dealii::Point<dim> &x,
                         const double              t,
                         const unsigned int        component) const
  {
    if (component < constant_values.size())
      return constant_values[component];
    for (unsigned int d = 0; d < dim; ++d)
      parser->variables[d] = x[d];
    parser->variables[dim] = t;
    double result          = std::numeric_limits<double>::quiet_NaN();
    try
      {
        result = parser->components[component].Eval();
      }
    catch (const mu::ParserError &)
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



  template <int dim>
  void
  Expression<dim>::check_until(const double end_time) const
  {
    if (with_time)
      for (const double t : sample_times(end_time))
        for (unsigned int c = 0; c < parser->components.size(); ++c)
          value(probe, t, c);
  }



  template <int dim>
  void
  Expression<dim>::check_motion(const dealii::Point<dim> &lower_corner,
                                const dealii::Point<dim> &upper_corner,
                                const double              end_time) const
  {
    input->require(!with_corners,
                   path,
                   "with a table of linear interpolation the velocity would "
                   "jump at each row: set its Interpolation = cubic spline.");
    for (const double t : sample_times(end_time))
      for (unsigned int c = 0; c < parser->components.size(); ++c)
        input->require(value(lower_corner, t, c) == value(upper_corner, t, c),
                       path,
                       "an expression of t alone is needed: what it moves "
                       "moves as a whole.");
  }



  template class Expression<2>;
  template class Expression<3>;
} // namespace seiche
