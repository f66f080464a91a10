// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/fill.h>
#include <seiche/mesh/assembled_faces.h>

#include <algorithm>
#include <numeric>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double fragment_below = 0.02; // share of a cell that is inside
  }                                         // namespace

  template <int dim>
  Fill<dim>::Fill(Occupancy<dim>      &grid_occupancy,
                  const QuadratureRule quadrature_rule,
                  const FilledVolume   filled_volume)
    : occupancy(grid_occupancy)
    , filled(filled_volume)
    , boxes(occupancy)
    , free_surface(quadrature_rule == QuadratureRule::cut_cells ?
                     std::make_unique<Surface<dim>>(occupancy) :
                     nullptr)
    , closed(occupancy)
  {}

  template <int dim>
  void
  Fill<dim>::update(const PointCloud<dim> &points)
  {
    if (filled == FilledVolume::current)
      find_current_volumes(points);
    sum_points(points);
    if (has_surface())
      find_surface(points);
    classify(points);
    closed.update(
      [this](const unsigned int cell) { return has_no_room(cell); });
    mark_inner_nodes();
    collect_ghost_faces(points);
  }

  template <int dim>
  void
  Fill<dim>::find_current_volumes(const PointCloud<dim> &points)
  {
    const double *initial = points.data(PointColumn::initial_volume);
    const double *ratio   = points.data(PointColumn::volume_ratio);
    current_volumes.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
      current_volumes[p] = ratio[p] * initial[p];
  }

  template <int dim>
  void
  Fill<dim>::sum_points(const PointCloud<dim> &points)
  {
    const auto &locator = occupancy.locator;
    double      total   = 0.;
    fill.assign(locator.cells.size(), 0.);
    node_fill.reinit(occupancy.nodes.partitioner());
    const double *volume = volumes(points);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const double sum =
          std::accumulate(volume + points.first_point(cell),
                          volume + points.first_point(cell + 1),
                          0.);
        fill[cell] = rounded(sum / locator.cells.geometry(cell).measure);
        total += sum;
        boxes.add(points, volume, cell, node_fill);
      }
    node_fill.compress(VectorOperation::add);

    double excess = 0.;
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      {
        const double full = occupancy.nodes.volume(i);
        double      &f    = node_fill.local_element(i);
        f                 = full > 0. ? rounded(f / full) : 0.;
        excess += std::max(0., f - 1.) * full;
      }
    node_fill.update_ghost_values();
    const MPI_Comm communicator = points.communicator;
    overfull                    = Utilities::MPI::sum(excess, communicator) /
               Utilities::MPI::sum(total, communicator);
  }

  template <int dim>
  bool
  Fill<dim>::has_no_room(const unsigned int cell) const
  {
    constexpr double round_off = 1e-9;
    if (!has_surface())
      return occupancy.cells.is_occupied(cell);
    return inside_share(cell) >=
           (walls().exist() ? walls().wet_share(cell) - round_off : 1.);
  }

  template <int dim>
  bool
  Fill<dim>::touches_unoccupied(const unsigned int cell) const
  {
    const auto neighbors = occupancy.locator.cells.vertex_neighbors(cell);
    return std::any_of(neighbors.begin(),
                       neighbors.end(),
                       [&](const unsigned int c) {
                         return !occupancy.cells.is_occupied(c);
                       });
  }

  template <int dim>
  void
  Fill<dim>::find_surface(const PointCloud<dim> &points)
  {
    const auto &locator = occupancy.locator;
    free_surface->update(node_fill);
    std::vector<unsigned int> without_points;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (!occupancy.cells.is_occupied(cell) &&
          surface().inside_share(cell) > 0.)
        without_points.push_back(cell);
    occupancy.cells.add(without_points);

    loose.assign(points.size(), 0.);
    has_loose.assign(locator.cells.n_owned(), 0);
    for (const unsigned int cell : occupancy.cells.occupied())
      if (!has_no_room(cell))
        for (const std::size_t p : points.points_in(cell))
          {
            // round-off must not make a point part of the quadrature
            loose[p]        = rounded(surface().loose_share(
              cell, locator.cells.geometry(cell).to_unit(points.position(p))));
            has_loose[cell] = has_loose[cell] || loose[p] > 0.;
          }
  }

  template <int dim>
  double
  Fill<dim>::loose_volume(const unsigned int     cell,
                          const PointCloud<dim> &points) const
  {
    if (!has_surface())
      return fill[cell];
    const double *share = loose_shares(points, cell);
    if (share == nullptr)
      return 0.;
    const double *volume = volumes(points) + points.first_point(cell);
    return std::inner_product(share,
                              share + points.n_points_in(cell),
                              volume,
                              0.) /
           occupancy.locator.cells.geometry(cell).measure;
  }

  template <int dim>
  void
  Fill<dim>::classify(const PointCloud<dim> &points)
  {
    const auto &locator = occupancy.locator;
    cut.assign(locator.cells.size(), 0);
    linear.assign(locator.cells.n_owned(), 0);
    extent_moments.assign(locator.cells.n_owned(), 0.);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        cut[cell] = has_surface() ? !is_full(cell) : touches_unoccupied(cell);
        linear[cell]       = cut[cell] || points.n_points_in(cell) == 0;
        const double loose = loose_volume(cell, points);
        if (loose > 0.)
          {
            // points may be larger than cells where the mesh was refined
            const double share =
              std::min(1., fill[cell] / points.n_points_in(cell));
            extent_moments[cell] = loose * std::pow(share, 2. / dim) / 12.;
          }
      }
    locator.cells.exchange_to_ghosts(cut);
  }

  template <int dim>
  void
  Fill<dim>::mark_inner_nodes()
  {
    // marks of own cells, added: an owner may not see a cell with a hanging
    // node whose master is its own
    inner.reinit(node_fill);
    for (unsigned int cell = 0; cell < occupancy.locator.cells.n_owned();
         ++cell)
      if (occupancy.cells.is_active(cell) &&
          (is_cut(cell) || !occupancy.cells.is_occupied(cell)))
        for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
          inner.local_element(occupancy.nodes.of_cell(cell)[a]) = 1.;
    inner.compress(VectorOperation::add);
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      inner.local_element(i) = inner.local_element(i) > 0. ? 0. : 1.;
    inner.update_ghost_values();
  }

  template <int dim>
  std::vector<double>
  Fill<dim>::penalised_fluid(const PointCloud<dim> &points) const
  {
    const auto         &cells = occupancy.locator.cells;
    std::vector<double> result(cells.size(), 1.);
    if (!has_surface())
      return result;
    for (const unsigned int cell : occupancy.cells.occupied())
      if (is_spray(cell))
        result[cell] = std::min(1., loose_volume(cell, points));
    cells.exchange_to_ghosts(result);
    return result;
  }

  template <int dim>
  void
  Fill<dim>::collect_ghost_faces(const PointCloud<dim> &points)
  {
    const std::vector<double> fluid       = penalised_fluid(points);
    const auto                is_fragment = [&](const unsigned int cell) {
      return occupancy.cells.holds_points(cell) &&
             inside_share(cell) < fragment_below * walls().wet_share(cell);
    };
    faces.clear();
    for_each_assembled_face(
      occupancy.locator,
      occupancy.cells.occupied(),
      [&](const unsigned int cell) {
        return occupancy.cells.is_occupied(cell);
      },
      [&](const unsigned int lower,
          const unsigned int upper,
          const unsigned int direction) {
        if (is_cut(lower) || is_cut(upper))
          faces.push_back({lower,
                           upper,
                           direction,
                           is_fragment(lower) || is_fragment(upper),
                           std::min(fluid[lower], fluid[upper])});
      });
  }

  template class Fill<2>;
  template class Fill<3>;
} // namespace seiche
