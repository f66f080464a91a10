// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_timer_tree_h
#define seiche_utilities_timer_tree_h

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace seiche
{
  /// Seconds [s] of a clock that never goes back, from an arbitrary start.
  double
  wall_clock();

  /**
   * @brief Nested timings in processor and wall seconds of this rank.
   *
   * A section opened inside another is its child; what no child covers is
   * reported as `other`. The object owns its sections; Scope is the only way
   * to open one, so that an exception cannot leave it running.
   */
  class TimerTree
  {
  public:
    class Scope
    {
    public:
      Scope(TimerTree &tree, const char *name);
      ~Scope();
      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;

    private:
      TimerTree &tree;
    };

    TimerTree();

    /// Processor seconds [s] of the innermost sections, added up by name, and
    /// `other`, what they do not cover; the values add up to cpu_seconds().
    std::map<std::string, double>
    phase_seconds() const;

    /// Processor seconds [s] since construction (CPU clock of the process).
    double
    cpu_seconds() const;

    /// Wall seconds [s] since construction.
    double
    wall_seconds() const;

    /// The tree as text: calls, processor seconds, share, wall seconds.
    std::string
    report() const;

  private:
    struct Section
    {
      std::string               name;
      unsigned int              parent = 0;
      std::vector<unsigned int> children;
      unsigned int              calls      = 0;
      double                    cpu        = 0.;
      double                    wall       = 0.;
      double                    cpu_start  = 0.;
      double                    wall_start = 0.;
    };

    void
    enter(const char *name);
    void
    leave();

    /// Processor and wall seconds of a section, also while it is open.
    std::pair<double, double>
    elapsed(const unsigned int index) const;
    void
    report_section(const unsigned int index,
                   const unsigned int depth,
                   const double       total,
                   std::string       &text) const;

    std::vector<Section> sections; // [0] is the whole run
    unsigned int         current = 0;
  };
} // namespace seiche

#endif
