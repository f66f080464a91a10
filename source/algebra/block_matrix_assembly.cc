// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/block_matrix.h>

// The part of BlockMatrix that adds the matrices of cells and pairs of nodes.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Ask for @p k numbers that will be changed.
    void
    fetch(const float *from, const unsigned int k)
    {
      constexpr std::size_t line  = 64; // bytes
      const char *const     begin = reinterpret_cast<const char *>(from);
      const std::size_t     bytes = k * sizeof(float);
      for (std::size_t i = 0; i < bytes; i += line)
        __builtin_prefetch(begin + i, /*to write=*/1);
      __builtin_prefetch(begin + bytes - 1, /*to write=*/1);
    }
  } // namespace

  /// Entries of a cell's pairs of unknowns.
  template <int dim>
  template <int degree>
  struct BlockMatrix<dim>::CellEntries
  {
    static constexpr unsigned int n = Basis<dim, degree>::n_nodes;

    std::size_t          row[n];
    const std::uint16_t *table[n]; ///< row of the cell's table
    unsigned int         place[n];

    CellEntries(const NodePattern<dim> &pattern, const unsigned int cell)
    {
      const auto nodes = pattern.occupancy.template unknowns<degree>(cell);
      const unsigned int n_list = pattern.occupancy.nodes_per_cell();
      for (unsigned int a = 0; a < n; ++a)
        {
          row[a]   = pattern.row_begin(nodes[a]);
          place[a] = nodes.place(a);
          table[a] = pattern.cell_entries(cell) + place[a] * n_list;
        }
    }

    std::size_t
    operator()(const unsigned int a, const unsigned int b) const
    {
      return row[a] + table[a][place[b]];
    }
  };

  template <int dim>
  void
  BlockMatrix<dim>::prefetch_cell(const unsigned int cell) const
  {
    const unsigned int n = n_fields();
    with_degree(occupancy.degree(cell), [&](const auto degree) {
      const CellEntries<degree> entries(pattern, cell);
      for (unsigned int a = 0; a < entries.n; ++a)
        for (unsigned int b = 0; b < entries.n; ++b)
          {
            const std::size_t entry = entries(a, b);
            fetch(&displacement_columns[entry * dim * n], dim * n);
            if (with_pressure)
              fetch(&pressure_column[entry * n], n);
          }
    });
  }

  template <int dim>
  template <int degree>
  void
  BlockMatrix<dim>::add_cell(const unsigned int             cell,
                             const CellMatrix<dim, degree> &data)
  {
    if (with_pressure)
      add_cell_fields<degree, dim + 1>(cell, data);
    else
      add_cell_fields<degree, dim>(cell, data);
  }

  template <int dim>
  template <int degree, unsigned int n>
  void
  BlockMatrix<dim>::add_cell_fields(const unsigned int             cell,
                                    const CellMatrix<dim, degree> &data)
  {
    constexpr unsigned int    n_nodes = CellMatrix<dim, degree>::n_nodes;
    const auto                nodes = occupancy.template unknowns<degree>(cell);
    const CellEntries<degree> entries(pattern, cell);
    double                    free[dim][n_nodes]; // 0 where a wall fixes
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        free[i][a] =
          occupancy.constraints.fixed_components(nodes[a]) & (1u << i) ? 0. :
                                                                         1.;

    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int b = 0; b < n_nodes; ++b)
        {
          const std::size_t entry = entries(a, b);
          float            *to    = &displacement_columns[entry * dim * n];
          for (unsigned int j = 0; j < dim; ++j, to += n)
            {
              for (unsigned int i = 0; i < dim; ++i)
                to[i] += free[i][a] * free[j][b] * data.uu[i][j][a][b];
              if constexpr (n > dim)
                to[dim] += free[j][b] * data.pu[j][a][b];
            }
          if constexpr (n > dim)
            {
              to = &pressure_column[entry * n];
              for (unsigned int i = 0; i < dim; ++i)
                to[i] += free[i][a] * data.up[i][a][b];
              to[dim] += data.pp[a][b];
            }
        }
  }

  template <int dim>
  void
  BlockMatrix<dim>::add_pair(const unsigned int entry,
                             const unsigned int row,
                             const unsigned int column,
                             const double       displacement,
                             const double       pressure)
  {
    const std::size_t  n = n_fields(), e = entry;
    const unsigned int fixed = occupancy.constraints.fixed_components(row) |
                               occupancy.constraints.fixed_components(column);
    float *to = &displacement_columns[e * dim * n];
    if (fixed & (1u << dim))
      add_projected(row, column, displacement, to);
    else
      for (unsigned int i = 0; i < dim; ++i)
        if (!(fixed & (1u << i)))
          to[i * n + i] += displacement;
    if (with_pressure)
      pressure_column[e * n + dim] += pressure;
  }

  template <int dim>
  void
  BlockMatrix<dim>::add_projected(const unsigned int row,
                                  const unsigned int column,
                                  const double       value,
                                  float             *block) const
  {
    const Tensor<2, dim> product = occupancy.constraints.projector(row) *
                                   occupancy.constraints.projector(column);
    for (unsigned int j = 0; j < dim; ++j, block += n_fields())
      for (unsigned int i = 0; i < dim; ++i)
        block[i] += value * product[i][j];
  }

  template void
  BlockMatrix<2>::prefetch_cell(const unsigned int) const;
  template void
  BlockMatrix<3>::prefetch_cell(const unsigned int) const;
  template void
  BlockMatrix<2>::add_pair(const unsigned int,
                           const unsigned int,
                           const unsigned int,
                           const double,
                           const double);
  template void
  BlockMatrix<3>::add_pair(const unsigned int,
                           const unsigned int,
                           const unsigned int,
                           const double,
                           const double);

#define INSTANTIATE(dim, degree)                               \
  template void BlockMatrix<dim>::add_cell(const unsigned int, \
                                           const CellMatrix<dim, degree> &);
  INSTANTIATE(2, 1)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 1)
  INSTANTIATE(3, 2)
#undef INSTANTIATE
} // namespace seiche
