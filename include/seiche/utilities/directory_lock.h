// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_directory_lock_h
#define seiche_utilities_directory_lock_h

#include <string>

namespace seiche
{
  /**
   * @brief Lock of an output directory: the second run in it is refused.
   */
  class DirectoryLock
  {
  public:
    DirectoryLock() = default;
    ~DirectoryLock();
    DirectoryLock(const DirectoryLock &) = delete;
    DirectoryLock &
    operator=(const DirectoryLock &) = delete;

    /// FileError if another run holds the lock.
    void
    acquire(const std::string &directory);

  private:
    int descriptor = -1;
  };
} // namespace seiche

#endif
