// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_earlier_results_h
#define seiche_simulation_earlier_results_h

#include <string>

namespace seiche
{
  /**
   * @brief What an earlier run has left in the output folder.
   *
   * A new run moves it to a folder beside, NAME.old, before it writes anything;
   * what lay there goes to NAME.older and is removed when the new run has done
   * a step. Only files that a run writes are touched, and only by rename(), so
   * that whatever kills the program loses nothing: files are collected in
   * NAME.moving, which becomes NAME.old when all are there, and which the next
   * run in the folder empties if that did not happen. The files by which
   * results are known to be worth keeping (checkpoints, then statistics.csv)
   * are the last to be moved. Results without a single step are not kept.
   *
   * Folders that this class has made hold a file that says so; others are
   * never emptied. All functions are for rank 0 while it has the folder's lock,
   * and throw FileError.
   */
  class EarlierResults
  {
  public:
    /// Nothing is touched.
    explicit EarlierResults(const std::string &directory);

    /// Bring back what a run that was killed has moved in part.
    void
    settle() const;

    /// Empty the folder for a new run; true if there were results to keep.
    bool
    move_aside() const;

    /// Where results are if this folder has none; empty if it has, or if there
    /// are none.
    std::string
    hint() const;

    /// This run, too, has results now: those before the last ones go.
    void
    remove_older() const;

    /// Where move_aside() has put them.
    const std::string &
    place() const
    {
      return old;
    }

  private:
    const std::string directory, moving, old, older;
  };
} // namespace seiche

#endif
