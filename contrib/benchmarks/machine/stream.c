// SPDX-License-Identifier: LGPL-2.1-or-later
// STREAM-like bandwidth (copy, scale, add, triad; double). Build: gcc -O3 -march=native -fopenmp stream.c -o stream
// Run: OMP_NUM_THREADS=1 ./stream [elements=40000000] [repeats=10].  GB/s counts 2 or 3 arrays (no write-allocate).
#include <stdio.h>
#include <stdlib.h>
#include <omp.h>
int main(int argc, char **argv)
{
  const long n = argc > 1 ? atol(argv[1]) : 40000000;
  const int  reps = argc > 2 ? atoi(argv[2]) : 10;
  double *a = malloc(n * 8), *b = malloc(n * 8), *c = malloc(n * 8);
#pragma omp parallel for schedule(static)
  for (long i = 0; i < n; ++i) { a[i] = 1.; b[i] = 2.; c[i] = 0.; }
  double best[4] = {1e9, 1e9, 1e9, 1e9};
  const double s = 3.;
  for (int r = 0; r < reps; ++r)
    for (int k = 0; k < 4; ++k)
      {
        const double t = omp_get_wtime();
#pragma omp parallel
        {
          if (k == 0) {
#pragma omp for schedule(static)
            for (long i = 0; i < n; ++i) c[i] = a[i]; }
          else if (k == 1) {
#pragma omp for schedule(static)
            for (long i = 0; i < n; ++i) b[i] = s * c[i]; }
          else if (k == 2) {
#pragma omp for schedule(static)
            for (long i = 0; i < n; ++i) c[i] = a[i] + b[i]; }
          else {
#pragma omp for schedule(static)
            for (long i = 0; i < n; ++i) a[i] = b[i] + s * c[i]; }
        }
        const double d = omp_get_wtime() - t;
        if (d < best[k]) best[k] = d;
      }
  const char *name[4] = {"copy", "scale", "add", "triad"};
  const int   w[4]    = {2, 2, 3, 3};
  for (int k = 0; k < 4; ++k)
    printf("stream,%d,%ld,%s,%.2f,GB/s\n", omp_get_max_threads(), n, name[k], w[k] * 8. * n / best[k] / 1e9);
  fprintf(stderr, "check %g\n", a[n / 2] + b[n / 2] + c[n / 2]);
  return 0;
}
