// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/body_pieces.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>

// The part of BodyPieces that joins light pieces to those beside them.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Share of its place below which a piece that no other one takes is left
    /// out: alone in its cell so little fluid moves by round-off.
    constexpr double negligible = 1e-4;
  } // namespace

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
    if (own.share < negligible)
      return {0., own.centre, false};
    // a box is divided along its own faces
    if (shape.is_box() && earlier.empty())
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

  template BodyPieces<2>::Piece
  BodyPieces<2>::piece(const LatticeCell &, const unsigned int);
  template BodyPieces<3>::Piece
  BodyPieces<3>::piece(const LatticeCell &, const unsigned int);
} // namespace seiche
