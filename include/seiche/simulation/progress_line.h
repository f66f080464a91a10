// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_progress_line_h
#define seiche_simulation_progress_line_h

#include <cstddef>
#include <string>

namespace seiche
{
  /**
   * @brief A line on the screen that the next one overwrites if that is a
   * terminal; else one line after the other.
   */
  class ProgressLine
  {
  public:
    ProgressLine();

    void
    show(const std::string &text);

    /// Other text follows.
    void
    end();

    const bool on_terminal;

  private:
    std::size_t width = 0; // of what a terminal shows
  };
} // namespace seiche

#endif
