// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_shape_parameters_h
#define seiche_scene_shape_parameters_h

#include <seiche/shapes/composed_shapes.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /**
   * @brief prm entries of a shape: its kind (a row of shape_table()), sizes and
   * place. Part of the subsection of a fluid body, or all of "Shape NAME",
   * which others name as a part of theirs.
   */
  template <int dim>
  struct ShapeParameters
  {
    explicit ShapeParameters(const std::string &name_of_subsection)
      : subsection(name_of_subsection)
    {}

    /// Of shapes with a name of their own.
    static constexpr const char *kind = "Shape";

    std::string subsection; ///< "Fluid body NAME"
    std::string shape = "box";
    std::string lower_text, upper_text, centre_text, radius_text,
      semi_axes_text, ends_text, point_text, normal_text, vertices_text,
      span_text, expression_text, heights_text, triangles_text, parts_text;
    double      scale = 1.;
    std::string rotation_text, pivot_text, shift_text;

    /// Within the subsection, which the caller has entered.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// All of the subsection.
    void
    add_subsection(dealii::ParameterHandler &prm);

    void
    check(const InputFile &input) const;

    /// Make the shape; InputError with place for what makes none. @p domain is
    /// the box of the grid; @p named: shapes that parts may be. @p input must
    /// outlive the shape.
    ShapePointer<dim>
    make(const InputFile                    &input,
         const dealii::BoundingBox<dim>     &domain,
         const std::vector<ShapeParameters> &named) const;

    /// Names of the shapes that it is made of.
    std::vector<std::string>
    parts() const;

    std::string
    path(const std::string &entry) const
    {
      return subsection + "/" + entry;
    }

    /// The entry that says how far the shape reaches in a direction.
    std::string
    entry_of_extent(const unsigned int direction, const bool upwards) const;

    static std::string
    subsection_of(const std::string &name)
    {
      return std::string(kind) + " " + name;
    }

  private:
    bool
    is_placed() const
    {
      return scale != 1. || !rotation_text.empty() || !shift_text.empty();
    }

    Placement<dim>
    placement(const InputFile &input) const;
  };

  /// Of the subsections "Shape NAME"; @p used: the names that fluid bodies
  /// have as parts. InputError for a shape that is a part of itself.
  template <int dim>
  void
  check_named_shapes(const InputFile                         &input,
                     const std::vector<ShapeParameters<dim>> &shapes,
                     std::vector<std::string>                 used);
} // namespace seiche

#endif
