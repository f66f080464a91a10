// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/block_matrix.h>

#include <Epetra_CrsGraph.h>
#include <Epetra_Vector.h>

#include <numeric>

namespace seiche
{
  using namespace dealii;

  double &
  diagonal_entry(const Epetra_CrsMatrix &matrix, const int row)
  {
    int     n;
    double *values;
    int    *columns;
    matrix.ExtractMyRowView(row, n, values, columns);
    const int *found = std::lower_bound(columns, columns + n, row);
    Assert(found != columns + n && *found == row, ExcInternalError());
    return values[found - columns];
  }

  namespace
  {
    bool
    row_is_zero(const Epetra_CrsMatrix &matrix, const int row)
    {
      int     n;
      double *values;
      matrix.ExtractMyRowView(row, n, values);
      return std::all_of(values, values + n, [](const double value) {
        return value == 0.;
      });
    }
  } // namespace

  template <int dim>
  BlockMatrix<dim>::BlockMatrix(const Occupancy<dim> &grid_occupancy,
                                const bool            pressure)
    : occupancy(grid_occupancy)
    , with_pressure(pressure)
  {}

  template <int dim>
  void
  BlockMatrix<dim>::reinit(const Fill<dim> &fill)
  {
    const bool keep = numbering_generation == occupancy.generation() &&
                      pattern_covers(fill.ghost_faces());
    const MPI_Comm communicator =
      occupancy.locator.grid.triangulation.get_communicator();
    if (Utilities::MPI::min(keep ? 1 : 0, communicator) == 1)
      return;
    numbering_generation = occupancy.generation();
    ++pattern_generation;
    build_pattern(fill);
    build_scatter();
    build_matrices();
  }

  template <int dim>
  bool
  BlockMatrix<dim>::pattern_covers(const std::vector<GhostFace> &faces) const
  {
    return std::all_of(faces.begin(), faces.end(), [&](const GhostFace &face) {
      return covered_faces[face_index(face.lower, face.upper, face.direction)];
    });
  }

  template <int dim>
  std::size_t
  BlockMatrix<dim>::face_index(const unsigned int lower,
                               const unsigned int upper,
                               const unsigned int direction) const
  {
    const auto &locator = occupancy.locator;
    return locator.level(lower) >= locator.level(upper) ?
             lower * 2 * dim + 2 * direction + 1 :
             upper * 2 * dim + 2 * direction;
  }

  template <int dim>
  void
  BlockMatrix<dim>::build_pattern(const Fill<dim> &fill)
  {
    // Groups of mutually coupled nodes: cells, and pairs of cells across the
    // faces that may become ghost faces before the next numbering.
    std::vector<unsigned int> group_begin = {0}, group_nodes;
    const auto                close_group = [&]() {
      group_begin.push_back(group_nodes.size());
    };
    for (const unsigned int cell : occupancy.active_cells())
      {
        const unsigned int *nodes = occupancy.cell_nodes(cell);
        group_nodes.insert(group_nodes.end(), nodes, nodes + n_nodes);
        close_group();
      }
    covered_faces.assign(occupancy.locator.n_cells() * 2 * dim, 0);
    const auto near_surface = [&](const unsigned int cell) {
      return !occupancy.is_occupied(cell) || fill.is_cut(cell);
    };
    const auto add_face_group = [&](const unsigned int lower,
                                    const unsigned int upper,
                                    const unsigned int direction) {
      if (!near_surface(lower) && !near_surface(upper))
        return;
      covered_faces[face_index(lower, upper, direction)] = 1;
      for (const unsigned int cell : {lower, upper})
        {
          const unsigned int *nodes = occupancy.cell_nodes(cell);
          group_nodes.insert(group_nodes.end(), nodes, nodes + n_nodes);
        }
      close_group();
    };
    occupancy.for_each_assembled_face(
      occupancy.active_cells(),
      [&](const unsigned int cell) { return occupancy.is_active(cell); },
      add_face_group);

    // groups at each node, then the union of their nodes
    const unsigned int        n_rows = occupancy.n_local_nodes();
    std::vector<unsigned int> at_begin(n_rows + 1, 0), at;
    for (const unsigned int node : group_nodes)
      ++at_begin[node + 1];
    std::partial_sum(at_begin.begin(), at_begin.end(), at_begin.begin());
    at.resize(group_nodes.size());
    std::vector<unsigned int> next(at_begin.begin(), at_begin.end() - 1);
    for (unsigned int g = 0; g + 1 < group_begin.size(); ++g)
      for (unsigned int i = group_begin[g]; i < group_begin[g + 1]; ++i)
        at[next[group_nodes[i]]++] = g;

    row_begin.assign(1, 0);
    columns.clear();
    std::vector<unsigned int> last_seen(n_rows, Occupancy<dim>::invalid);
    for (unsigned int row = 0; row < n_rows; ++row)
      {
        for (unsigned int i = at_begin[row]; i < at_begin[row + 1]; ++i)
          for (unsigned int j = group_begin[at[i]]; j < group_begin[at[i] + 1];
               ++j)
            if (last_seen[group_nodes[j]] != row)
              {
                last_seen[group_nodes[j]] = row;
                columns.push_back(group_nodes[j]);
              }
        std::sort(columns.begin() + row_begin.back(), columns.end());
        row_begin.push_back(columns.size());
      }
  }

