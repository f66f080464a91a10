// SPDX-License-Identifier: LGPL-2.1-or-later
// FlexibleGMRES: solutions, iterations with their products, restarts, and what
// cannot be solved.
#include <seiche/algebra/flexible_gmres.h>

#include <deal.II/base/mpi.h>

#include <deal.II/lac/full_matrix.h>

#include <iostream>
#include <string>

namespace
{
  using dealii::FullMatrix;
  using Vector = seiche::FlexibleGMRES::Vector;

  void
  multiply(Vector &y, const FullMatrix<double> &A, const Vector &x)
  {
    for (unsigned int i = 0; i < A.m(); ++i)
      {
        y.block(0)[i] = 0.;
        for (unsigned int j = 0; j < A.n(); ++j)
          y.block(0)[i] += A(i, j) * x.block(0)[j];
      }
  }

  /// A matrix that counts its products.
  struct Counted
  {
    const FullMatrix<double> &matrix;
    mutable unsigned int      products = 0;

    void
    vmult(Vector &y, const Vector &x) const
    {
      ++products;
      multiply(y, matrix, x);
    }
  };

  /// Another one each time: only a flexible method may have it.
  struct Changing
  {
    mutable unsigned int calls = 0;

    void
    vmult(Vector &y, const Vector &x) const
    {
      y = x;
      for (unsigned int i = 0; i < y.size(); ++i)
        y.block(0)[i] /= 1. + 0.1 * ((i + calls) % 3);
      ++calls;
    }
  };

  /// Convection and diffusion, not symmetric.
  FullMatrix<double>
  make_matrix(const unsigned int n)
  {
    FullMatrix<double> A(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        A(i, i) = 2.1;
        if (i > 0)
          A(i, i - 1) = -1.5;
        if (i + 1 < n)
          A(i, i + 1) = -0.5;
      }
    return A;
  }

  /// Nearly dependent columns: directions that are made orthogonal once are
  /// not orthogonal.
  FullMatrix<double>
  hilbert_matrix(const unsigned int n)
  {
    FullMatrix<double> A(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        A(i, j) = 1. / (1. + i + j);
    return A;
  }

  Vector
  ones(const unsigned int n)
  {
    Vector b(1, n);
    b = 1.;
    return b;
  }

  void
  test(const std::string        &name,
       const FullMatrix<double> &A,
       const Vector             &b,
       const double              tolerance,
       const unsigned int        maximum)
  {
    seiche::FlexibleGMRES gmres;
    const Counted         matrix{A};
    const Changing        preconditioner;
    Vector                x(1, b.size()), rest(1, b.size());
    const double          target = tolerance * b.l2_norm();
    const bool            solved =
      gmres.solve(matrix, x, b, preconditioner, target, maximum);
    const unsigned int products = matrix.products;
    multiply(rest, A, x);
    rest.sadd(-1., 1., b);
    std::cout << name << ": " << (solved ? "solved" : "not solved")
              << ", iterations " << gmres.iterations << ", products "
              << products << ", preconditioners " << preconditioner.calls
              << ", residual "
              << (rest.l2_norm() <= 1.0001 * target ? "small" : "large")
              << ", as estimated: "
              << (std::abs(rest.l2_norm() - gmres.residual) <=
                      1e-6 * b.l2_norm() ?
                    "yes" :
                    "no")
              << '\n';
  }
} // namespace

int
main()
{
  for (const unsigned int n : {1, 20, 200})
    {
      Vector b(1, n);
      for (unsigned int i = 0; i < n; ++i)
        b.block(0)[i] = 1. + i % 4;
      const std::string size = std::to_string(n) + " rows, ";
      test(size + "1e-2", make_matrix(n), b, 1e-2, 1000);
      test(size + "1e-8", make_matrix(n), b, 1e-8, 1000);
      test(size + "two iterations", make_matrix(n), b, 1e-12, 2);
    }
  test("Hilbert matrix", hilbert_matrix(12), ones(12), 1e-8, 100);
  const Vector zero(1, 5);
  test("zero", make_matrix(5), zero, 1e-8, 10);
  const Vector       b = ones(5);
  FullMatrix<double> singular(5);
  test("zero matrix", singular, b, 1e-8, 10);
  singular(0, 0) = 1.;
  test("singular", singular, b, 1e-8, 10);
}
