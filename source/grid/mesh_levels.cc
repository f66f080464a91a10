// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/mesh_adaptation.h>

#include <algorithm>
#include <limits>

// The part of MeshAdaptation that chooses the levels of cells.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Distance of two boxes, the largest of the directions, the shorter way
    /// around in periodic ones; zero if they touch or overlap.
    template <int dim>
    double
    gap(const BoundingBox<dim>    &a,
        const BoundingBox<dim>    &b,
        const GridParameters<dim> &grid)
    {
      double result = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double above = a.lower_bound(d) - b.upper_bound(d);
          const double below = b.lower_bound(d) - a.upper_bound(d);
          double       here  = std::max(above, below);
          if (grid.is_periodic(d))
            here = std::min(here,
                            grid.upper_corner[d] - grid.lower_corner[d] +
                              std::min(above, below));
          result = std::max(result, here);
        }
      return result;
    }

    /// f(cell), true if it changed the cell's value, for all own cells again
    /// and again until no rank changes anything. Collective.
    template <int dim, typename Function>
    void
    until_settled(const CellLocator<dim> &locator,
                  std::vector<double>    &values,
                  const Function         &f)
    {
      const MPI_Comm communicator =
        locator.grid.triangulation.get_communicator();
      for (bool changed = true; changed;)
        {
          locator.cells.exchange_to_ghosts(values);
          changed = false;
          for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
            changed = f(cell) || changed;
          changed = Utilities::MPI::max(changed ? 1 : 0, communicator) == 1;
        }
    }
  } // namespace

  template <int dim>
  void
  MeshAdaptation<dim>::choose_levels()
  {
    wanted_level.assign(locator.cells.size(), 0.);
    for (const auto &criterion : parameters.criteria)
      claim(criterion);
    grade();
    choose_next_levels();
  }

  template <int dim>
  void
  MeshAdaptation<dim>::grade()
  {
    until_settled(locator, wanted_level, [&](const unsigned int cell) {
      const double before = wanted_level[cell];
      for (const unsigned int other : locator.cells.vertex_neighbors(cell))
        wanted_level[cell] =
          std::max(wanted_level[cell], wanted_level[other] - 1.);
      return wanted_level[cell] != before;
    });
  }

  template <int dim>
  void
  MeshAdaptation<dim>::choose_next_levels()
  {
    next_level.resize(locator.cells.size());
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        const double level = locator.cells.level(cell);
        next_level[cell] =
          std::clamp(wanted_level[cell], level - 1., level + 1.);
      }
    until_settled(locator, next_level, [&](const unsigned int cell) {
      const double level = locator.cells.level(cell);
      if (next_level[cell] >= level || may_coarsen(cell))
        return false;
      next_level[cell] = level;
      return true;
    });
  }

  template <int dim>
  bool
  MeshAdaptation<dim>::may_coarsen(const unsigned int cell) const
  {
    const double level = locator.cells.level(cell);
    // A neighbour that is finer now counts even if it coarsens in this pass:
    // the forest does not know the flags of other ranks' cells.
    for (const unsigned int other : locator.cells.vertex_neighbors(cell))
      if (std::max<double>(next_level[other], locator.cells.level(other)) >
          level)
        return false;
    const auto parent = locator.cells.iterator(cell)->parent();
    for (const auto &child : parent->child_iterators())
      if (!child->is_active() ||
          next_level[locator.cells.index(child)] >= level)
        return false;
    return true;
  }

  template <int dim>
  void
  MeshAdaptation<dim>::claim(const RefinementCriterion<dim> &criterion)
  {
    const double level = grid.lattice_level() + criterion.level;
    if (criterion.follows_fluid())
      return claim_around(criterion.kind == RefinementKind::fluid ?
                            holds_fluid :
                            at_surface,
                          level,
                          criterion.layers);
    auto places = criterion.places;
    for (BoundingBox<dim> &place : places)
      {
        const auto &[low, high] = place.get_boundary_points();
        if (criterion.kind == RefinementKind::walls)
          place = {std::make_pair(locator.lines.moved(low),
                                  locator.lines.moved(high))};
        else if (criterion.kind == RefinementKind::probes)
          {
            const auto there =
              grid.parameters.with_sides(low, locator.lines.domain());
            place = {std::make_pair(there, there)};
          }
      }
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        bool wanted = criterion.kind == RefinementKind::box;
        if (!wanted && holds_fluid[cell])
          wanted = true;
        if (wanted &&
            std::any_of(places.begin(),
                        places.end(),
                        [&](const BoundingBox<dim> &place) {
                          return gap(place,
                                     locator.cells.geometry(cell).box(),
                                     grid.parameters) <= criterion.distance;
                        }))
          wanted_level[cell] = std::max(wanted_level[cell], level);
      }
  }

  template <int dim>
  void
  MeshAdaptation<dim>::claim_around(const std::vector<char> &seeds,
                                    const double             level,
                                    const unsigned int       layers)
  {
    // Gap to the nearest seed in cells of the level (of the finest lattice's
    // size, so that levels above and below it count right), growing from
    // neighbour to neighbour; a seed's own neighbours have gap zero.
    const double        unit = std::pow(2., grid.finest_level() - level);
    const double        far  = std::numeric_limits<double>::max();
    std::vector<double> begin(locator.cells.size(), far); // gap of what follows
    std::vector<double> distance(locator.cells.n_owned(), far);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (seeds[cell])
        begin[cell] = distance[cell] = 0.;
    until_settled(locator, begin, [&](const unsigned int cell) {
      for (const unsigned int other : locator.cells.vertex_neighbors(cell))
        distance[cell] = std::min(distance[cell], begin[other]);
      if (seeds[cell] || distance[cell] >= layers * unit)
        return false;
      const double before = begin[cell];
      begin[cell]         = distance[cell] + locator.lattice.size(cell);
      return begin[cell] != before;
    });
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (distance[cell] < layers * unit)
        wanted_level[cell] = std::max(wanted_level[cell], level);
  }

  template void
  MeshAdaptation<2>::choose_levels();
  template void
  MeshAdaptation<3>::choose_levels();
} // namespace seiche
