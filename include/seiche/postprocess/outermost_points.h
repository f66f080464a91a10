// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_outermost_points_h
#define seiche_postprocess_outermost_points_h

#include <seiche/postprocess/extent.h>
#include <seiche/postprocess/wall_names.h>

#include <algorithm>
#include <vector>

namespace seiche
{
  /// The outermost of the points that are chosen, and half their spacing, but
  /// nothing beyond a wall.
  template <int dim>
  class OutermostPoints : public Extent<dim>
  {
  public:
    using Extent<dim>::none;
    using typename Extent<dim>::Surface;

    /// @p choice(cell, number of the point in it). @p step must outlive the
    /// object.
    template <typename Choice>
    OutermostPoints(const StepView<dim> &step, const Choice &choice)
      : view(step)
    {
      for (unsigned int cell = 0; cell < view.occupancy.locator.cells.n_owned();
           ++cell)
        for (unsigned int p = 0; p < view.points.n_points_in(cell); ++p)
          if (choice(cell, p))
            chosen.push_back({cell, view.points.first_point(cell) + p});
    }

    double
    farthest(const unsigned int axis,
             const double       sign,
             const double       lowest) const override
    {
      return largest(axis, sign, [&](const Entry &entry) {
        return view.points.data(PointColumn::position, dim - 1)[entry.point] >=
               lowest;
      });
    }

    double
    level(const dealii::Point<dim> &place, const double width) const override
    {
      return largest(dim - 1, 1., [&](const Entry &entry) {
        const auto way = view.occupancy.locator.periods.shortest(
          view.points.position(entry.point) - place);
        for (unsigned int d = 0; d + 1 < dim; ++d)
          if (std::abs(way[d]) >= width)
            return false;
        return true;
      });
    }

    /// Of points in the cells at the wall.
    double
    wet_height(const unsigned int wall) const override
    {
      const auto &locator = view.occupancy.locator;
      const auto &solids  = view.occupancy.mesh_nodes.cut_walls;
      return largest(dim - 1, 1., [&](const Entry &entry) {
        if (solids.cuts(entry.cell))
          {
            const auto unit = locator.cells.geometry(entry.cell)
                                .to_unit(view.points.position(entry.point));
            if (place_of_solid(locator.grid.parameters,
                               solids.solid_near(entry.cell, unit)) == wall)
              return true;
          }
        for (const unsigned int face :
             dealii::GeometryInfo<dim>::face_indices())
          if (const Wall<dim> *const here =
                locator.cells.wall_at(entry.cell, face))
            if (here->number == wall)
              return true;
        return false;
      });
    }

    /// As if the points' water stood on the whole bottom.
    Surface
    surface() const override
    {
      const auto    box    = view.box.get_boundary_points();
      const double *volume = view.points.data(PointColumn::initial_volume);
      Surface       result;
      if (dealii::Utilities::MPI::this_mpi_process(view.points.communicator) ==
          0)
        {
          result.area = 1.;
          for (unsigned int d = 0; d + 1 < dim; ++d)
            result.area *= box.second[d] - box.first[d];
          result.volume = result.area * box.first[dim - 1];
        }
      for (const Entry &entry : chosen)
        result.volume += volume[entry.point];
      return result;
    }

  private:
    struct Entry
    {
      unsigned int cell;
      std::size_t  point;
    };

    template <typename Condition>
    double
    largest(const unsigned int axis,
            const double       sign,
            const Condition   &condition) const
    {
      double result = none;
      for (const Entry &entry : chosen)
        if (condition(entry))
          result =
            std::max(result,
                     end_of(view.points.position(entry.point), axis, sign));
      return result;
    }

    /// Largest sign x_axis of the water that the point at @p x stands for.
    double
    end_of(const dealii::Point<dim> &x,
           const unsigned int        axis,
           const double              sign) const
    {
      const auto [low, high] = view.box.get_boundary_points();
      double result          = std::min(sign * x[axis] + view.half_spacing,
                               sign * (sign > 0. ? high : low)[axis]);
      for (const auto &obstacle :
           view.occupancy.locator.grid.parameters.obstacles())
        {
          const auto &lower = obstacle.lower_corner,
                     &upper = obstacle.upper_corner;
          // before the side that faces the point
          bool faces =
            sign * (0.5 * (lower[axis] + upper[axis]) - x[axis]) > 0.;
          for (unsigned int d = 0; d < dim; ++d)
            faces =
              faces && (d == axis || (x[d] > lower[d] && x[d] < upper[d]));
          if (faces)
            result = std::min(result, sign * (sign > 0. ? lower : upper)[axis]);
        }
      return result;
    }

    const StepView<dim> &view;
    std::vector<Entry>   chosen;
  };
} // namespace seiche

#endif
