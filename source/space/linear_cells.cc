// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/basis.h>
#include <seiche/space/linear_cells.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <optional>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Nodes at the vertices of the edge, face or cell in whose middle node a
    /// of a cell lies; of a vertex itself.
    template <int dim>
    std::vector<unsigned int>
    ends_of(const unsigned int a)
    {
      using Shape = Basis<dim, 2>;
      std::vector<unsigned int> result;
      for (unsigned int v = 0; v < (1u << dim); ++v)
        {
          bool is_end = true;
          for (unsigned int d = 0; d < dim; ++d)
            is_end = is_end && (Shape::line_index(a, d) == 1 ||
                                Shape::line_index(a, d) == 2 * ((v >> d) & 1u));
          if (is_end)
            result.push_back(Shape::vertex(v));
        }
      return result;
    }

    std::vector<double>
    product(const std::vector<double> &A,
            const std::vector<double> &B,
            const unsigned int         n)
    {
      std::vector<double> result(n * n, 0.);
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int k = 0; k < n; ++k)
          if (A[a * n + k] != 0.)
            for (unsigned int b = 0; b < n; ++b)
              result[a * n + b] += A[a * n + k] * B[k * n + b];
      return result;
    }
  } // namespace

  template <int dim>
  void
  LinearCells<dim>::reinit(const DoFHandler<dim>   &dof_handler,
                           const CellLocator<dim>  &locator,
                           const NodeMasters<dim>  &masters,
                           const HangingNodes<dim> &hanging_nodes)
  {
    constexpr unsigned int n = Basis<dim, 2>::n_nodes;
    hanging                  = &hanging_nodes;
    rules.clear();
    matrices.clear();
    known.clear();
    rule_of_cell.assign(locator.cells.size(), nullptr);
    std::vector<double> plain(n * n, 0.);
    for (unsigned int a = 0; a < n; ++a)
      {
        const std::vector<unsigned int> ends = ends_of<dim>(a);
        for (const unsigned int end : ends)
          plain[a * n + end] = 1. / ends.size();
      }
    plain_rule = rules.store(plain, n);
    for (unsigned int v = 0; v < Vertices::n; ++v)
      plain_vertices.places[v] = Basis<dim, 2>::vertex(v);
    plain_vertices.matrix = nullptr;

    // the masters of an own cell's hanging nodes lie on cells that touch it
    std::map<types::global_dof_index, Parents> parents;
    std::vector<types::global_dof_index>       dofs;
    if (masters.any_hanging())
      for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
        {
          get_nodes(dof_handler, locator, cell, dofs);
          for (unsigned int a = 0; a < n; ++a)
            {
              Parents &list = parents[masters.unknown(dofs[a])];
              if (!list.empty())
                continue;
              const std::vector<unsigned int> ends = ends_of<dim>(a);
              for (const unsigned int end : ends)
                {
                  const types::global_dof_index dof = dofs[end];
                  if (!masters.hangs(dof))
                    list.emplace_back(masters.unknown(dof), 1. / ends.size());
                  else
                    for (const auto &[master, weight] : masters.masters(dof))
                      list.emplace_back(master, weight / ends.size());
                }
            }
        }
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (hanging->matrix(cell) != nullptr)
        resolve(cell, parents);
    exchange(locator);
    other_vertices.clear();
    vertices_of_cell.assign(locator.cells.size(), -1);
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      if (hanging->matrix(cell) != nullptr)
        find_vertices(cell);
  }

  template <int dim>
  void
  LinearCells<dim>::find_vertices(const unsigned int cell)
  {
    constexpr unsigned int n         = Basis<dim, 2>::n_nodes;
    const auto             C         = matrix(cell, ~0u)->dense();
    const auto             vertex    = Basis<dim, 2>::vertex;
    const auto             is_needed = [&](const unsigned int place) {
      for (unsigned int v = 0; v < Vertices::n; ++v)
        if (C[vertex(v) * n + place] != 0.)
          return true;
      return false;
    };
    Vertices     result;
    unsigned int k = 0;
    for (unsigned int place = 0; place < n; ++place)
      if (is_needed(place))
        {
          AssertThrow(k < Vertices::n,
                      ExcMessage("More masters than vertices."));
          result.places[k++] = place;
        }
    // a cell may have fewer: any other, whose column is zero
    for (unsigned int place = 0; k < Vertices::n; ++place)
      if (!is_needed(place))
        result.places[k++] = place;
    std::vector<double> small(Vertices::n * Vertices::n);
    for (unsigned int v = 0; v < Vertices::n; ++v)
      for (unsigned int b = 0; b < Vertices::n; ++b)
        small[v * Vertices::n + b] = C[vertex(v) * n + result.places[b]];
    result.matrix          = matrices.store(small, Vertices::n);
    vertices_of_cell[cell] = other_vertices.size();
    other_vertices.push_back(result);
  }

  template <int dim>
  void
  LinearCells<dim>::resolve(
    const unsigned int                                cell,
    const std::map<types::global_dof_index, Parents> &parents)
  {
    constexpr unsigned int         n     = Basis<dim, 2>::n_nodes;
    const types::global_dof_index *nodes = hanging->nodes(cell);
    std::vector<double>            R(n * n, 0.);
    for (unsigned int a = 0; a < n; ++a)
      for (const auto &[parent, weight] : parents.at(nodes[a]))
        {
          const unsigned int place =
            std::find(nodes, nodes + n, parent) - nodes;
          AssertThrow(place < n,
                      ExcMessage("An edge of a cell with hanging nodes has an "
                                 "end outside of its list of nodes."));
          R[a * n + place] += weight;
        }
    rule_of_cell[cell] = rules.store(R, n);
  }

  template <int dim>
  void
  LinearCells<dim>::exchange(const CellLocator<dim> &locator)
  {
    const auto &triangulation = locator.grid.triangulation;
    if (Utilities::MPI::n_mpi_processes(triangulation.get_communicator()) == 1)
      return;
    using Iterator =
      typename parallel::distributed::Triangulation<dim>::active_cell_iterator;
    using Packet = std::vector<double>;
    GridTools::exchange_cell_data_to_ghosts<Packet>(
      triangulation,
      [&](const Iterator &iterator) -> std::optional<Packet> {
        const NodeMatrix *own = rule_of_cell[locator.cells.index(iterator)];
        return own != nullptr ? own->dense() : Packet();
      },
      [&](const Iterator &iterator, const Packet &packet) {
        if (!packet.empty())
          rule_of_cell[locator.cells.index(iterator)] =
            rules.store(packet, Basis<dim, 2>::n_nodes);
      });
  }

  template <int dim>
  const NodeMatrix *
  LinearCells<dim>::matrix(const unsigned int cell, const unsigned int means)
  {
    constexpr unsigned int n    = Basis<dim, 2>::n_nodes;
    const NodeMatrix      *mesh = hanging->matrix(cell);
    if (means == 0)
      return mesh;
    const auto [entry, is_new] =
      known.try_emplace({mesh, rule_of_cell[cell], means}, nullptr);
    if (is_new)
      {
        std::vector<double> R(n * n, 0.);
        const auto          full = rule(cell).dense();
        for (unsigned int a = 0; a < n; ++a)
          if ((means >> a) & 1u)
            std::copy_n(&full[a * n], n, &R[a * n]);
          else
            R[a * n + a] = 1.;
        // an end may hang in the middle of a coarser edge, itself such a mean
        std::vector<double> C = product(R, R, n);
        if (mesh != nullptr)
          C = product(mesh->dense(), C, n);
        entry->second = matrices.store(C, n);
      }
    return entry->second;
  }

  template class LinearCells<2>;
  template class LinearCells<3>;
} // namespace seiche
