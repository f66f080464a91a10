// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/process_memory.h>

#include <cstdlib> // defines __GLIBC__
#include <limits>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace seiche
{
  void
  keep_freed_memory()
  {
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
  }

  void
  return_freed_memory()
  {
#ifdef __GLIBC__
    malloc_trim(/*pad=*/0);
#endif
  }
} // namespace seiche
