// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_extent_of_surface_h
#define seiche_postprocess_extent_of_surface_h

#include <seiche/postprocess/extent.h>
#include <seiche/postprocess/moved_surface.h>

namespace seiche
{
  /// Of the pieces of the surface, and the wet places of the walls.
  template <int dim>
  class ExtentOfSurface : public Extent<dim>
  {
  public:
    using Extent<dim>::none;
    using typename Extent<dim>::Surface;

    explicit ExtentOfSurface(const StepView<dim> &step);

    double
    farthest(const unsigned int axis,
             const double       sign,
             const double       lowest) const override;
    double
    level(const dealii::Point<dim> &place, const double width) const override;
    double
    level_left(const dealii::Point<dim> &place) const override;
    double
    wet_height(const unsigned int wall) const override;

    Surface
    surface() const override;

  private:
    /// Corners of wet faces at walls and points of solids, and ends of the
    /// surface there.
    struct WetPlace
    {
      unsigned int       wall; ///< number in wall_names()
      dealii::Point<dim> place;
    };

    void
    find_wet_places();
    void
    find_wet_places_of_solids();

    /// The underside of a wall where the fluid reaches up to it, or none.
    double
    ceiling(const dealii::Point<dim> &place) const;

    /// True if the cell touches the upper side of the domain.
    bool
    is_under_lid(const unsigned int cell) const;

    /// Height [m] at which the wall over a cell is at the end of the step.
    double
    ceiling_over(const unsigned int cell) const;

    static constexpr BoxFace top = {dim - 1, /*upper=*/true};

    const StepView<dim>               &view;
    const std::vector<MovedPiece<dim>> pieces;
    std::vector<WetPlace>              wet_places;
    std::vector<unsigned int>          under_ceiling; // cells
  };
} // namespace seiche

#endif
