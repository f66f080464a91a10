// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_field_patches_h
#define seiche_postprocess_field_patches_h

#include <deal.II/base/data_out_base.h>

#include <string>
#include <tuple>
#include <vector>

namespace seiche
{
  /**
   * @brief Patches with named fields for deal.II's writers.
   *
   * @tparam patch_dim 0 for points, dim - 1 for a surface, dim for cells.
   *
   * The owner declares the fields, fills the patches (rows of Patch::data in
   * the order of the fields, dim rows a vector) and writes.
   */
  template <int patch_dim, int dim>
  class FieldPatches : public dealii::DataOutInterface<patch_dim, dim>
  {
  public:
    /// Flags of the writer: time [s] and number of the step, fast compression.
    FieldPatches(const double time, const unsigned int step)
    {
      dealii::DataOutBase::VtkFlags flags(time,
                                          step,
                                          /*print_date_and_time=*/false);
      flags.compression_level = decltype(flags.compression_level)::best_speed;
      this->set_flags(flags);
    }

    void
    add_scalar(const std::string &name)
    {
      names.push_back(name);
    }

    void
    add_vector(const std::string &name)
    {
      const unsigned int first = names.size();
      for (unsigned int d = 0; d < dim; ++d)
        names.push_back(name);
      vectors.emplace_back(
        first,
        first + dim - 1,
        name,
        dealii::DataComponentInterpretation::component_is_part_of_vector);
    }

    unsigned int
    n_rows() const
    {
      return names.size();
    }

    std::vector<dealii::DataOutBase::Patch<patch_dim, dim>> patches;

  protected:
    const std::vector<dealii::DataOutBase::Patch<patch_dim, dim>> &
    get_patches() const override
    {
      return patches;
    }

    std::vector<std::string>
    get_dataset_names() const override
    {
      return names;
    }

    std::vector<std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override
    {
      return vectors;
    }

  private:
    std::vector<std::string> names; // one a row
    std::vector<std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
      vectors;
  };
} // namespace seiche

#endif
