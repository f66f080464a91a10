// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_postprocessor_row_h
#define seiche_postprocess_postprocessor_row_h

#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/output_parameters.h>
#include <seiche/postprocess/postprocessor.h>
#include <seiche/postprocess/postprocessor_context.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace seiche
{
  template <int dim>
  using Postprocessors = std::vector<std::unique_ptr<Postprocessor<dim>>>;

  /// Parameters of all subsections "KIND NAME" of a file, in its order.
  template <typename Parameters>
  struct Instances : public std::vector<Parameters>
  {
    void
    find(const InputFile &input)
    {
      this->clear();
      for (const std::string &name : input.instances(Parameters::kind))
        {
          this->emplace_back();
          this->back().name = name;
        }
    }

    void
    add_parameters(dealii::ParameterHandler &prm)
    {
      for (Parameters &instance : *this)
        {
          prm.enter_subsection(std::string(Parameters::kind) + " " +
                               instance.name);
          instance.add_parameters(prm);
          prm.leave_subsection();
        }
    }
  };

  /**
   * @brief Row of the table of postprocessors: made from subsections.
   *
   * @p Made has a type `Parameters` (with `kind`, `name`, `add_parameters`,
   * `check`, `columns`) and is constructed from one of them, or from the vector
   * of all, and the PostprocessorContext.
   */
  template <int dim, typename Made>
  struct BySubsections
  {
    using Parameters = typename Made::Parameters;

    void
    find(const InputFile &input)
    {
      instances.find(input);
    }

    void
    add_parameters(dealii::ParameterHandler &prm)
    {
      instances.add_parameters(prm);
    }

    /// Check the instances and note the columns that they will add. InputError
    /// if there is one of that name already.
    void
    check(const InputFile           &input,
          const GridParameters<dim> &grid,
          const OutputParameters &,
          std::vector<std::string> &columns) const
    {
      for (const Parameters &instance : instances)
        {
          instance.check(input, grid);
          for (const std::string &column : instance.columns())
            {
              if (std::find(columns.begin(), columns.end(), column) !=
                  columns.end())
                throw InputError(input.filename + ": subsection \"" +
                                 Parameters::kind + " " + instance.name +
                                 "\": there is a column \"" + column +
                                 "\" already; choose another name.");
              columns.push_back(column);
            }
        }
    }

    void
    make(const PostprocessorContext<dim> &context,
         const OutputParameters &,
         Postprocessors<dim> &list) const
    {
      if constexpr (std::is_constructible_v<Made,
                                            const Parameters &,
                                            decltype(context)>)
        for (const Parameters &instance : instances)
          list.push_back(std::make_unique<Made>(instance, context));
      else if (!instances.empty())
        list.push_back(std::make_unique<Made>(instances, context));
    }

    Instances<Parameters> instances;
  };

  /// Row of the table of postprocessors: one that an entry of "Output" asks
  /// for, with a single `column`.
  template <int dim, typename Made, bool OutputParameters::*entry>
  struct ByEntry
  {
    void
    find(const InputFile &)
    {}

    void
    add_parameters(dealii::ParameterHandler &)
    {}

    void
    check(const InputFile &,
          const GridParameters<dim> &,
          const OutputParameters   &output,
          std::vector<std::string> &columns) const
    {
      if (output.*entry)
        columns.emplace_back(Made::column);
    }

    void
    make(const PostprocessorContext<dim> &context,
         const OutputParameters          &output,
         Postprocessors<dim>             &list) const
    {
      if (output.*entry)
        list.push_back(std::make_unique<Made>(context));
    }
  };
} // namespace seiche

#endif
