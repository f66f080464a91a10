// SPDX-License-Identifier: LGPL-2.1-or-later
// BoomerAMG: what a cycle leaves of the error of a Laplacian, also where a rank
// has no rows, and for a second matrix of another size.
#include <seiche/solve/boomer_amg.h>

#include <deal.II/base/mpi.h>

#include <iostream>

namespace
{
  using seiche::BoomerAMG;
  using seiche::DistributedRows;
  using Vector = BoomerAMG::Vector;

  /// Own rows of the Laplacian of n^dim nodes, with the boundary left out.
  DistributedRows
  laplacian(const int n, const int dim, const dealii::IndexSet &own)
  {
    DistributedRows result;
    result.first = own.n_elements() > 0 ? own.nth_index_in_set(0) : 0;
    for (const auto row : own)
      {
        result.column.push_back(row);
        result.value.push_back(2. * dim);
        result.length.push_back(1);
        for (int d = 0, stride = 1; d < dim; ++d, stride *= n)
          for (const int side : {-1, 1})
            {
              const int place = (row / stride) % n + side;
              if (place < 0 || place >= n)
                continue;
              result.column.push_back(row + side * stride);
              result.value.push_back(-1.);
              ++result.length.back();
            }
      }
    return result;
  }

  /// y = A x, with x known to all ranks.
  void
  multiply(const DistributedRows &A, const std::vector<double> &x, Vector &y)
  {
    std::size_t k = 0;
    for (std::size_t row = 0; row < A.length.size(); ++row)
      {
        double sum = 0.;
        for (int i = 0; i < A.length[row]; ++i, ++k)
          sum += A.value[k] * x[A.column[k]];
        y.local_element(row) = sum;
      }
  }

  std::vector<double>
  gathered(const Vector &own, const unsigned int n)
  {
    std::vector<double> result(n, 0.);
    for (const auto i : own.locally_owned_elements())
      result[i] = own(i);
    dealii::Utilities::MPI::sum(result, MPI_COMM_WORLD, result);
    return result;
  }

  /// Iterations x += cycle(b - A x) until the residual has fallen by 1e6;
  /// @p empty: rank without rows.
  void
  test(BoomerAMG &amg, const int n, const int dim, const unsigned int empty)
  {
    const unsigned int n_rows = dim == 2 ? n * n : n * n * n;
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n_shares = empty < n_ranks ? n_ranks - 1 : n_ranks;
    // shares are counted without the empty rank
    const unsigned int before = rank > empty ? rank - 1 : rank;
    const unsigned int begin  = n_rows * before / n_shares,
                       end    = rank == empty ? begin :
                                                n_rows * (before + 1) / n_shares;
    dealii::IndexSet own(n_rows);
    own.add_range(begin, end);
    DistributedRows A = laplacian(n, dim, own);
    A.first           = begin;
    amg.initialize(A, MPI_COMM_WORLD);

    Vector b(own, MPI_COMM_WORLD), x(b), rest(b), update(b);
    for (const auto i : own)
      b(i) = 1. + i % 7;
    rest                    = b;
    unsigned int iterations = 0;
    for (; rest.l2_norm() > 1e-6 * b.l2_norm() && iterations < 100;
         ++iterations)
      {
        amg.vmult(update, rest);
        x += update;
        multiply(A, gathered(x, n_rows), rest);
        rest.sadd(-1., 1., b);
      }
    if (rank == 0)
      std::cout << dim << "D, " << n_rows << " rows"
                << (empty < n_ranks ?
                      ", rank " + std::to_string(empty) + " without any" :
                      "")
                << ": "
                << (iterations <= 25 ? "converges" : "DOES NOT CONVERGE")
                << '\n';
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  BoomerAMG                                amg;
  const unsigned int nobody = dealii::numbers::invalid_unsigned_int;
  test(amg, 40, 2, nobody);
  test(amg, 14, 3, nobody);
  test(amg, 1, 2, nobody);
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    for (const unsigned int empty : {0, 1, 2})
      test(amg, 20, 2, empty);
}
