// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/block_matrix.h>
#include <seiche/utilities/register.h>
#include <seiche/utilities/storage.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  BlockMatrix<dim>::BlockMatrix(const Fill<dim> &fill, const bool pressure)
    : occupancy(fill.occupancy)
    , pattern(fill)
    , with_pressure(pressure)
  {}

  template <int dim>
  void
  BlockMatrix<dim>::reinit()
  {
    if (!pattern.reinit())
      return;
    ++pattern_generation;
    const std::size_t n = pattern.n_entries();
    // and one number more, see Register
    const auto start = [](std::vector<float> &values, const std::size_t size) {
      make_room(values, size);
      values.resize(size);
    };
    start(displacement_columns, n * dim * n_fields() + 1);
    start(pressure_column, with_pressure ? n * n_fields() + 1 : 0);
    empty.assign(occupancy.nodes.n_own(), 0);
    source.reinit(pattern.make_partitioner(n_fields()));
    if (with_pressure)
      pressure_source.reinit(pattern.make_partitioner(1));
  }

  template <int dim>
  void
  BlockMatrix<dim>::set_zero()
  {
    std::fill(displacement_columns.begin(), displacement_columns.end(), 0.f);
    std::fill(pressure_column.begin(), pressure_column.end(), 0.f);
  }

  template <int dim>
  void
  BlockMatrix<dim>::add_oblique_directions()
  {
    const unsigned int n = n_fields();
    occupancy.constraints.for_each_fixed([&](const auto &direction) {
      if (direction.component < dim)
        return; // its row is empty, complete_diagonal() will see
      double mean = 0.;
      for (unsigned int i = 0; i < dim; ++i)
        mean += diagonal(direction.node, i) / dim;
      const Tensor<1, dim> normal = direction.unit_vector();
      float               *block =
        &displacement_columns[pattern.diagonal_of(direction.node) * dim * n];
      for (unsigned int j = 0; j < dim; ++j, block += n)
        for (unsigned int i = 0; i < dim; ++i)
          block[i] += mean * normal[i] * normal[j];
    });
  }

  template <int dim>
  void
  BlockMatrix<dim>::compress()
  {
    pattern.add_to_owners(displacement_columns, dim * n_fields());
    if (with_pressure)
      pattern.add_to_owners(pressure_column, n_fields());
    add_oblique_directions();
    complete_diagonal();
  }

  template <int dim>
  void
  BlockMatrix<dim>::complete_diagonal()
  {
    const unsigned int        n = n_fields(), n_own = occupancy.nodes.n_own();
    std::vector<double>       largest(2, 0.); // displacement, pressure
    std::vector<unsigned int> incomplete;
    for (unsigned int node = 0; node < n_own; ++node)
      {
        bool complete = true;
        for (unsigned int i = 0; i < n; ++i)
          {
            const double d   = diagonal(node, i);
            largest[i / dim] = std::max(largest[i / dim], d);
            complete &= d != 0.;
          }
        empty[node] = 0;
        if (!complete)
          incomplete.push_back(node);
      }
    const MPI_Comm communicator =
      occupancy.nodes.partitioner()->get_mpi_communicator();
    Utilities::MPI::max(largest, communicator, largest);
    for (double &value : largest)
      if (value == 0.)
        value = 1.;

    for (const unsigned int node : incomplete)
      {
        const std::size_t entry    = pattern.diagonal_of(node);
        unsigned int      replaced = 0;
        for (unsigned int i = 0; i < dim; ++i)
          if (float &d = displacement_columns[(entry * dim + i) * n + i];
              d == 0.)
            {
              d = largest[0];
              ++replaced;
            }
        // an occupied node may have a zero diagonal in D (no subscales), a
        // node away from the fluid has nothing at all
        const auto volume_row_is_zero = [&]() {
          for (unsigned int k = pattern.row_begin(node);
               k < pattern.row_begin(node + 1);
               ++k)
            for (unsigned int j = 0; j < dim; ++j)
              if (value(k, dim, j) != 0.)
                return false;
          return true;
        };
        if (with_pressure)
          if (float &d = pressure_column[entry * n + dim];
              d == 0. && volume_row_is_zero())
            {
              d = largest[1];
              ++replaced;
            }
        empty[node] = replaced == n;
      }
  }

  template <int dim>
  void
  BlockMatrix<dim>::vmult(BlockVector &dst, const BlockVector &src) const
  {
    const unsigned int n = n_fields(), n_own = occupancy.nodes.n_own();
    double            *to = source.begin();
    const double      *u  = src.block(0).begin();
    if (with_pressure)
      {
        const double *p = src.block(1).begin();
        for (unsigned int node = 0; node < n_own; ++node)
          {
            for (unsigned int i = 0; i < dim; ++i)
              *to++ = *u++;
            *to++ = *p++;
          }
      }
    else
      std::copy(u, u + n_own * n, to);
    source.update_ghost_values();
    if (with_pressure)
      multiply<dim + 1>(dst);
    else
      multiply<dim>(dst);
    source.zero_out_ghost_values();
  }

  template <int dim>
  template <unsigned int n_rows>
  void
  BlockMatrix<dim>::multiply(BlockVector &dst) const
  {
    using Lanes              = Register<n_rows>;
    using Rows               = typename Lanes::Doubles;
    const double      *x     = source.begin();
    double            *u     = dst.block(0).begin();
    double            *p     = n_rows > dim ? dst.block(1).begin() : nullptr;
    const unsigned int n_own = occupancy.nodes.n_own();
    for (unsigned int node = 0; node < n_own; ++node)
      {
        double sum[n_rows] = {};
        if (empty[node])
          for (unsigned int r = 0; r < n_rows; ++r)
            sum[r] = diagonal(node, r) * x[node * n_rows + r];
        else
          {
            // one sum for each column: additions need not wait for each other
            Rows parts[n_rows] = {};
            for (std::size_t k = pattern.row_begin(node);
                 k < pattern.row_begin(node + 1);
                 ++k)
              {
                const double *source_node = x + pattern.column_of(k) * n_rows;
                const float  *A = &displacement_columns[k * dim * n_rows];
                for (unsigned int j = 0; j < dim; ++j)
                  parts[j] += Lanes::load(A + j * n_rows) * source_node[j];
                if constexpr (n_rows > dim)
                  parts[dim] += Lanes::load(&pressure_column[k * n_rows]) *
                                source_node[dim];
              }
            for (unsigned int j = 1; j < n_rows; ++j)
              parts[0] += parts[j];
            for (unsigned int r = 0; r < n_rows; ++r)
              sum[r] = parts[0][r];
          }
        for (unsigned int i = 0; i < dim; ++i)
          *u++ = sum[i];
        if constexpr (n_rows > dim)
          *p++ = sum[dim];
      }
  }

  template <int dim>
  void
  BlockMatrix<dim>::gradient(Vector &force, const Vector &pressure) const
  {
    constexpr unsigned int n     = dim + 1;
    const unsigned int     n_own = occupancy.nodes.n_own();
    std::copy(pressure.begin(),
              pressure.begin() + n_own,
              pressure_source.begin());
    pressure_source.update_ghost_values();
    const double *x = pressure_source.begin();
    double       *u = force.begin();
    for (unsigned int node = 0; node < n_own; ++node)
      {
        double sum[n] = {};
        if (!empty[node])
          for (std::size_t k = pattern.row_begin(node);
               k < pattern.row_begin(node + 1);
               ++k)
            for (unsigned int r = 0; r < n; ++r)
              sum[r] += pressure_column[k * n + r] * x[pattern.column_of(k)];
        for (unsigned int i = 0; i < dim; ++i)
          *u++ = sum[i];
      }
    pressure_source.zero_out_ghost_values();
  }

  template class BlockMatrix<2>;
  template class BlockMatrix<3>;
} // namespace seiche
