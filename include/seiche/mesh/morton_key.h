// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_morton_key_h
#define seiche_mesh_morton_key_h

#include <array>
#include <cstdint>

namespace seiche
{
  /// Interleave the bits of the indices (up to 64/dim bits each).
  template <int dim>
  std::uint64_t
  morton_key(const std::array<unsigned int, dim> &index)
  {
    constexpr unsigned int bits = dim == 2 ? 32 : 21;
    std::uint64_t          key  = 0;
    for (unsigned int bit = 0; bit < bits; ++bit)
      for (unsigned int d = 0; d < dim; ++d)
        key |= ((static_cast<std::uint64_t>(index[d]) >> bit) & 1u)
               << (dim * bit + d);
    return key;
  }
} // namespace seiche

#endif
