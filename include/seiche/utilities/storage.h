// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_storage_h
#define seiche_utilities_storage_h

#include <cstddef>
#include <vector>

namespace seiche
{
  /**
   * @brief Memory for @p size elements of a long vector whose content is not
   * needed any more.
   *
   * A vector that grows by an element with each step of a run doubles its
   * memory the first time, and keeps the old one meanwhile; here it grows by an
   * eighth. The vector is empty afterwards.
   */
  template <typename T>
  void
  make_room(std::vector<T> &values, const std::size_t size)
  {
    values.clear();
    if (size <= values.capacity())
      return;
    std::vector<T>().swap(values);
    values.reserve(size + size / 8);
  }
} // namespace seiche

#endif