  template <int dim>
  unsigned int
  BlockMatrix<dim>::position(const unsigned int row,
                             const unsigned int column) const
  {
    const auto begin = columns.begin() + row_begin[row];
    const auto end   = columns.begin() + row_begin[row + 1];
    const auto found = std::lower_bound(begin, end, column);
    Assert(found != end && *found == column, ExcInternalError());
    return found - begin;
  }

  template <int dim>
  void
  BlockMatrix<dim>::build_scatter()
  {
    scatter.resize(occupancy.locator.n_owned() * n_nodes * n_nodes);
    for (const unsigned int cell : occupancy.active_cells())
      {
        const unsigned int *nodes = occupancy.cell_nodes(cell);
        std::uint16_t      *table = &scatter[cell * n_nodes * n_nodes];
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < n_nodes; ++b)
            *table++ = position(nodes[a], nodes[b]);
      }
  }

  template <int dim>
  void
  BlockMatrix<dim>::build_matrices()
  {
    const auto          &partitioner = *occupancy.scalar_partitioner();
    const Epetra_MpiComm communicator(partitioner.get_mpi_communicator());
    const unsigned int   n_own  = occupancy.n_own_nodes();
    const unsigned int   n_all  = occupancy.n_local_nodes();
    const bool           serial = communicator.NumProc() == 1;

    const auto make_map = [&](const unsigned int n, const unsigned int c) {
      std::vector<int> indices;
      indices.reserve(n * c);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int d = 0; d < c; ++d)
          indices.push_back(partitioner.local_to_global(i) * c + d);
      return Epetra_Map(-1, indices.size(), indices.data(), 0, communicator);
    };
    const Epetra_Map node_all      = make_map(n_all, 1),
                     node_own      = make_map(n_own, 1);
    const Epetra_Map component_all = make_map(n_all, dim),
                     component_own = make_map(n_own, dim);
    node_export = std::make_unique<Epetra_Export>(node_all, node_own);
    component_export =
      std::make_unique<Epetra_Export>(component_all, component_own);

    std::vector<int> row;
    for (unsigned int b = 0; b < (with_pressure ? 4 : 1); ++b)
      {
        const unsigned int n_r = b < 2 ? dim : 1, n_c = b % 2 == 0 ? dim : 1;
        const Epetra_Map  &rows   = n_r == 1 ? node_all : component_all;
        const Epetra_Map  &cols   = n_c == 1 ? node_all : component_all;
        const Epetra_Map  &range  = n_r == 1 ? node_own : component_own;
        const Epetra_Map  &domain = n_c == 1 ? node_own : component_own;
        std::vector<int>   lengths;
        for (unsigned int i = 0; i < n_all; ++i)
          lengths.insert(lengths.end(),
                         n_r,
                         n_c * (row_begin[i + 1] - row_begin[i]));
        Epetra_CrsGraph graph(Copy, rows, cols, lengths.data(), true);
        for (unsigned int i = 0; i < n_all; ++i)
          {
            row.clear();
            for (unsigned int k = row_begin[i]; k < row_begin[i + 1]; ++k)
              for (unsigned int c = 0; c < n_c; ++c)
                row.push_back(columns[k] * n_c + c);
            for (unsigned int r = 0; r < n_r; ++r)
              graph.InsertMyIndices(i * n_r + r, row.size(), row.data());
          }
        graph.FillComplete(domain, range);
        graph.OptimizeStorage();
        Matrices &matrices = blocks[b];
        matrices.assembled = std::make_unique<Epetra_CrsMatrix>(Copy, graph);
        matrices.assembled->FillComplete(domain, range);
        int      *offsets, *indices;
        const int error =
          matrices.assembled->ExtractCrsDataPointers(offsets,
                                                     indices,
                                                     matrices.values);
        AssertThrow(error == 0, ExcMessage("Trilinos storage is not packed"));
        matrices.owned.reset();
        if (!serial)
          {
            Epetra_CrsGraph own_graph(Copy, range, 0);
            own_graph.Export(graph,
                             n_r == 1 ? *node_export : *component_export,
                             Insert);
            own_graph.FillComplete(domain, range);
            own_graph.OptimizeStorage();
            matrices.owned =
              std::make_unique<Epetra_CrsMatrix>(Copy, own_graph);
            matrices.owned->FillComplete(domain, range);
          }
        matrices.system =
          serial ? matrices.assembled.get() : matrices.owned.get();
      }
  }

  template <int dim>
  void
  BlockMatrix<dim>::set_zero()
  {
    for (unsigned int b = 0; b < (with_pressure ? 4 : 1); ++b)
      blocks[b].assembled->PutScalar(0.);
  }

  template <int dim>
  void
  BlockMatrix<dim>::add_cell(const unsigned int cell, const CellData<dim> &data)
  {
    const unsigned int  *nodes = occupancy.cell_nodes(cell);
    const std::uint16_t *table = &scatter[cell * n_nodes * n_nodes];
    unsigned int         fixed[n_nodes];
    for (unsigned int a = 0; a < n_nodes; ++a)
      fixed[a] = occupancy.fixed_components(nodes[a]);

    for (unsigned int a = 0; a < n_nodes; ++a)
      {
        const unsigned int   begin  = row_begin[nodes[a]];
        const unsigned int   length = row_begin[nodes[a] + 1] - begin;
        const std::uint16_t *k      = table + a * n_nodes;
        for (unsigned int i = 0; i < dim; ++i)
          if (!(fixed[a] & (1u << i)))
            {
              double *row =
                blocks[uu].values + dim * (dim * begin + i * length);
              for (unsigned int b = 0; b < n_nodes; ++b)
                for (unsigned int j = 0; j < dim; ++j)
                  if (!(fixed[b] & (1u << j)))
                    row[dim * k[b] + j] += data.uu[i][j][a][b];
            }
        if (!with_pressure)
          continue;
        for (unsigned int i = 0; i < dim; ++i)
          if (!(fixed[a] & (1u << i)))
            {
              double *row = blocks[up].values + dim * begin + i * length;
              for (unsigned int b = 0; b < n_nodes; ++b)
                row[k[b]] += data.up[i][a][b];
            }
        double *pu_row = blocks[pu].values + dim * begin;
        double *pp_row = blocks[pp].values + begin;
        for (unsigned int b = 0; b < n_nodes; ++b)
          {
            for (unsigned int j = 0; j < dim; ++j)
              if (!(fixed[b] & (1u << j)))
                pu_row[dim * k[b] + j] += data.pu[j][a][b];
            pp_row[k[b]] += data.pp[a][b];
          }
      }
  }

  template <int dim>
  void
  BlockMatrix<dim>::add_face(const GhostFaceMatrix<dim> &face,
                             const double                velocity_coefficient,
                             const double                pressure_coefficient)
  {
    const unsigned int n = face.n_nodes;
    for (unsigned int a = 0; a < n; ++a)
      {
        const unsigned int row    = face.nodes[a];
        const unsigned int begin  = row_begin[row];
        const unsigned int length = row_begin[row + 1] - begin;
        const unsigned int fixed  = occupancy.fixed_components(row);
        for (unsigned int b = 0; b < n; ++b)
          {
            const unsigned int k = position(row, face.nodes[b]);
            const unsigned int other =
              occupancy.fixed_components(face.nodes[b]);
            for (unsigned int i = 0; i < dim; ++i)
              if (!((fixed | other) & (1u << i)))
                blocks[uu]
                  .values[dim * (dim * begin + i * length) + dim * k + i] +=
                  velocity_coefficient * face.B[a][b];
            if (with_pressure)
              blocks[pp].values[begin + k] +=
                pressure_coefficient * face.B[a][b];
          }
      }
  }

  template <int dim>
  void
  BlockMatrix<dim>::compress()
  {
    for (unsigned int b = 0; b < (with_pressure ? 4 : 1); ++b)
      {
        Matrices &matrices = blocks[b];
        if (matrices.owned)
          {
            matrices.owned->PutScalar(0.);
            matrices.owned->Export(*matrices.assembled,
                                   b < 2 ? *component_export : *node_export,
                                   Add);
          }
        if (b == up || b == pu)
          continue;
        const int n_rows  = matrices.system->NumMyRows();
        double    largest = 0., own_largest = 0.;
        for (int i = 0; i < n_rows; ++i)
          own_largest =
            std::max(own_largest, diagonal_entry(*matrices.system, i));
        matrices.system->Comm().MaxAll(&own_largest, &largest, 1);
        // an occupied node may have a zero diagonal in D (no subscales), a
        // node of the halo has nothing at all
        for (int i = 0; i < n_rows; ++i)
          if (double &entry = diagonal_entry(*matrices.system, i);
              entry == 0. && (b == uu || row_is_zero(*blocks[pu].system, i)))
            entry = largest > 0. ? largest : 1.;
      }
  }

  template <int dim>
  void
  BlockMatrix<dim>::vmult(BlockVector &dst, const BlockVector &src) const
  {
    const auto multiply =
      [&](const Block                                       b,
          LinearAlgebra::distributed::Vector<double>       &y,
          const LinearAlgebra::distributed::Vector<double> &x) {
        const Epetra_CrsMatrix &matrix = *blocks[b].system;
        const Epetra_Vector     source(View,
                                   matrix.DomainMap(),
                                   const_cast<double *>(x.begin()));
        Epetra_Vector           target(View, matrix.RangeMap(), y.begin());
        matrix.Multiply(false, source, target);
      };
    multiply(uu, dst.block(0), src.block(0));
    if (with_pressure)
      {
        scratch.reinit(dst, /*omit_zeroing=*/true);
        multiply(up, scratch.block(0), src.block(1));
        dst.block(0) += scratch.block(0);
        multiply(pu, dst.block(1), src.block(0));
        multiply(pp, scratch.block(1), src.block(1));
        dst.block(1) += scratch.block(1);
      }
  }

  template class BlockMatrix<2>;
  template class BlockMatrix<3>;
} // namespace seiche
