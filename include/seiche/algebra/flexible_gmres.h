// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_flexible_gmres_h
#define seiche_algebra_flexible_gmres_h

#include <deal.II/base/mpi.h>

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/vector_memory.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace seiche
{
  /**
   * @brief Restarted flexible GMRES from zero (Saad 1993) with classical
   * Gram-Schmidt, repeated where it has to be (Daniel, Gragg, Kaufman, Stewart
   * 1976), and Givens rotations.
   *
   * One product, one application of the preconditioner and one sum over the
   * ranks, or two, an iteration, and a norm at the start: dealii::SolverFGMRES
   * (9.4) makes two products and one application more in each solve, and solves
   * of a few iterations are the rule here.
   */
  class FlexibleGMRES
  {
  public:
    using Vector = dealii::LinearAlgebra::distributed::BlockVector<double>;

    /// Vectors of the basis before a restart.
    static constexpr unsigned int basis_size = 60;

    unsigned int iterations = 0;
    double       residual   = 0.; ///< norm, as the rotations give it

    /// Solve A x = b up to a residual of @p target; false if that takes more
    /// than @p maximum iterations or anything is not finite. A and M have
    /// vmult(). Collective.
    template <typename Matrix, typename Preconditioner>
    bool
    solve(const Matrix         &A,
          Vector               &x,
          const Vector         &b,
          const Preconditioner &M,
          const double          target,
          const unsigned int    maximum)
    {
      iterations = 0;
      v.clear(); // left there by an exception
      z.clear();
      x = 0.;
      w = Pointer(memory);
      w->reinit(b, /*omit_zeroing=*/true);
      *w = b;
      while (true)
        {
          residual = w->l2_norm();
          if (!(residual > target) || iterations >= maximum)
            break;
          expand(A, M, target, maximum);
          update(x);
          if (!(residual > target) || iterations >= maximum)
            break;
          A.vmult(*w, x);
          w->sadd(-1., 1., b);
        }
      const bool converged = residual <= target;
      v.clear();
      z.clear();
      w = Pointer();
      return converged;
    }

  private:
    using Memory  = dealii::GrowingVectorMemory<Vector>;
    using Pointer = typename dealii::VectorMemory<Vector>::Pointer;

    static constexpr double round_off = 1e-14;

    /// What is left of a vector, over its length: below, rounding spoils it
    /// (with 0.1 hard solves take 3 % more iterations).
    static constexpr double repeat_below = 0.3;

    /// Build the basis from the residual in w until it suffices.
    template <typename Matrix, typename Preconditioner>
    void
    expand(const Matrix         &A,
           const Preconditioner &M,
           const double          target,
           const unsigned int    maximum)
    {
      n = 0;
      g.assign(1, residual);
      double norm = residual;
      while (n < basis_size && iterations < maximum && residual > target &&
             norm > 0.)
        {
          const unsigned int j = n++;
          vector(v, j).equ(1. / norm, *w);
          M.vmult(vector(z, j), *v[j]);
          A.vmult(*w, *z[j]);

          std::vector<double> &h = column(j);
          std::fill_n(h.begin(), n, 0.);
          const double size = orthogonalize(h, norm); // of A z, squared
          if (norm < repeat_below * std::sqrt(size))
            orthogonalize(h, norm);
          for (unsigned int i = 0; i < j; ++i)
            rotate(i, h[i], h[i + 1]);
          double length = std::hypot(h[j], norm);
          if (length <= round_off * std::sqrt(size))
            norm = length = 0.; // A z is in the span of those before: no gain
          cosine[j] = length > 0. ? h[j] / length : 0.;
          sine[j]   = length > 0. ? norm / length : 1.;
          h[j]      = length;
          g.push_back(0.);
          rotate(j, g[j], g[j + 1]);
          residual = std::abs(g[j + 1]);
          ++iterations;
        }
    }

    /// Take from w its parts along the basis, add them to @p h. The square of
    /// its length before; @p norm is what is left of it.
    double
    orthogonalize(std::vector<double> &h, double &norm)
    {
      // n parts and the square, of all ranks at once
      sums.assign(n + 1, 0.);
      in_pieces(
        [&](const unsigned int block, const auto begin, const auto end) {
          const double *a = w->block(block).begin();
          for (unsigned int i = 0; i <= n; ++i)
            {
              const double *b   = (i < n ? *v[i] : *w).block(block).begin();
              double        sum = 0.;
              DEAL_II_OPENMP_SIMD_PRAGMA
              for (auto k = begin; k < end; ++k)
                sum += a[k] * b[k];
              sums[i] += sum;
            }
        });
      dealii::Utilities::MPI::sum(sums,
                                  w->block(0).get_mpi_communicator(),
                                  sums);
      in_pieces(
        [&](const unsigned int block, const auto begin, const auto end) {
          double *a = w->block(block).begin();
          for (unsigned int i = 0; i < n; ++i)
            {
              const double *b = v[i]->block(block).begin();
              DEAL_II_OPENMP_SIMD_PRAGMA
              for (auto k = begin; k < end; ++k)
                a[k] -= sums[i] * b[k];
            }
        });
      double rest = sums[n];
      for (unsigned int i = 0; i < n; ++i)
        {
          h[i] += sums[i];
          rest -= sums[i] * sums[i];
        }
      norm = std::sqrt(std::max(rest, 0.)); // Pythagoras
      return sums[n];
    }

    /// Call @p function(block, begin, end) for pieces of w that stay in the
    /// cache.
    template <typename Function>
    void
    in_pieces(const Function &function) const
    {
      constexpr std::size_t size = 512;
      for (unsigned int b = 0; b < w->n_blocks(); ++b)
        {
          const std::size_t all = w->block(b).locally_owned_size();
          for (std::size_t begin = 0; begin < all; begin += size)
            function(b, begin, std::min(all, begin + size));
        }
    }

    /// x += Z y, where y minimises the residual.
    void
    update(Vector &x)
    {
      for (unsigned int i = n; i-- > 0;)
        {
          for (unsigned int k = i + 1; k < n; ++k)
            g[i] -= H[k][i] * g[k];
          g[i] = H[i][i] != 0. ? g[i] / H[i][i] : 0.;
        }
      for (unsigned int i = 0; i < n; ++i)
        x.add(g[i], *z[i]);
    }

    void
    rotate(const unsigned int i, double &a, double &b) const
    {
      const double before = a;
      a                   = cosine[i] * before + sine[i] * b;
      b                   = cosine[i] * b - sine[i] * before;
    }

    Vector &
    vector(std::vector<Pointer> &vectors, const unsigned int i)
    {
      if (i == vectors.size())
        {
          vectors.emplace_back(memory);
          vectors.back()->reinit(*w, /*omit_zeroing=*/true);
        }
      return *vectors[i];
    }

    std::vector<double> &
    column(const unsigned int j)
    {
      if (j == H.size())
        {
          H.emplace_back(basis_size + 1);
          cosine.push_back(1.);
          sine.push_back(0.);
        }
      return H[j];
    }

    Memory               memory;
    Pointer              w;    // residual, then the vector at work
    std::vector<Pointer> v, z; // basis, and M times it
    unsigned int         n = 0;
    // columns of the Hessenberg matrix, rotated to triangular shape
    std::vector<std::vector<double>> H;
    std::vector<double>              cosine, sine, g, sums;
  };
} // namespace seiche

#endif
