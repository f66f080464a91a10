// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_expression_h
#define seiche_scene_expression_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace seiche
{
  class InputFile;

  /// True for variables, constants and functions of expressions: no table may
  /// have such a name.
  bool
  is_known_in_expressions(const std::string &name);

  /**
   * @brief A function of x, y[, z] and t typed in a parameter file.
   *
   * muParser with a checking layer: it refuses what muParser would accept
   * silently (commas between arguments that are no function's, assignments,
   * rand) and values that are not finite. Components are separated by ";".
   * Constants: pi, e. Functions: muParser's, those that deal.II adds, and the
   * tables of the file ("Table NAME") by their names.
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
    Expression(Expression &&);
    ~Expression();

    /// One component. Throws InputError (with the place) if not finite, or if
    /// a table does not cover the time. Not for use by several threads at
    /// once: the parser carries the variables.
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

    /// Look at all components at the probe over a run: InputError for values
    /// that are not finite and tables that end earlier.
    void
    check_until(const double end_time) const;

    /// InputError unless the expression can move something in the box of these
    /// corners for the whole run: of t alone, no table of linear interpolation.
    void
    check_motion(const dealii::Point<dim> &lower_corner,
                 const dealii::Point<dim> &upper_corner,
                 const double              end_time) const;

  private:
    struct Parser; // muParser's, the variables and the tables

    void
    define_tables(const std::set<std::string> &names);
    void
    parse(const std::string &text);

    const InputFile        *input; // for messages
    std::string             path;
    dealii::Point<dim>      probe;
    std::unique_ptr<Parser> parser;
    bool                    constant     = true;
    bool                    with_time    = false;
    bool                    with_corners = false; // a linear table
    std::vector<double>     constant_values;
  };
} // namespace seiche

#endif
