// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/extent_of_surface.h>
#include <seiche/postprocess/wall_names.h>
#include <seiche/space/cut_cell.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double slack = 1e-9; // of a piece: on its edge is inside

    /// A place so far beside a piece's box, in its extents, has a share below
    /// -slack.
    constexpr double box_slack = 4. * slack;

    /// False for most places that the plan does not stand over or under: next
    /// to its box.
    template <int dim>
    bool
    may_be_over(const SurfacePiece<dim> &plan, const Point<dim> &place)
    {
      for (unsigned int d = 0; d + 1 < dim; ++d)
        {
          double lower = plan[0][d], upper = plan[0][d];
          for (unsigned int v = 1; v < dim; ++v)
            {
              lower = std::min(lower, plan[v][d]);
              upper = std::max(upper, plan[v][d]);
            }
          const double margin = box_slack * (upper - lower);
          if (place[d] < lower - margin || place[d] > upper + margin)
            return false;
        }
      return true;
    }

    /// Height of @p piece at the place of it that stands over (or under) @p
    /// place in @p plan, or none.
    template <int dim>
    double
    height(const SurfacePiece<dim> &piece,
           const SurfacePiece<dim> &plan,
           const Point<dim>        &place)
    {
      if (!may_be_over<dim>(plan, place))
        return Extent<dim>::none;
      // share of the plan across each vertex: (signed) sizes
      std::array<double, dim> share;
      double                  whole = 0.;
      for (unsigned int v = 0; v < dim; ++v)
        {
          SurfacePiece<dim> part = plan;
          part[v]                = place;
          share[v]               = area_vector<dim>(part)[dim - 1];
          whole += share[v];
        }
      // a vertical one ends at others
      double size = 0.;
      for (unsigned int d = 0; d + 1 < dim; ++d)
        size += std::abs(area_vector<dim>(plan)[d]);
      if (std::abs(whole) <= slack * size)
        return Extent<dim>::none;
      double result = 0.;
      for (unsigned int v = 0; v < dim; ++v)
        {
          if (share[v] / whole < -slack)
            return Extent<dim>::none;
          result += share[v] / whole * piece[v][dim - 1];
        }
      return result;
    }

    /// Share of the upper face of a cell that is inside.
    template <int dim>
    double
    share_of_upper_face(const VertexValues<dim> &level)
    {
      VertexValues<dim> extruded;
      for (unsigned int v = 0; v < level.size(); ++v)
        extruded[v] = level[v | (1u << (dim - 1))];
      return CutCell<dim>(extruded).volume();
    }
  } // namespace

  template <int dim>
  ExtentOfSurface<dim>::ExtentOfSurface(const StepView<dim> &step)
    : view(step)
    , pieces(moved_surface(step))
  {
    find_wet_places();
    find_wet_places_of_solids();
  }

  template <int dim>
  void
  ExtentOfSurface<dim>::find_wet_places()
  {
    const auto         &locator = view.occupancy.locator;
    GridEvaluation<dim> here(view);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (view.occupancy.cells.is_active(cell))
        for (const BoxFace face : GeometryInfo<dim>::face_indices())
          {
            const Wall<dim> *const wall = locator.cells.wall_at(cell, face);
            if (wall == nullptr)
              continue;
            if (face == top)
              under_ceiling.push_back(cell);
            const auto level = view.fill.surface().level_in(cell);
            for (unsigned int v = 0; v < level.size(); ++v)
              if (face.has_vertex(v) && level[v] < 0.)
                wet_places.push_back(
                  {wall->number,
                   moved_place(view,
                               cell,
                               GeometryInfo<dim>::unit_cell_vertex(v),
                               here)});
          }
    for (const MovedPiece<dim> &piece : pieces)
      for (const BoxFace face : GeometryInfo<dim>::face_indices())
        if (const Wall<dim> *const wall =
              locator.cells.wall_at(piece.cell, face))
          for (unsigned int v = 0; v < dim; ++v)
            if (std::abs(piece.unit[v][face.direction()] - face.is_upper()) <
                slack)
              wet_places.push_back({wall->number, piece.place[v]});
  }

  template <int dim>
  void
  ExtentOfSurface<dim>::find_wet_places_of_solids()
  {
    const auto &solids = view.occupancy.mesh_nodes.cut_walls;
    const auto &grid   = view.occupancy.locator.grid.parameters;
    if (!solids.exist())
      return;
    GridEvaluation<dim> here(view);
    for (const unsigned int cell : view.occupancy.cells.occupied())
      if (const auto *points = view.fill.wall(cell))
        for (const WallPoint<dim> &point : *points)
          wet_places.push_back({place_of_solid(grid, point.solid),
                                moved_place(view, cell, point.unit, here)});
    for (const MovedPiece<dim> &piece : pieces)
      if (solids.cuts(piece.cell))
        for (unsigned int v = 0; v < dim; ++v)
          if (solids.distance_at(piece.cell, piece.unit[v]) <
              slack * view.occupancy.locator.cells.geometry(piece.cell)
                        .shortest_edge())
            wet_places.push_back(
              {place_of_solid(grid,
                              solids.solid_near(piece.cell, piece.unit[v])),
               piece.place[v]});
  }

  template <int dim>
  double
  ExtentOfSurface<dim>::farthest(const unsigned int axis,
                                 const double       sign,
                                 const double       lowest) const
  {
    double     result = none;
    const auto add    = [&](const Point<dim> &x) {
      if (x[dim - 1] >= lowest)
        result = std::max(result, sign * x[axis]);
    };
    for (const WetPlace &wet : wet_places)
      add(wet.place);
    for (const MovedPiece<dim> &piece : pieces)
      for (unsigned int v = 0; v < dim; ++v)
        {
          const Point<dim> &a = piece.place[v];
          add(a);
          for (unsigned int w = 0; w < v; ++w) // where it crosses the height
            if (const Point<dim> &b = piece.place[w];
                (a[dim - 1] < lowest) != (b[dim - 1] < lowest))
              {
                const double t =
                  (lowest - a[dim - 1]) / (b[dim - 1] - a[dim - 1]);
                result =
                  std::max(result, sign * (a[axis] + t * (b[axis] - a[axis])));
              }
        }
    return result;
  }

  template <int dim>
  double
  ExtentOfSurface<dim>::ceiling(const Point<dim> &place) const
  {
    const auto &locator = view.occupancy.locator;
    double      result  = none;
    for (const unsigned int cell : under_ceiling)
      {
        Point<dim> unit =
          locator.cells.geometry(cell).to_unit(locator.image(place, cell));
        unit[dim - 1] = 1.;
        bool inside   = true;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          inside = inside && unit[d] >= -slack && unit[d] <= 1. + slack;
        if (inside && level_at(view, cell, unit) < 0.)
          result = std::max(result, ceiling_over(cell));
      }
    return result;
  }

  template <int dim>
  bool
  ExtentOfSurface<dim>::is_under_lid(const unsigned int cell) const
  {
    const Wall<dim> *const wall =
      view.occupancy.locator.cells.wall_at(cell, top);
    return wall != nullptr && wall->number == top;
  }

  template <int dim>
  double
  ExtentOfSurface<dim>::ceiling_over(const unsigned int cell) const
  {
    const auto &locator = view.occupancy.locator;
    return is_under_lid(cell) ? view.box.get_boundary_points().second[dim - 1] :
                                locator.cells.geometry(cell).upper[dim - 1];
  }

  template <int dim>
  double
  ExtentOfSurface<dim>::level(const Point<dim> &place,
                              const double /*width*/) const
  {
    const auto &locator = view.occupancy.locator;
    double      result  = ceiling(place);
    for (const MovedPiece<dim> &piece : pieces)
      result = std::max(result,
                        height<dim>(piece.place,
                                    piece.place,
                                    locator.image(place, piece.cell)));
    return result;
  }

  template <int dim>
  double
  ExtentOfSurface<dim>::level_left(const Point<dim> &place) const
  {
    const auto &locator = view.occupancy.locator;
    double      result  = ceiling(place);
    for (const MovedPiece<dim> &piece : pieces)
      {
        SurfacePiece<dim> before = piece.unit;
        for (Point<dim> &x : before)
          x = locator.cells.geometry(piece.cell).to_real(x);
        result = std::max(result,
                          height<dim>(piece.place,
                                      before,
                                      locator.image(place, piece.cell)));
      }
    return result;
  }

  template <int dim>
  double
  ExtentOfSurface<dim>::wet_height(const unsigned int wall) const
  {
    double result = none;
    for (const WetPlace &wet : wet_places)
      if (wet.wall == wall)
        result = std::max(result, wet.place[dim - 1]);
    return result;
  }

  template <int dim>
  typename Extent<dim>::Surface
  ExtentOfSurface<dim>::surface() const
  {
    Surface result;
    for (const MovedPiece<dim> &piece : pieces)
      {
        const double area = area_vector<dim>(piece.place)[dim - 1];
        double       mean = 0.;
        for (const Point<dim> &x : piece.place)
          mean += x[dim - 1] / dim;
        result.area += area;
        result.volume += mean * area;
      }
    // where the fluid stands at the lid, that is its surface
    const auto &locator = view.occupancy.locator;
    for (const unsigned int cell : under_ceiling)
      if (is_under_lid(cell))
        {
          const double area =
            share_of_upper_face<dim>(view.fill.surface().level_in(cell)) *
            locator.cells.geometry(cell).measure /
            locator.cells.geometry(cell).edges[dim - 1];
          result.area += area;
          result.volume += area * ceiling_over(cell);
        }
    for (const unsigned int cell : view.occupancy.cells.occupied())
      result.volume += view.fill.loose_volume(cell, view.points) *
                       locator.cells.geometry(cell).measure;
    return result;
  }

  template class ExtentOfSurface<2>;
  template class ExtentOfSurface<3>;
} // namespace seiche
