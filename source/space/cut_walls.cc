// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/basis.h>
#include <seiche/space/mesh_nodes.h>
#include <seiche/space/surface_pieces.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Distances below it [cells] are zero: no cell has a thinner part.
    constexpr double on_wall = 1e-6;

    /// Shares of a cell below it are nothing but round-off.
    constexpr double negligible = 1e-12;

    /// Smallest edges of the cells at each node [m]; own nodes are right.
    template <int dim>
    std::vector<double>
    sizes_at_nodes(const MeshNodes<dim> &mesh)
    {
      std::vector<double> result(mesh.size(),
                                 std::numeric_limits<double>::max());
      for (unsigned int cell = 0; cell < mesh.locator.cells.size(); ++cell)
        for (unsigned int a = 0; a < mesh.fe.n_dofs_per_cell(); ++a)
          {
            double &size = result[mesh.of_cell(cell)[a]];
            size =
              std::min(size, mesh.locator.cells.geometry(cell).shortest_edge());
          }
      return result;
    }
  } // namespace

  template <int dim>
  unsigned int
  CutWalls<dim>::solid_near(const unsigned int cell,
                            const Point<dim>  &unit) const
  {
    const auto &solids = locator->solids;
    return nearest_solid(solids, locator->cells.geometry(cell).to_real(unit)) -
           solids.data();
  }

  template <int dim>
  void
  CutWalls<dim>::name_solids(const unsigned int           cell,
                             std::vector<WallPoint<dim>> &wall) const
  {
    const auto &solids = locator->solids;
    for (WallPoint<dim> &point : wall)
      {
        const Point<dim> x = locator->cells.geometry(cell).to_real(point.unit);
        const Solid<dim> *const solid = nearest_solid(solids, x);
        point.solid                   = solid - solids.data();
        point.normal                  = -solid->shape->normal(x);
      }
  }

  template <int dim>
  void
  CutWalls<dim>::reinit(const MeshNodes<dim> &mesh)
  {
    locator            = &mesh.locator;
    const auto &cells  = locator->cells;
    const auto &solids = locator->solids;
    if (solids.empty())
      return;
    const std::vector<double> sizes = sizes_at_nodes(mesh);

    LinearAlgebra::distributed::Vector<double> nodal(mesh.partitioner());
    std::vector<Point<dim>> places(nodal.locally_owned_size());
    for (unsigned int i = 0; i < places.size(); ++i)
      places[i] = mesh.position(i);
    const std::vector<double> distances = distances_of_nodes.at(solids, places);
    for (unsigned int i = 0; i < places.size(); ++i)
      nodal.local_element(i) =
        std::abs(distances[i]) < on_wall * sizes[i] ? 0. : distances[i];
    nodal.update_ghost_values();

    // what no solid has moved through is as it was
    std::vector<Part>               old_parts = std::exchange(parts, {});
    const std::vector<unsigned int> old_part_of_cell =
      std::exchange(part_of_cell,
                    std::vector<unsigned int>(cells.size(), none));
    shares.assign(cells.size(), 0.);
    VertexValues<dim> inside;
    inside.fill(-1.);
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      {
        Part part;
        mesh.vertex_values(cell, nodal, part.distance.data());
        const auto [lowest, highest] =
          std::minmax_element(part.distance.begin(), part.distance.end());
        if (*highest <= 0.)
          continue;
        if (*lowest > 0.)
          {
            shares[cell] = 1.;
            continue;
          }
        part.lower = cells.geometry(cell).lower;
        part.upper = cells.geometry(cell).upper;
        if (cell < old_part_of_cell.size() && old_part_of_cell[cell] != none &&
            old_parts[old_part_of_cell[cell]].lies_like(part))
          part = std::move(old_parts[old_part_of_cell[cell]]);
        else
          {
            part.whole =
              WetPart<dim>(inside, part.distance, cells.geometry(cell));
            if (part.whole.volume < negligible)
              continue;
            name_solids(cell, part.whole.wall);
          }
        if (part.whole.wall.empty()) // it touches
          {
            shares[cell] = 1.;
            continue;
          }
        shares[cell]       = std::min(1., part.whole.volume);
        part_of_cell[cell] = parts.size();
        parts.push_back(std::move(part));
      }
  }

  template <int dim>
  VertexValues<dim>
  CutWalls<dim>::hat_integrals(const unsigned int cell) const
  {
    VertexValues<dim> result;
    result.fill(cuts(cell) ? 0. : wet_share(cell) / result.size());
    if (cuts(cell))
      for (const WeightedPoint<dim> &point : whole(cell).points)
        add_hats<dim>(point, result);
    return result;
  }

  template <int dim>
  VertexValues<dim>
  CutWalls<dim>::hats_in_solids(const unsigned int       cell,
                                const VertexValues<dim> &level) const
  {
    const auto        is_inside = [](const double value) { return value < 0.; };
    VertexValues<dim> result{};
    if (std::none_of(level.begin(), level.end(), is_inside))
      return result;
    if (std::all_of(level.begin(), level.end(), is_inside))
      {
        const VertexValues<dim> wet = hat_integrals(cell);
        for (unsigned int v = 0; v < result.size(); ++v)
          result[v] = 1. / result.size() - wet[v];
        return result;
      }
    VertexValues<dim> behind;
    behind.fill(1.);
    if (cuts(cell))
      behind = negated<dim>(distance(cell));
    return seiche::hat_integrals<dim>(level, behind);
  }

  template class CutWalls<2>;
  template class CutWalls<3>;
} // namespace seiche
