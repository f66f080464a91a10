// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_expression_h
#define seiche_scene_expression_h

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace seiche
{
  class InputFile;

  /**
   * @brief A function of x, y[, z] and t typed in a parameter file.
   *
   * deal.II's FunctionParser with a checking layer: it refuses what muParser
   * would accept silently (commas between arguments that are no function's,
   * assignments, rand) and values that are not finite. Components are
   * separated by ";". Constants: pi, e.
   */
  template <int dim>
  class Expression
  {
  public:
    /// Parse and evaluate once at @p probe (default: the lower corner of the
    /// domain) at t = 0; InputError with the place of entry @p entry_path.
    /// @p input_file must outlive the expression.
    Expression(const InputFile          &input_file,
               const std::string        &entry_path,
               const std::string        &text,
               const unsigned int        n_components,
               const dealii::Point<dim> &probe = dealii::Point<dim>());

    /// One component. Throws InputError (with the place) if not finite. Not
    /// for use by several threads at once: the parser carries the time.
    double
    value(const dealii::Point<dim> &x,
          const double              t,
          const unsigned int        component = 0) const;

    /// The first dim components.
    dealii::Tensor<1, dim>
    vector_value(const dealii::Point<dim> &x, const double t) const;

    /// True if no coordinate and no t occurs: value() need not be repeated.
    bool
    is_constant() const;

  private:
    void
    parse_and_probe(const std::string        &text,
                    const unsigned int        n_components,
                    const dealii::Point<dim> &probe);

    const InputFile                             *input; // for messages
    std::string                                  path;
    std::unique_ptr<dealii::FunctionParser<dim>> parser;
    bool                                         constant  = true;
    bool                                         with_time = false;
    std::vector<double>                          constant_values;
  };
} // namespace seiche

#endif
