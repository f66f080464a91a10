/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* Counts and times of MPI calls by the profiling interface, for
   contrib/utilities/mpi_profile: calls, bytes sent and seconds inside MPI, by
   kind, one line a rank at MPI_Finalize. Seconds inside MPI are mostly waiting.
   Bytes of collectives are those that the rank contributes. */
#include <mpi.h>
#include <stdio.h>

enum kind
{
  send,
  receive,
  wait,
  collective,
  n_kinds
};

static const char *names[n_kinds] = {"send", "receive", "wait", "collective"};
static long long   calls[n_kinds];
static double      bytes[n_kinds];
static double      seconds[n_kinds];

static double
size_of(int count, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  return (double)count * size;
}

/* One wrapper: counts the call, adds its bytes and its time. */
#define WRAP(kind, name, parameters, arguments, amount) \
  int MPI_##name parameters                             \
  {                                                     \
    const double start  = PMPI_Wtime();                 \
    const int    result = PMPI_##name arguments;        \
    seconds[kind] += PMPI_Wtime() - start;              \
    bytes[kind] += amount;                              \
    ++calls[kind];                                      \
    return result;                                      \
  }

#define SEND_PARAMETERS \
  (const void *b, int n, MPI_Datatype t, int d, int tag, MPI_Comm c)
WRAP(send, Send, SEND_PARAMETERS, (b, n, t, d, tag, c), size_of(n, t))
WRAP(send, Rsend, SEND_PARAMETERS, (b, n, t, d, tag, c), size_of(n, t))
WRAP(send, Ssend, SEND_PARAMETERS, (b, n, t, d, tag, c), size_of(n, t))
#define ISEND_PARAMETERS                                              \
  (const void *b, int n, MPI_Datatype t, int d, int tag, MPI_Comm c, \
   MPI_Request *r)
WRAP(send, Isend, ISEND_PARAMETERS, (b, n, t, d, tag, c, r), size_of(n, t))
WRAP(send, Irsend, ISEND_PARAMETERS, (b, n, t, d, tag, c, r), size_of(n, t))
WRAP(send, Issend, ISEND_PARAMETERS, (b, n, t, d, tag, c, r), size_of(n, t))

WRAP(receive,
     Recv,
     (void *b, int n, MPI_Datatype t, int s, int tag, MPI_Comm c, MPI_Status *u),
     (b, n, t, s, tag, c, u),
     0.)
WRAP(receive,
     Irecv,
     (void *b, int n, MPI_Datatype t, int s, int tag, MPI_Comm c, MPI_Request *r),
     (b, n, t, s, tag, c, r),
     0.)

WRAP(wait, Wait, (MPI_Request * r, MPI_Status *u), (r, u), 0.)
WRAP(wait, Waitall, (int n, MPI_Request r[], MPI_Status u[]), (n, r, u), 0.)
WRAP(wait,
     Waitany,
     (int n, MPI_Request r[], int *i, MPI_Status *u),
     (n, r, i, u),
     0.)
WRAP(wait,
     Waitsome,
     (int n, MPI_Request r[], int *o, int i[], MPI_Status u[]),
     (n, r, o, i, u),
     0.)
WRAP(wait, Probe, (int s, int tag, MPI_Comm c, MPI_Status *u), (s, tag, c, u), 0.)
WRAP(wait, Test, (MPI_Request * r, int *f, MPI_Status *u), (r, f, u), 0.)

#define REDUCE_PARAMETERS \
  (const void *s, void *r, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c)
#define GATHER_PARAMETERS                                             \
  (const void *s, int n, MPI_Datatype t, void *r, int m, MPI_Datatype u, \
   MPI_Comm c)
WRAP(collective, Barrier, (MPI_Comm c), (c), 0.)
WRAP(collective,
     Bcast,
     (void *b, int n, MPI_Datatype t, int root, MPI_Comm c),
     (b, n, t, root, c),
     size_of(n, t))
WRAP(collective, Allreduce, REDUCE_PARAMETERS, (s, r, n, t, o, c), size_of(n, t))
WRAP(collective,
     Reduce,
     (const void *s, void *r, int n, MPI_Datatype t, MPI_Op o, int root, MPI_Comm c),
     (s, r, n, t, o, root, c),
     size_of(n, t))
WRAP(collective, Scan, REDUCE_PARAMETERS, (s, r, n, t, o, c), size_of(n, t))
WRAP(collective, Exscan, REDUCE_PARAMETERS, (s, r, n, t, o, c), size_of(n, t))
WRAP(collective, Allgather, GATHER_PARAMETERS, (s, n, t, r, m, u, c), size_of(n, t))
WRAP(collective,
     Allgatherv,
     (const void  *s,
      int          n,
      MPI_Datatype t,
      void        *r,
      const int    m[],
      const int    o[],
      MPI_Datatype u,
      MPI_Comm     c),
     (s, n, t, r, m, o, u, c),
     size_of(n, t))
WRAP(collective,
     Gather,
     (const void *s,
      int          n,
      MPI_Datatype t,
      void        *r,
      int          m,
      MPI_Datatype u,
      int          root,
      MPI_Comm     c),
     (s, n, t, r, m, u, root, c),
     size_of(n, t))
WRAP(collective, Alltoall, GATHER_PARAMETERS, (s, n, t, r, m, u, c), size_of(n, t))
WRAP(collective, Reduce_scatter_block, REDUCE_PARAMETERS, (s, r, n, t, o, c), size_of(n, t))
WRAP(collective, Comm_dup, (MPI_Comm c, MPI_Comm *d), (c, d), 0.)

int
MPI_Finalize(void)
{
  int rank, size, r, k;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  PMPI_Comm_size(MPI_COMM_WORLD, &size);
  for (r = 0; r < size; ++r)
    {
      if (r == rank)
        {
          fprintf(stderr, "mpi_profile rank %d:", rank);
          for (k = 0; k < n_kinds; ++k)
            fprintf(stderr,
                    "%s %s %lld calls %.0f bytes %.3f s",
                    k == 0 ? "" : ";",
                    names[k],
                    calls[k],
                    bytes[k],
                    seconds[k]);
          fprintf(stderr, "\n");
          fflush(stderr);
        }
      PMPI_Barrier(MPI_COMM_WORLD);
    }
  return PMPI_Finalize();
}
