// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_for_each_local_h
#define seiche_grid_for_each_local_h

namespace seiche
{
  /// Apply f(i) to own and ghost entries of a vector's layout.
  template <typename Vector, typename Function>
  void
  for_each_local(const Vector &layout, const Function &f)
  {
    const unsigned int n =
      layout.locally_owned_size() + layout.get_partitioner()->n_ghost_indices();
    for (unsigned int i = 0; i < n; ++i)
      f(i);
  }
} // namespace seiche

#endif
