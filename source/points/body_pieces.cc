// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/body_pieces.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
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
               const typename BodyPieces<dim>::Lattice &lattice)
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
            parts.push_back(part_inside<dim>(level, box));
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
  BodyPieces<dim>::BodyPieces(const CellLocator<dim>                 &cells,
                              const std::vector<const Region<dim> *> &regions,
                              const unsigned int                      body,
                              const unsigned int points_per_direction)
    : locator(cells)
    , region(*regions[body])
    , per_direction(points_per_direction)
  {
    for (unsigned int b = 0; b < body; ++b)
      if (!apart(regions[b]->bounding_box(), region.bounding_box()))
        earlier.push_back(regions[b]);
  }

  template <int dim>
  bool
  BodyPieces<dim>::is_apart_from(const unsigned int cell) const
  {
    return apart(region.bounding_box(), locator.cells.geometry(cell).box());
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
    const auto box      = region.lattice_box(cell_box);
    Content    result{Lattice(box, cell_box, per_direction), {}};
    Lattice   &lattice = result.lattice;

    std::vector<const Region<dim> *> others;
    for (const auto *other : earlier)
      if (!apart(other->bounding_box(), box))
        others.push_back(other);
    const bool fills_lattice = region.is_box();
    const auto level         = [&](const Point<dim> &x) {
      double result =
        fills_lattice ? std::numeric_limits<double>::lowest() : region.level(x);
      for (const auto *other : others)
        result = std::max(result, -other->level(x));
      return result;
    };
    if (apart(region.bounding_box(), box))
      lattice.n_all = 0;
    if (lattice.n_all > 0 && (!fills_lattice || !others.empty()))
      result.parts = find_parts<dim>(level, lattice);

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

  template <int dim>
  bool
  BodyPieces<dim>::cross(Place &place, const BoxFace face)
  {
    const unsigned int d       = face.direction();
    const int          step    = face.outward();
    auto              &cell    = place.lattice_cell.cell;
    auto              &offset  = place.lattice_cell.offset;
    const Lattice     &lattice = content(place.lattice_cell).lattice;
    auto               k       = lattice.position(place.index);
    const auto         box     = lattice.box(place.index);

    const auto is_last = [step](const unsigned int i, const unsigned int n) {
      return step < 0 ? i == 0 : i + 1 == n;
    };
    const Lattice *target = &lattice;
    if (!is_last(k[d], lattice.n[d]))
      k[d] += step;
    else
      {
        if (!is_last(offset[d], locator.lattice.size(cell)))
          offset[d] += step;
        else
          {
            Point<dim> x = box.center();
            x[d] += 0.501 * step * box.side_length(d);
            if (locator.periods.wrapped(x) != x)
              return false; // a body ends at a seam
            cell = locator.find(x, cell);
            if (cell == CellLocator<dim>::invalid)
              return false;
            const unsigned int n    = locator.lattice.size(cell);
            const Point<dim>   unit = locator.cells.geometry(cell).to_unit(x);
            for (unsigned int e = 0; e < dim; ++e)
              offset[e] = std::clamp<double>(unit[e] * n, 0., n - 1.);
          }
        target = &content(place.lattice_cell).lattice;
        if (target->n_all == 0)
          return false;
        k[d] = step < 0 ? target->n[d] - 1 : 0;
      }
    place.index = 0;
    for (unsigned int e = dim; e-- > 0;)
      place.index =
        place.index * target->n[e] + std::min(k[e], target->n[e] - 1);
    return true;
  }

  template <int dim>
  std::array<unsigned int, dim>
  BodyPieces<dim>::ways_out(const Place &place)
  {
    const Lattice       &lattice = content(place.lattice_cell).lattice;
    const Tensor<1, dim> shift =
      part(place).centre - lattice.box(place.index).center();
    std::array<unsigned int, dim> faces;
    for (unsigned int d = 0; d < dim; ++d)
      faces[d] = BoxFace(d, /*upper=*/shift[d] > 0.);
    // rounded, so that round-off cannot choose
    const auto distance = [&](const BoxFace face) {
      const unsigned int d = face.direction();
      return std::lround(1e9 * std::abs(shift[d] / lattice.spacing[d]));
    };
    std::stable_sort(faces.begin(), faces.end(), [&](auto a, auto b) {
      return distance(a) > distance(b);
    });
    return faces;
  }

  template <int dim>
  bool
  BodyPieces<dim>::joins(const Place &from, const Place &to, const BoxFace face)
  {
    const auto is_light = [](const double share) {
      return share > 0. && share < light;
    };
    const double share = part(from).share, share_to = part(to).share;
    if (!is_light(share) || share_to == 0.)
      return false;
    // only places that share a vertex with that of 'to' are looked at: another
    // rank knows no others
    const auto faces = ways_out(from);
    if (std::find(faces.begin(), faces.end(), face) == faces.end())
      return false;
    const auto first_heavy = [&](const Place &place) {
      for (const unsigned int f : ways_out(place))
        {
          Place other = place;
          if (cross(other, f) && part(other).share >= light)
            return f;
        }
      return numbers::invalid_unsigned_int;
    };
    const unsigned int chosen = first_heavy(from);
    if (chosen != numbers::invalid_unsigned_int || !is_light(share_to))
      return chosen == face;
    // two light ones that face each other
    return faces[0] == face && ways_out(to)[0] == face.opposite() &&
           first_heavy(to) == numbers::invalid_unsigned_int &&
           (share < share_to || (share == share_to && !face.is_upper()));
  }

  template <int dim>
  typename BodyPieces<dim>::Piece
  BodyPieces<dim>::piece(const LatticeCell &lattice_cell,
                         const unsigned int index)
  {
    const Place        place{lattice_cell, index};
    const BoxPart<dim> own     = part(place);
    const double       measure = content(lattice_cell).lattice.measure();
    Piece              result{own.share * measure, own.centre, own.share == 1.};
    if (own.share == 0. || (region.is_box() && earlier.empty()))
      return result;

    Tensor<1, dim> moment = result.volume * (own.centre - Point<dim>());
    for (const BoxFace face : GeometryInfo<dim>::face_indices())
      {
        Place other = place;
        if (!cross(other, face))
          continue;
        if (joins(place, other, face))
          return {0., own.centre, false};
        if (!joins(other, place, face ^ 1u))
          continue;
        const BoxPart<dim> gained = part(other);
        const double       volume =
          gained.share * content(other.lattice_cell).lattice.measure();
        result.volume += volume;
        result.is_whole = false;
        moment += volume * (gained.centre - Point<dim>());
      }
    if (!result.is_whole)
      result.centre = Point<dim>(moment / result.volume);
    return result;
  }

  template class BodyPieces<2>;
  template class BodyPieces<3>;
} // namespace seiche
