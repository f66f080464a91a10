// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/cell_locator.h>
#include <seiche/mesh/morton_key.h>

#include <algorithm>

// The part of CellLocator that finds the cell of a position.
namespace seiche
{
  namespace
  {
    /// Position relative to a wall, in cells, up to which a point outside
    /// counts as on it: round-off of an update of the position.
    constexpr double wall_tolerance = 1e-10;
  } // namespace



  template <int dim>
  unsigned int
  CellLocator<dim>::Lines::index(const double x) const
  {
    unsigned int s = 0;
    while (s + 1 < segments.size() && x >= segments[s].end)
      ++s;
    const Segment &segment = segments[s];
    unsigned int   i =
      segment.first +
      static_cast<unsigned int>((x - segment.begin) * segment.inverse_size);
    // the quotient is off by round-off; the lines decide
    i = std::min<unsigned int>(i, places.size() - 2);
    if (x < places[i])
      --i;
    else if (x >= places[i + 1] && i + 2 < places.size())
      ++i;
    return i;
  }



  template <int dim>
  bool
  CellLocator<dim>::lattice_position(const dealii::Point<dim> &x,
                                     Lattice                  &index) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        const std::vector<double> &places = lines[d].places;
        if (!(x[d] >= places.front() && x[d] <= places.back()))
          return false;
        index[d] = lines[d].index(x[d]);
      }
    return true;
  }



  template <int dim>
  bool
  CellLocator<dim>::in_obstacle(const Lattice &index) const
  {
    for (unsigned int i = 0; i < grid.parameters.obstacles().size(); ++i)
      {
        const auto &box    = grid.obstacle_box(i);
        bool        inside = true;
        for (unsigned int d = 0; d < dim; ++d)
          inside &= (index[d] >> obstacle_shift) >= box.first[d] &&
                    (index[d] >> obstacle_shift) < box.second[d];
        if (inside)
          return true;
      }
    return false;
  }



  template <int dim>
  bool
  CellLocator<dim>::covers(const unsigned int cell, const Lattice &index) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (index[d] < lattice_lower[cell][d] ||
          index[d] >= lattice_upper[cell][d])
        return false;
    return true;
  }



  template <int dim>
  unsigned int
  CellLocator<dim>::search(const Lattice &index) const
  {
    const std::uint64_t key = morton_key<dim>(index);
    auto                it  = std::upper_bound(by_key.begin(),
                               by_key.end(),
                               key,
                               [](const std::uint64_t k, const auto &entry) {
                                 return k < entry.first;
                               });
    if (it == by_key.begin())
      return invalid;
    --it;
    return covers(it->second, index) ? it->second : invalid;
  }



  template <int dim>
  unsigned int
  CellLocator<dim>::find(const dealii::Point<dim> &x,
                         const unsigned int        hint) const
  {
    if (hint != invalid)
      {
        // most points stay or move to a neighbour: walk one step a direction
        unsigned int cell = hint;
        for (unsigned int d = 0; d < dim && cell != invalid; ++d)
          if (x[d] < geometries[cell].lower[d])
            cell = face_neighbors[cell][BoxFace(d, /*upper=*/false)];
          else if (x[d] >= geometries[cell].upper[d])
            cell = face_neighbors[cell][BoxFace(d, /*upper=*/true)];
        if (cell != invalid && geometries[cell].holds(x))
          return cell;
      }
    Lattice                  index;
    const dealii::Point<dim> inside = wrapped(x);
    if (lattice_position(inside, index))
      {
        const unsigned int cell = search(index);
        if (cell != invalid || !in_obstacle(index))
          return cell;
      }
    return find_at_wall(inside);
  }



  template <int dim>
  unsigned int
  CellLocator<dim>::find_at_wall(const dealii::Point<dim> &x) const
  {
    // per direction the lattice cell, and the one across a line so close that
    // the position counts as on it
    std::array<std::array<unsigned int, 2>, dim> candidates;
    std::array<unsigned int, dim>                n_candidates;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const std::vector<double> &places = lines[d].places;
        const double               inside =
          std::min(std::max(x[d], places.front()), places.back());
        const unsigned int i   = lines[d].index(inside);
        const double tolerance = wall_tolerance * (places[i + 1] - places[i]);
        if (!(std::abs(x[d] - inside) <= tolerance))
          return invalid; // also for NaN
        candidates[d][0] = i;
        n_candidates[d]  = 1;
        if (i > 0 && x[d] - places[i] <= tolerance)
          candidates[d][n_candidates[d]++] = i - 1;
        else if (i + 2 < places.size() && places[i + 1] - x[d] <= tolerance)
          candidates[d][n_candidates[d]++] = i + 1;
      }
    for (unsigned int choice = 0; choice < (1u << dim); ++choice)
      {
        Lattice index;
        bool    exists = true;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int c = (choice >> d) & 1u;
            exists               = exists && c < n_candidates[d];
            index[d]             = candidates[d][exists ? c : 0];
          }
        if (exists && !in_obstacle(index))
          return search(index);
      }
    return invalid;
  }



  template unsigned int
  CellLocator<2>::Lines::index(const double) const;
  template bool
  CellLocator<2>::lattice_position(const dealii::Point<2> &, Lattice &) const;
  template bool
  CellLocator<2>::covers(const unsigned int, const Lattice &) const;
  template unsigned int
  CellLocator<2>::find(const dealii::Point<2> &, const unsigned int) const;
  template unsigned int
  CellLocator<3>::Lines::index(const double) const;
  template bool
  CellLocator<3>::lattice_position(const dealii::Point<3> &, Lattice &) const;
  template bool
  CellLocator<3>::covers(const unsigned int, const Lattice &) const;
  template unsigned int
  CellLocator<3>::find(const dealii::Point<3> &, const unsigned int) const;
} // namespace seiche
