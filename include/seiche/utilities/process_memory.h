// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_process_memory_h
#define seiche_utilities_process_memory_h

namespace seiche
{
  /// Freed memory stays with the process: the arrays of a step come and go with
  /// the same sizes, and the system would clear new pages for them each time.
  /// Does nothing with other C libraries than glibc.
  void
  keep_freed_memory();

  /// Once: give back what is free now. Between arrays of ever other sizes the
  /// heap gets holes; where nearly everything is freed they can go.
  void
  return_freed_memory();
} // namespace seiche

#endif
