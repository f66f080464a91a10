// SPDX-License-Identifier: LGPL-2.1-or-later
// Each multigrid of the table: what a cycle leaves of the residual of a
// Laplacian, symmetry and positivity; also where a rank has no rows.
#include <seiche/algebra/multigrid.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iostream>

namespace
{
  using seiche::DistributedRows;
  using Vector = seiche::Multigrid::Vector;

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

  /// Deterministic, rough numbers in [-1, 1].
  void
  fill(Vector &x, const unsigned int seed)
  {
    for (const auto i : x.locally_owned_elements())
      x(i) = std::sin(1e4 * seed + 1.7 * i * i);
  }

  /// Mean factor of the residual by iterations x += cycle(b - A x) until it has
  /// fallen by 1e6; @p empty: rank without rows.
  void
  test(const seiche::MultigridMethod &method,
       const int                      n,
       const int                      dim,
       const unsigned int             empty)
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
    DistributedRows A    = laplacian(n, dim, own);
    A.first              = begin;
    const auto multigrid = method.make(A, MPI_COMM_WORLD);

    Vector b(own, MPI_COMM_WORLD), x(b), rest(b), update(b);
    fill(b, 1);
    rest                    = b;
    unsigned int iterations = 0;
    for (; rest.l2_norm() > 1e-6 * b.l2_norm() && iterations < 100;
         ++iterations)
      {
        multigrid->vmult(update, rest);
        x += update;
        multiply(A, gathered(x, n_rows), rest);
        rest.sadd(-1., 1., b);
      }
    const double factor =
      std::pow(rest.l2_norm() / b.l2_norm(), 1. / iterations);

    double least = 1., asymmetry = 0.;
    Vector y(b), Bx(b), By(b);
    for (unsigned int seed = 1; seed < 6; ++seed)
      {
        fill(x, seed);
        fill(y, seed + 10);
        multigrid->vmult(Bx, x);
        multigrid->vmult(By, y);
        least = std::min(least, (x * Bx) / (x.l2_norm() * Bx.l2_norm()));
        asymmetry =
          std::max(asymmetry,
                   std::abs(x * By - y * Bx) / (x.l2_norm() * By.l2_norm()));
      }
    if (rank == 0)
      std::cout << method.name << ' ' << dim << "D, " << n_rows << " rows"
                << (empty < n_ranks ?
                      ", rank " + std::to_string(empty) + " without any" :
                      "")
                << ": a cycle leaves "
                << (factor < 0.5 ? "less than 0.5" : "TOO MUCH")
                << ", symmetric: " << (asymmetry < 1e-10 ? "yes" : "NO")
                << ", positive: " << (least > 0. ? "yes" : "NO") << '\n';
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int nobody = dealii::numbers::invalid_unsigned_int;
  for (const auto &method : seiche::multigrid_methods())
    {
      test(method, 40, 2, nobody);
      test(method, 14, 3, nobody);
      test(method, 1, 2, nobody);
      if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        for (const unsigned int empty : {0, 1, 2})
          test(method, 20, 2, empty);
    }
}
