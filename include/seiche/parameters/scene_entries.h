// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_scene_entries_h
#define seiche_parameters_scene_entries_h

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace seiche
{
  /**
   * @brief A scene that a program describes, entry by entry, in the words of
   * doc/parameters.md: `set("Fluid/Density", 1000.)`. What is wrong with them
   * is said when a run is made of them, as for a file.
   */
  class SceneEntries
  {
  public:
    /// @p path: "Subsection/Entry"; each once.
    SceneEntries &
    set(const std::string &path, const std::string &value)
    {
      all.emplace_back(path, value);
      return *this;
    }

    /// With all digits that the number has.
    SceneEntries &
    set(const std::string &path, const double value)
    {
      return set(path, fmt::format("{}", value));
    }

    /// Paths and values in the order in which they were set.
    const std::vector<std::pair<std::string, std::string>> &
    entries() const
    {
      return all;
    }

  private:
    std::vector<std::pair<std::string, std::string>> all;
  };
} // namespace seiche

#endif
