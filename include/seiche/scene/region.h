// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_region_h
#define seiche_scene_region_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <limits>
#include <memory>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /**
   * @brief Shape of a fluid body at the start.
   */
  template <int dim>
  class Region
  {
  public:
    virtual ~Region() = default;

    /// Negative inside, positive outside, of any unit.
    virtual double
    level(const dealii::Point<dim> &x) const = 0;

    /// True if lattice_box() has no part outside the region.
    virtual bool
    is_box() const
    {
      return false;
    }

    /// [m^dim], or not a number if it is not known.
    virtual double
    volume() const
    {
      return std::numeric_limits<double>::quiet_NaN();
    }

    /// A box that contains the region.
    virtual dealii::BoundingBox<dim>
    bounding_box() const = 0;

    /// The part of a cell over which the lattice of points is laid. The cell
    /// itself, except for boxes: they are cut exactly, so that their volume
    /// is exact wherever their faces lie. Without volume (upper corner not
    /// above the lower one) if the box does not reach into the cell.
    virtual dealii::BoundingBox<dim>
    lattice_box(const dealii::BoundingBox<dim> &cell) const;
  };

  /**
   * @brief prm entries of "Fluid body NAME": shape, its sizes, velocity.
   *
   * Shapes: box (corners), ellipsoid (centre, semi-axes; ball: one radius),
   * polygon (vertices; Boost.Geometry; in 3D a prism along y), expression
   * (inside where < 0).
   */
  template <int dim>
  struct FluidBodyParameters
  {
    std::string name;
    std::string shape = "box";
    std::string lower_text, upper_text, centre_text, radius_text,
      semi_axes_text, vertices_text, span_text, expression_text;
    std::string velocity = (dim == 2 ? "0; 0" : "0; 0; 0"); // [m/s], (x, t=0)

    /// Enters the subsection "Fluid body NAME"; set the name before.
    void
    add_parameters(dealii::ParameterHandler &prm);

    void
    check(const InputFile &input) const;

    /// Make the region; InputError with place for bad sizes. @p domain is the
    /// box of the grid: a body that reaches out of it is refused. @p input
    /// must outlive the region.
    std::unique_ptr<Region<dim>>
    make_region(const InputFile                &input,
                const dealii::BoundingBox<dim> &domain) const;

    /// Path of one of this body's entries in the parameter file.
    std::string
    path(const std::string &entry) const
    {
      return "Fluid body " + name + "/" + entry;
    }
  };
} // namespace seiche

#endif
