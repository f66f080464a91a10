// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/fill.h>
#include <seiche/utilities/shape_functions.h>

#include <deal.II/base/geometry_info.h>

#include <numeric>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    // doc/theory.md, table of cell classes: the only thresholds of this kind
    constexpr double thin_below            = 0.7;
    constexpr double sliver_below          = 0.3;
    constexpr double inner_needs_fill      = 0.3;
    constexpr double surface_weight_begins = 0.7;
    constexpr double surface_weight_range  = 0.25;
    constexpr double detached_below        = 0.5;
    constexpr double fragment_below        = 0.02;

    double
    rounded(const double fill)
    {
      return std::round(fill * 1e10) * 1e-10;
    }
  } // namespace

  template <int dim>
  Fill<dim>::Fill(Occupancy<dim>      &grid_occupancy,
                  const QuadratureRule quadrature_rule,
                  const FilledVolume   filled_volume)
    : occupancy(grid_occupancy)
    , rule(quadrature_rule)
    , filled(filled_volume)
    , boxes(occupancy)
    , free_surface(rule == QuadratureRule::cut_cells ?
                     std::make_unique<Surface<dim>>(occupancy) :
                     nullptr)
  {}

  template <int dim>
  void
  Fill<dim>::update(const PointCloud<dim> &points)
  {
    if (filled == FilledVolume::current)
      find_current_volumes(points);
    sum_points(points);
    if (rule == QuadratureRule::cut_cells)
      find_surface(points);
    classify(points);
    collect_linear_cells(points);
    collect_ghost_faces();
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
  Fill<dim>::add_values(const PointCloud<dim> &points, const unsigned int cell)
  {
    // by the hats of FE_Q(1), for every degree
    using Shape          = TensorShape<dim, 1>;
    const double *volume = volumes(points);
    double        N[Shape::n_nodes], nodal[HangingNodes<dim>::max_nodes] = {};
    for (std::size_t p = points.first_point(cell);
         p < points.first_point(cell + 1);
         ++p)
      {
        Shape::values(points.locator.to_unit(cell, points.position(p)), N);
        for (unsigned int v = 0; v < Shape::n_nodes; ++v)
          nodal[occupancy.vertex_node(v)] += N[v] * volume[p];
      }
    occupancy.condense(cell, nodal);
    const unsigned int *nodes = occupancy.cell_nodes(cell);
    for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
      node_fill.local_element(nodes[a]) += nodal[a];
  }

  template <int dim>
  void
  Fill<dim>::sum_points(const PointCloud<dim> &points)
  {
    const auto &locator = occupancy.locator;
    double      total   = 0.;
    fill.assign(locator.n_cells(), 0.);
    node_fill.reinit(occupancy.scalar_partitioner());
    const double *volume = volumes(points);
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        const double sum =
          std::accumulate(volume + points.first_point(cell),
                          volume + points.first_point(cell + 1),
                          0.);
        fill[cell] = rounded(sum / locator.measure(cell));
        total += sum;
        if (rule == QuadratureRule::cut_cells)
          boxes.add(points, volume, cell, node_fill);
        else
          add_values(points, cell);
      }
    node_fill.compress(VectorOperation::add);

    double excess = 0.;
    for (unsigned int i = 0; i < occupancy.n_own_nodes(); ++i)
      {
        const double full = occupancy.node_volume(i);
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
  Fill<dim>::touches_unoccupied(const unsigned int cell) const
  {
    const auto neighbors = occupancy.locator.vertex_neighbors(cell);
    return std::any_of(neighbors.begin(),
                       neighbors.end(),
                       [&](const unsigned int c) {
                         return !occupancy.is_occupied(c);
                       });
  }

  template <int dim>
  void
  Fill<dim>::find_surface(const PointCloud<dim> &points)
  {
    const auto &locator = occupancy.locator;
    free_surface->update(node_fill);
    std::vector<unsigned int> without_points;
    for (unsigned int cell = 0; cell < locator.n_owned(); ++cell)
      if (!occupancy.is_occupied(cell) && surface().inside_share(cell) > 0.)
        without_points.push_back(cell);
    occupancy.occupy(without_points);

    loose.assign(points.size(), 0.);
    has_loose.assign(locator.n_owned(), 0);
    for (const unsigned int cell : occupancy.occupied_cells())
      if (surface().inside_share(cell) < 1.)
        for (std::size_t p = points.first_point(cell);
             p < points.first_point(cell + 1);
             ++p)
          {
            loose[p] =
              surface().loose_share(cell,
                                    locator.to_unit(cell, points.position(p)));
            has_loose[cell] = has_loose[cell] || loose[p] > 0.;
          }
  }

  template <int dim>
  bool
  Fill<dim>::is_detached(const unsigned int cell, const double *at_nodes) const
  {
    const auto &locator = occupancy.locator;
    for (const unsigned int face : GeometryInfo<dim>::face_indices())
      {
        const types::boundary_id wall = locator.boundary_id(cell, face);
        if (wall == numbers::internal_face_boundary_id ||
            locator.grid.wall_condition(wall) != WallCondition::unilateral)
          continue;
        for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
          if (((v >> (face / 2)) & 1u) == face % 2 &&
              at_nodes[occupancy.vertex_node(v)] < detached_below)
            return true;
      }
    return false;
  }

  template <int dim>
  typename Fill<dim>::Content
  Fill<dim>::content(const unsigned int     cell,
                     const PointCloud<dim> &points) const
  {
    if (rule == QuadratureRule::cut_cells)
      {
        const double  share  = surface().inside_share(cell);
        const double *part   = loose_shares(points, cell);
        const double *volume = volumes(points) + points.first_point(cell);
        double        loose  = 0.;
        if (part != nullptr)
          for (unsigned int p = 0; p < points.n_points_in(cell); ++p)
            loose += part[p] * volume[p];
        loose /= occupancy.locator.measure(cell);
        return {share < 1.,
                share < 1. ? 0. : 1.,
                loose,
                share + loose,
                share < fragment_below};
      }
    double              at_nodes[HangingNodes<dim>::max_nodes];
    const unsigned int *nodes = occupancy.cell_nodes(cell);
    for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
      at_nodes[a] = node_fill.local_element(nodes[a]);
    occupancy.expand(cell, at_nodes);
    const bool is_cut = touches_unoccupied(cell) || is_detached(cell, at_nodes);
    double     weight = 0.;
    if (rule == QuadratureRule::hybrid)
      {
        double least = std::numeric_limits<double>::max();
        for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
          least = std::min(least, at_nodes[occupancy.vertex_node(v)]);
        // distance to the surface first, fill second: lattices stretched by
        // the flow make fill vary where there is no surface
        weight =
          is_cut ?
            std::clamp((least - surface_weight_begins) / surface_weight_range,
                       0.,
                       1.) :
            (least > inner_needs_fill ? 1. : 0.);
      }
    return {is_cut, weight, (1. - weight) * fill[cell], fill[cell], true};
  }

  template <int dim>
  void
  Fill<dim>::classify(const PointCloud<dim> &points)
  {
    const unsigned int n_cells = occupancy.locator.n_cells();
    weight.assign(n_cells, 0.);
    extent_moments.assign(occupancy.locator.n_owned(), 0.);
    flags.assign(n_cells, 0);
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        const Content here = content(cell, points);
        weight[cell]       = here.gauss_weight;
        if (here.is_cut)
          flags[cell] |= cut;
        if (here.is_cut && here.is_fragment && here.volume < thin_below)
          flags[cell] |= thin;
        if (weight[cell] < 1. && here.is_fragment && here.volume < sliver_below)
          flags[cell] |= sliver;
        if (here.loose > 0.)
          {
            // points may be larger than cells where the mesh was refined
            const double share =
              std::min(1., fill[cell] / points.n_points_in(cell));
            extent_moments[cell] = here.loose * std::pow(share, 2. / dim) / 12.;
          }
      }
    occupancy.locator.exchange_to_ghosts(weight);
    std::vector<double> values(flags.begin(), flags.end());
    occupancy.locator.exchange_to_ghosts(values);
    std::copy(values.begin(), values.end(), flags.begin());
  }

  template <int dim>
  void
  Fill<dim>::collect_linear_cells(const PointCloud<dim> &points)
  {
    linear.assign(occupancy.locator.n_owned(), 0);
    for (const unsigned int cell : occupancy.occupied_cells())
      linear[cell] = is_cut(cell) || points.n_points_in(cell) == 0 ||
                     (rule == QuadratureRule::hybrid && weight[cell] < 1.);
  }

  template <int dim>
  void
  Fill<dim>::collect_ghost_faces()
  {
    faces.clear();
    occupancy.for_each_assembled_face(
      occupancy.occupied_cells(),
      [&](const unsigned int cell) { return occupancy.is_occupied(cell); },
      [&](const unsigned int lower,
          const unsigned int upper,
          const unsigned int direction) {
        if (is_cut(lower) || is_cut(upper))
          faces.push_back(
            {lower, upper, direction, is_thin(lower) || is_thin(upper)});
      });
  }

  template class Fill<2>;
  template class Fill<3>;
} // namespace seiche
