// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_entry_values_h
#define seiche_scene_entry_values_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace seiche
{
  class InputFile;

  /**
   * @brief Lists of numbers typed in a parameter file.
   *
   * Numbers are separated by commas or blanks and read independently of the
   * locale. All functions throw InputError with the place of entry @p path
   * for text that is no finite number and for a wrong count. Local.
   */
  namespace entry_values
  {
    std::vector<double>
    numbers(const InputFile   &input,
            const std::string &path,
            const std::string &text);

    /// Exactly one number.
    double
    number(const InputFile   &input,
           const std::string &path,
           const std::string &text);

    /// Positive integers.
    std::vector<unsigned int>
    counts(const InputFile   &input,
           const std::string &path,
           const std::string &text);

    /// Exactly dim numbers.
    template <int dim>
    dealii::Point<dim>
    point(const InputFile   &input,
          const std::string &path,
          const std::string &text);
  } // namespace entry_values
} // namespace seiche

#endif
