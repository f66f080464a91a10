// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/node_pattern.h>
#include <seiche/space/component_partitioner.h>

#include <algorithm>
#include <numeric>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  NodePattern<dim>::NodePattern(const Fill<dim> &grid_fill)
    : fill(grid_fill)
    , occupancy(grid_fill.occupancy)
    , n_nodes(occupancy.nodes_per_cell())
  {}

  template <int dim>
  bool
  NodePattern<dim>::reinit()
  {
    const bool keep = numbering_generation == occupancy.nodes.generation() &&
                      covers(fill.ghost_faces());
    if (Utilities::MPI::min(
          keep ? 1 : 0,
          occupancy.nodes.partitioner()->get_mpi_communicator()) == 1)
      return false;
    numbering_generation = occupancy.nodes.generation();
    collect_couplings();
    exchange_couplings();
    build_tables();
    return true;
  }

  template <int dim>
  bool
  NodePattern<dim>::covers(const std::vector<GhostFace> &faces) const
  {
    const auto &cells = occupancy.cells.occupied();
    return std::all_of(cells.begin(),
                       cells.end(),
                       [&](const unsigned int cell) {
                         return covered_cells[cell] >= occupancy.degree(cell);
                       }) &&
           std::all_of(faces.begin(), faces.end(), [&](const GhostFace &face) {
             return covered_faces[face_index(
                      face.lower, face.upper, face.direction)] >= degree(face);
           });
  }

  template <int dim>
  unsigned int
  NodePattern<dim>::degree(const GhostFace &face) const
  {
    return std::max(occupancy.degree(face.lower), occupancy.degree(face.upper));
  }

  template <int dim>
  std::size_t
  NodePattern<dim>::face_index(const unsigned int lower,
                               const unsigned int upper,
                               const unsigned int direction) const
  {
    const auto &locator = occupancy.locator;
    return locator.cells.level(lower) >= locator.cells.level(upper) ?
             lower * 2 * dim + BoxFace(direction, /*upper=*/true) :
             upper * 2 * dim + BoxFace(direction, /*upper=*/false);
  }

  template <int dim>
  void
  NodePattern<dim>::collect_couplings()
  {
    // Groups of mutually coupled nodes: cells, pairs of cells across ghost
    // faces, each node alone.
    std::vector<unsigned int> group_begin = {0}, group_nodes;
    const auto                add_nodes   = [&](const unsigned int cell,
                               const unsigned int with) {
      with_degree(with, [&](const auto degree) {
        const auto nodes = occupancy.template unknowns<degree>(cell);
        for (unsigned int a = 0; a < Basis<dim, degree>::n_nodes; ++a)
          group_nodes.push_back(nodes[a]);
      });
    };
    covered_cells.assign(occupancy.locator.cells.n_owned(), 0);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        covered_cells[cell] = occupancy.degree(cell);
        add_nodes(cell, occupancy.degree(cell));
        group_begin.push_back(group_nodes.size());
      }
    covered_faces.assign(occupancy.locator.cells.size() * 2 * dim, 0);
    for (const GhostFace &face : fill.ghost_faces())
      {
        covered_faces[face_index(face.lower, face.upper, face.direction)] =
          degree(face);
        add_nodes(face.lower, degree(face));
        add_nodes(face.upper, degree(face));
        group_begin.push_back(group_nodes.size());
      }

    // groups at each node, then the union of their nodes
    const unsigned int        n_rows = occupancy.nodes.n_local();
    std::vector<unsigned int> at_begin(n_rows + 1, 0), at;
    for (const unsigned int node : group_nodes)
      ++at_begin[node + 1];
    std::partial_sum(at_begin.begin(), at_begin.end(), at_begin.begin());
    at.resize(group_nodes.size());
    std::vector<unsigned int> next(at_begin.begin(), at_begin.end() - 1);
    for (unsigned int g = 0; g + 1 < group_begin.size(); ++g)
      for (unsigned int i = group_begin[g]; i < group_begin[g + 1]; ++i)
        at[next[group_nodes[i]]++] = g;

    begin_of_row.assign(1, 0);
    column.clear();
    std::vector<unsigned int> last_seen(n_rows, numbers::invalid_unsigned_int);
    for (unsigned int row = 0; row < n_rows; ++row)
      {
        last_seen[row] = row;
        column.push_back(row);
        for (unsigned int i = at_begin[row]; i < at_begin[row + 1]; ++i)
          for (unsigned int j = group_begin[at[i]]; j < group_begin[at[i] + 1];
               ++j)
            if (last_seen[group_nodes[j]] != row)
              {
                last_seen[group_nodes[j]] = row;
                column.push_back(group_nodes[j]);
              }
        std::sort(column.begin() + begin_of_row.back(), column.end());
        begin_of_row.push_back(column.size());
      }
  }

  template <int dim>
  void
  NodePattern<dim>::build_tables()
  {
    const auto &nodes = *occupancy.nodes.partitioner();
    column_of_node.resize(occupancy.nodes.n_local());
    for (unsigned int i = 0; i < column_of_node.size(); ++i)
      column_of_node[i] = columns->global_to_local(nodes.local_to_global(i));
    diagonal.resize(occupancy.nodes.n_own());
    for (unsigned int i = 0; i < diagonal.size(); ++i)
      diagonal[i] = entry(i, i);
    const std::size_t n_pairs = n_nodes * n_nodes;
    scatter.resize(occupancy.locator.cells.n_owned() * n_pairs);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        std::uint16_t *table = &scatter[cell * n_pairs];
        with_degree(occupancy.degree(cell), [&](const auto degree) {
          constexpr unsigned int n = Basis<dim, degree>::n_nodes;
          const auto node          = occupancy.template unknowns<degree>(cell);
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              table[node.place(a) * n_nodes + node.place(b)] =
                entry(node[a], node[b]) - begin_of_row[node[a]];
        });
      }
  }

  template <int dim>
  unsigned int
  NodePattern<dim>::entry(const unsigned int row_node,
                          const unsigned int column_node) const
  {
    return find(row_node, column_of_node[column_node]);
  }

  template <int dim>
  unsigned int
  NodePattern<dim>::find(const unsigned int row_node,
                         const unsigned int column_number) const
  {
    const auto begin = column.begin() + begin_of_row[row_node];
    const auto end   = column.begin() + begin_of_row[row_node + 1];
    const auto found = std::lower_bound(begin, end, column_number);
    Assert(found != end && *found == column_number, ExcInternalError());
    return found - column.begin();
  }

  template <int dim>
  void
  NodePattern<dim>::find_entries(const unsigned int  row_node,
                                 const unsigned int *wanted,
                                 const unsigned int  n,
                                 unsigned int       *entries) const
  {
    unsigned int k = begin_of_row[row_node];
    for (unsigned int i = 0; i < n; ++i)
      {
        for (; column[k] != wanted[i]; ++k)
          AssertIndexRange(k + 1, begin_of_row[row_node + 1]);
        entries[i] = k;
      }
  }

  template <int dim>
  std::shared_ptr<const Utilities::MPI::Partitioner>
  NodePattern<dim>::make_partitioner(const unsigned int components) const
  {
    return component_partitioner(*columns, components);
  }

  template class NodePattern<2>;
  template class NodePattern<3>;
} // namespace seiche
