// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/surface.h>
#include <seiche/space/point_batch.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_corrections      = 2;
    constexpr double       longest_correction = 0.25; // [cells]
    constexpr double       least_slope = 0.35; // of the fill over the distance
    constexpr double       negligible  = 1e-9; // share of a cell
    constexpr double empty_or_full     = 1e-6; // fill that needs no correction

    constexpr double least_loose = 1e-4; // no cell is without quadrature

    /// Distance [cells] of a node with this fill from a flat surface, positive
    /// inside: exact along the grid, for the integral of a hat.
    double
    distance(const double fill)
    {
      const double f = std::clamp(fill, 0., 1.);
      return f >= 0.5 ? 1. - std::sqrt(2. * (1. - f)) : -1. + std::sqrt(2. * f);
    }

    /// For each vertex of an own cut cell, sum of n_d^2 over the walls at it, n
    /// the normal of the surface, d that of the wall: 1 if they are parallel.
    template <int dim>
    VertexValues<dim>
    along_walls(const VertexValues<dim> &phi,
                const CellLocator<dim>  &locator,
                const unsigned int       cell)
    {
      std::array<double, dim> square{};
      double                  sum = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          double difference = 0.;
          for (unsigned int v = 0; v < phi.size(); ++v)
            difference += (v >> d & 1u) != 0 ? phi[v] : -phi[v];
          square[d] = difference * difference;
          sum += square[d];
        }
      VertexValues<dim> result{};
      for (const BoxFace face : GeometryInfo<dim>::face_indices())
        if (sum > 0. && locator.cells.wall_at(cell, face))
          for (unsigned int v = 0; v < result.size(); ++v)
            if (face.has_vertex(v))
              result[v] += square[face.direction()] / sum;
      return result;
    }
  } // namespace

  template <int dim>
  Surface<dim>::Surface(const Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
    , level_at_walls(grid_occupancy)
  {}

  template <int dim>
  void
  Surface<dim>::update(const Vector &nodal_fill)
  {
    level.reinit(occupancy.nodes.partitioner());
    set_level(walls().exist() ? continued_fill(nodal_fill) : nodal_fill);
    follow(nodal_fill);
    represented.reinit(level);
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      if (const double fill = nodal_fill.local_element(i); fill > 0.)
        represented.local_element(i) =
          std::min(1., inside_fill.local_element(i) / fill);
    represented.update_ghost_values();
    inside_fill.update_ghost_values();
  }

  template <int dim>
  void
  Surface<dim>::set_level(const Vector &fill)
  {
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      level.local_element(i) = nonzero_level(-distance(fill.local_element(i)));
    level.update_ghost_values();
    level_at_walls.extend(level);
  }

  template <int dim>
  void
  Surface<dim>::follow(const Vector &fill)
  {
    cut_cells(/*at_walls=*/false);
    integrate(/*at_walls=*/false);
    for (unsigned int i = 0; i < n_corrections; ++i)
      {
        correct(fill);
        level_at_walls.extend(level);
        const bool is_last = i + 1 == n_corrections;
        cut_cells(/*at_walls=*/is_last);
        integrate(/*at_walls=*/is_last);
      }
  }

  template <int dim>
  double
  Surface<dim>::loose_share(const unsigned int cell,
                            const Point<dim>  &unit) const
  {
    PointBatch<dim, 1, double> point;
    double                     r[point.n_nodes];
    occupancy.vertex_values(cell, represented, r);
    point.reinit_values(unit);
    const double missing = 1. - point.value(r);
    return shares[cell] == 0. ?
             std::max(missing, least_loose) :
             missing * (1. - shares[cell] / walls().wet_share(cell));
  }

  template <int dim>
  VertexValues<dim>
  Surface<dim>::level_in(const unsigned int cell) const
  {
    VertexValues<dim> result;
    occupancy.vertex_values(cell, level, result.data());
    return result;
  }

  template <int dim>
  void
  Surface<dim>::cut_cells(const bool at_walls)
  {
    const auto &locator = occupancy.locator;
    shares.assign(locator.cells.size(), 0.);
    rule_of_cell.assign(locator.cells.n_owned(), numbers::invalid_unsigned_int);
    rules.clear();
    wet_parts.clear();
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (occupancy.cells.is_active(cell))
        {
          if (at_walls && walls().cuts(cell))
            cut_at_wall(cell);
          else if (!at_walls || walls().wet_share(cell) > 0.)
            cut_cell(cell);
        }
    locator.cells.exchange_to_ghosts(shares);
  }

  template <int dim>
  void
  Surface<dim>::cut_cell(const unsigned int cell)
  {
    const CutCell<dim> part(level_in(cell));
    if (part.volume() > 1. - negligible)
      shares[cell] = 1.;
    else if (part.volume() > negligible)
      {
        shares[cell]       = part.volume();
        rule_of_cell[cell] = rules.size();
        rules.push_back(part.points());
      }
  }

  template <int dim>
  void
  Surface<dim>::cut_at_wall(const unsigned int cell)
  {
    const VertexValues<dim> phi = rounded<dim>(level_in(cell));
    const double            wet = walls().wet_share(cell);
    if (std::all_of(phi.begin(), phi.end(), [](const double value) {
          return value < 0.;
        }))
      {
        shares[cell]       = wet;
        rule_of_cell[cell] = whole;
        return;
      }
    WetPart<dim> part(phi,
                      walls().distance(cell),
                      occupancy.locator.cells.geometry(cell));
    if (part.volume <= negligible)
      return;
    walls().name_solids(cell, part.wall);
    shares[cell]       = part.volume;
    rule_of_cell[cell] = wet_parts.size();
    wet_parts.push_back(std::move(part));
  }

  template <int dim>
  void
  Surface<dim>::integrate(const bool at_walls)
  {
    PointBatch<dim, 1, double> point;
    const auto                &locator = occupancy.locator;
    inside_fill.reinit(occupancy.nodes.partitioner());
    double of_vertices[point.n_nodes];
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        if (shares[cell] == 0. || walls().wet_share(cell) == 0.)
          continue;
        std::fill(std::begin(of_vertices), std::end(of_vertices), 0.);
        const double measure = locator.cells.geometry(cell).measure;
        if (!at_walls && walls().cuts(cell))
          {
            const VertexValues<dim> hats =
              hat_integrals<dim>(rounded<dim>(level_in(cell)),
                                 walls().distance(cell));
            for (unsigned int v = 0; v < point.n_nodes; ++v)
              of_vertices[v] = hats[v] * measure;
          }
        else if (rule_of_cell[cell] == numbers::invalid_unsigned_int)
          std::fill(std::begin(of_vertices),
                    std::end(of_vertices),
                    measure / point.n_nodes);
        else
          for_each_point(cell, [&](const Point<dim> &x, const double weight) {
            point.reinit_values(x);
            for (unsigned int v = 0; v < point.n_nodes; ++v)
              of_vertices[v] += point.N[v] * weight * measure;
          });
        occupancy.add_vertex_values(cell, of_vertices, inside_fill);
      }
    inside_fill.compress(VectorOperation::add);
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      if (const double volume = occupancy.nodes.volume(i); volume > 0.)
        inside_fill.local_element(i) /= volume;
  }

  template <int dim>
  void
  Surface<dim>::correct(const Vector &nodal_fill)
  {
    // over the cut cells at a node: their number, and n_d^2 of the surface's
    // normal for each wall that halves the hat function in direction d
    Vector            cells(occupancy.nodes.partitioner()), halved(cells);
    VertexValues<dim> ones;
    ones.fill(1.);
    for (unsigned int cell = 0; cell < occupancy.locator.cells.n_owned();
         ++cell)
      if (shares[cell] > 0. && shares[cell] < 1.)
        {
          occupancy.add_vertex_values(cell, ones.data(), cells);
          occupancy.add_vertex_values(
            cell,
            along_walls(level_in(cell), occupancy.locator, cell).data(),
            halved);
        }
    cells.compress(VectorOperation::add);
    halved.compress(VectorOperation::add);
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      {
        const double f = inside_fill.local_element(i);
        if (cells.local_element(i) == 0. || f < empty_or_full ||
            f > 1. - empty_or_full)
          continue;
        double      &d = level.local_element(i);
        const double slope =
          std::max(1. - std::abs(d), least_slope) *
          (1. + halved.local_element(i) / cells.local_element(i));
        const double change =
          (f - std::min(1., nodal_fill.local_element(i))) / slope;
        d = nonzero_level(std::clamp(
          d + std::clamp(change, -longest_correction, longest_correction),
          -1.,
          1.));
      }
    level.update_ghost_values();
  }

  template class Surface<2>;
  template class Surface<3>;
} // namespace seiche
