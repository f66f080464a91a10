// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/cell_locator.h>
#include <seiche/mesh/wall_tolerance.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  template <int dim>
  CellLocator<dim>::CellLocator(const BackgroundGrid<dim> &background_grid)
    : grid(background_grid)
    , solids(background_grid.parameters.solids)
    , lines(background_grid)
    , periods(lines)
    , lattice(lines, periods)
    , cells(background_grid)
  {
    reinit();
  }



  template <int dim>
  void
  CellLocator<dim>::reinit()
  {
    cells.reinit(lattice);
    cells.find_solids(solids);
  }



  template <int dim>
  void
  CellLocator<dim>::move(const GridMotion<dim> &motion, const double time)
  {
    lines.move(motion, time);
    cells.move(lattice);
  }



  template <int dim>
  void
  CellLocator<dim>::move_solids(const double time)
  {
    for (Solid<dim> &solid : solids)
      solid = solid.at(time);
    cells.find_solids(solids);
  }



  template <int dim>
  const Wall<dim> *
  CellLocator<dim>::wall_beyond(const dealii::Point<dim> &x) const
  {
    const Wall<dim> *result = nullptr;
    double           least  = 0.; // [m], negative behind a wall
    for (const Wall<dim> &wall : grid.parameters.walls)
      {
        const double distance = wall.distance(x, lines.time());
        if (distance < least)
          {
            least  = distance;
            result = &wall;
          }
      }
    return result;
  }



  template <int dim>
  bool
  CellLocator<dim>::lattice_position(const dealii::Point<dim> &x,
                                     Index                    &index) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        if (!(x[d] >= lines.front(d) && x[d] <= lines.back(d)))
          return false;
        index[d] = lines.index(d, x[d]);
      }
    return true;
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
          if (x[d] < cells.geometry(cell).lower[d])
            cell = cells.neighbor(cell, BoxFace(d, /*upper=*/false));
          else if (x[d] >= cells.geometry(cell).upper[d])
            cell = cells.neighbor(cell, BoxFace(d, /*upper=*/true));
        if (cell != invalid && cells.geometry(cell).holds(x))
          return cell;
      }
    Index                    index;
    const dealii::Point<dim> inside = periods.wrapped(x);
    if (lattice_position(inside, index))
      {
        const unsigned int cell = lattice.find(index);
        if (cell != invalid || !lines.in_obstacle(index))
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
        const double inside =
          std::min(std::max(x[d], lines.front(d)), lines.back(d));
        const unsigned int i = lines.index(d, inside);
        const double begin = lines.place(d, i), end = lines.place(d, i + 1);
        const double tolerance = wall_tolerance * (end - begin);
        if (!(std::abs(x[d] - inside) <= tolerance))
          return invalid; // also for NaN
        candidates[d][0] = i;
        n_candidates[d]  = 1;
        if (i > 0 && x[d] - begin <= tolerance)
          candidates[d][n_candidates[d]++] = i - 1;
        else if (i + 1 < lines.n_cells(d) && end - x[d] <= tolerance)
          candidates[d][n_candidates[d]++] = i + 1;
      }
    for (unsigned int choice = 0; choice < (1u << dim); ++choice)
      {
        Index index;
        bool  exists = true;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int c = (choice >> d) & 1u;
            exists               = exists && c < n_candidates[d];
            index[d]             = candidates[d][exists ? c : 0];
          }
        if (exists && !lines.in_obstacle(index))
          return lattice.find(index);
      }
    return invalid;
  }



  template class CellLocator<2>;
  template class CellLocator<3>;
} // namespace seiche
