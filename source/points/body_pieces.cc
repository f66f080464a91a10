// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/solid_distance.h>
#include <seiche/points/body_pieces.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Tolerances of a piece's volume over its box: surfaces of triangles have
    /// edges everywhere, and their distances are dear.
    constexpr double of_smooth = 1e-6, of_triangles = 1e-3;

    template <int dim>
    bool
    apart(const BoundingBox<dim> &a, const BoundingBox<dim> &b)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (a.lower_bound(d) > b.upper_bound(d) ||
            a.upper_bound(d) < b.lower_bound(d))
          return true;
      return false;
    }

    /// The parts of all places. Vertices are shared by places: the function
    /// may be slow.
    template <int dim>
    std::vector<BoxPart<dim>>
    find_parts(const typename BoxPart<dim>::Level      &level,
               const typename BodyPieces<dim>::Lattice &lattice,
               const double                             tolerance)
    {
      std::array<unsigned int, dim> strides;
      unsigned int                  n_vertices = 1;
      for (unsigned int d = 0; d < dim; ++d)
        {
          strides[d] = n_vertices;
          n_vertices *= lattice.n[d] + 1;
        }
      std::vector<double> values;
      for (unsigned int i = 0; i < n_vertices; ++i)
        {
          Point<dim> x = lattice.origin;
          for (unsigned int d = 0; d < dim; ++d)
            x[d] += i / strides[d] % (lattice.n[d] + 1) * lattice.spacing[d];
          values.push_back(level(x));
        }

      std::vector<BoxPart<dim>> parts;
      for (unsigned int i = 0; i < lattice.n_all; ++i)
        {
          const auto k       = lattice.position(i);
          double     lowest  = std::numeric_limits<double>::max();
          double     highest = std::numeric_limits<double>::lowest();
          for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
            {
              unsigned int vertex = 0;
              for (unsigned int d = 0; d < dim; ++d)
                vertex += (k[d] + ((v >> d) & 1u)) * strides[d];
              lowest  = std::min(lowest, values[vertex]);
              highest = std::max(highest, values[vertex]);
            }
          // a function that jumps has no range to judge by
          const double range = highest - lowest;
          const auto   box   = lattice.box(i);
          if (range > 0. && lowest > range)
            parts.push_back({0., box.center()});
          else if (range > 0. && highest < -range)
            parts.push_back({1., box.center()});
          else
            parts.push_back(part_inside<dim>(level, box, tolerance));
        }
      return parts;
    }
  } // namespace

  template <int dim>
  BodyPieces<dim>::Lattice::Lattice(const BoundingBox<dim> &part,
                                    const BoundingBox<dim> &cell,
                                    const unsigned int      per_direction)
    : origin(part.get_boundary_points().first)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        // slices thinner than round-off come from box faces on grid lines
        const double share = part.side_length(d) / cell.side_length(d);
        n[d]               = 0;
        if (share > 1e-10)
          n[d] = std::max(1L, std::lround(share * per_direction));
        n_all *= n[d];
        spacing[d] = n[d] > 0 ? part.side_length(d) / n[d] : 0.;
      }
  }

  template <int dim>
  std::array<unsigned int, dim>
  BodyPieces<dim>::Lattice::position(const unsigned int place) const
  {
    std::array<unsigned int, dim> result;
    unsigned int                  rest = place;
    for (unsigned int d = 0; d < dim; ++d, rest /= n[d - 1])
      result[d] = rest % n[d];
    return result;
  }

  template <int dim>
  BoundingBox<dim>
  BodyPieces<dim>::Lattice::box(const unsigned int place) const
  {
    const auto k = position(place);
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = origin[d] + k[d] * spacing[d];
        upper[d] = origin[d] + (k[d] + 1) * spacing[d];
      }
    return BoundingBox<dim>({lower, upper});
  }

  template <int dim>
  double
  BodyPieces<dim>::Lattice::measure() const
  {
    double result = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      result *= spacing[d];
    return result;
  }

  template <int dim>
  BodyPieces<dim>::BodyPieces(const CellLocator<dim>                &cells,
                              const std::vector<const Shape<dim> *> &shapes,
                              const unsigned int                     body,
                              const unsigned int points_per_direction)
    : locator(cells)
    , shape(*shapes[body])
    , per_direction(points_per_direction)
  {
    for (unsigned int b = 0; b < body; ++b)
      if (!apart(shapes[b]->bounding_box(), shape.bounding_box()))
        earlier.push_back(shapes[b]);
  }

  template <int dim>
  bool
  BodyPieces<dim>::is_apart_from(const unsigned int cell) const
  {
    return apart(shape.bounding_box(), locator.cells.geometry(cell).box());
  }

  template <int dim>
  const typename BodyPieces<dim>::Lattice &
  BodyPieces<dim>::lattice(const LatticeCell &lattice_cell)
  {
    // neighbours come soon after each other, others are found anew
    constexpr std::size_t most = 200000;
    if (contents.size() > most)
      contents.clear();
    return content(lattice_cell).lattice;
  }

  template <int dim>
  const typename BodyPieces<dim>::Content &
  BodyPieces<dim>::content(const LatticeCell &lattice_cell)
  {
    const auto [cell, offset] = lattice_cell;
    const std::uint64_t key   = locator.lattice.index(cell, offset);
    const auto          known = contents.find(key);
    if (known != contents.end())
      return known->second;

    const auto cell_box = locator.lattice.box(cell, offset);
    const auto box      = shape.lattice_box(cell_box);
    Content    result{Lattice(box, cell_box, per_direction), {}};
    Lattice   &lattice = result.lattice;

    std::vector<const Shape<dim> *> others;
    for (const auto *other : earlier)
      if (!apart(other->bounding_box(), box))
        others.push_back(other);
    // far from the surface one distance tells all
    std::optional<SolidDistance<dim>> walls;
    if (locator.cells.is_near_solid(cell))
      walls.emplace(locator.solids, locator.cells.geometry(cell));
    const double distance =
      shape.bounds_distance() ? shape.distance(box.center()) : 0.;
    const auto corners = box.get_boundary_points();
    const bool is_far =
      2. * std::abs(distance) > corners.first.distance(corners.second);
    const bool fills_lattice = shape.is_box() || (is_far && distance < 0.);
    const auto level         = [&](const Point<dim> &x) {
      double result =
        fills_lattice ? std::numeric_limits<double>::lowest() : shape.level(x);
      for (const auto *other : others)
        result = std::max(result, -other->level(x));
      if (walls)
        result = std::max(result, -walls->value(x));
      return result;
    };
    if (apart(shape.bounding_box(), box) || (is_far && distance > 0.))
      lattice.n_all = 0;
    if (lattice.n_all > 0 && (!fills_lattice || !others.empty() || walls))
      result.parts =
        find_parts<dim>(level,
                        lattice,
                        shape.bounds_distance() ? of_triangles : of_smooth);

    const auto all = [&](const double share) {
      return std::all_of(result.parts.begin(),
                         result.parts.end(),
                         [&](const auto &p) { return p.share == share; });
    };
    if (!result.parts.empty() && all(0.))
      lattice.n_all = 0;
    if (all(0.) || all(1.))
      result.parts.clear();
    return contents.emplace(key, std::move(result)).first->second;
  }

  template <int dim>
  BoxPart<dim>
  BodyPieces<dim>::part(const Place &place)
  {
    const Content &here = content(place.lattice_cell);
    if (here.parts.empty())
      return {1., here.lattice.box(place.index).center()};
    return here.parts[place.index];
  }

  template class BodyPieces<2>;
  template class BodyPieces<3>;
} // namespace seiche
