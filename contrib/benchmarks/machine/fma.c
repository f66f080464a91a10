// SPDX-License-Identifier: LGPL-2.1-or-later
// Peak double FMA rate. Build: gcc -O3 -march=native -fopenmp fma.c -o fma  (optionally -DW=2|4|8 lanes)
#include <stdio.h>
#include <omp.h>
#ifndef W
#  ifdef __AVX512F__
#    define W 8
#  elif defined(__AVX__)
#    define W 4
#  else
#    define W 2
#  endif
#endif
#define NV 12
typedef double v __attribute__((vector_size(W * 8)));
int main(void)
{
  const long n = 200000000L;
  double sum = 0., best = 1e9;
  for (int r = 0; r < 3; ++r)
    {
      const double t = omp_get_wtime();
#pragma omp parallel reduction(+ : sum)
      {
        v x[NV], m, c;
        for (int l = 0; l < W; ++l) { m[l] = 0.999999; c[l] = 1e-6; }
        for (int k = 0; k < NV; ++k) for (int l = 0; l < W; ++l) x[k][l] = k + l + omp_get_thread_num();
        for (long i = 0; i < n; ++i)
#pragma GCC unroll 12
          for (int k = 0; k < NV; ++k) x[k] = x[k] * m + c;
        for (int k = 0; k < NV; ++k) for (int l = 0; l < W; ++l) sum += x[k][l];
      }
      const double d = omp_get_wtime() - t;
      if (d < best) best = d;
    }
  printf("fma,%d,%d lanes,double,%.1f,GFLOP/s\n", omp_get_max_threads(), W, 2. * NV * W * n * omp_get_max_threads() / best / 1e9);
  fprintf(stderr, "check %g\n", sum);
  return 0;
}
