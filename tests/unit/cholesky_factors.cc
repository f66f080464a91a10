// SPDX-License-Identifier: LGPL-2.1-or-later
// Cholesky factors of a Laplacian on a row of nodes: the solution, also where
// the order of elimination of an earlier matrix serves; an indefinite matrix is
// refused and harms nothing.
#include <seiche/algebra/cholesky_factors.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
  using seiche::CholeskyFactors;
  using seiche::LowerTriangle;

  /// Diagonal, and -1 below it.
  LowerTriangle
  matrix(const std::vector<double> &diagonal)
  {
    LowerTriangle result;
    const int     n = diagonal.size();
    for (int i = 0; i < n; ++i)
      {
        result.row.push_back(i);
        result.value.push_back(diagonal[i]);
        if (i + 1 < n)
          {
            result.row.push_back(i + 1);
            result.value.push_back(-1.);
          }
        result.begin.push_back(result.row.size());
      }
    return result;
  }

  /// Factorise, and solve for 1, 2, 3, ...
  void
  check(CholeskyFactors           &factors,
        const std::vector<double> &diagonal,
        const unsigned int         numbering)
  {
    LowerTriangle A = matrix(diagonal);
    if (!factors.initialize(A, numbering))
      {
        std::cout << "refused, empty: " << factors.is_empty() << std::endl;
        return;
      }
    const int           n = diagonal.size();
    std::vector<double> right(n), x(n);
    for (int i = 0; i < n; ++i)
      right[i] =
        diagonal[i] * (i + 1) - (i > 0 ? i : 0) - (i + 1 < n ? i + 2 : 0);
    factors.solve(x.data(), right.data());
    double error = 0.;
    for (int i = 0; i < n; ++i)
      error = std::max(error, std::abs(x[i] - (i + 1)));
    std::cout << n << " rows, error below 1e-12: " << (error < 1e-12)
              << std::endl;
  }
} // namespace

int
main()
{
  CholeskyFactors factors;
  check(factors, {2., 2., 2., 2., 2.}, 1);
  check(factors, {3., 4., 5., 4., 3.}, 1); // in the order of the first
  check(factors, {3., -4., 5., 4., 3.}, 1);
  check(factors, {3., 4., 5., 4., 3.}, 1);
  check(factors, {2., 2., 2.}, 2);
}
