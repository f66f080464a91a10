// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/timer_tree.h>

#include <deal.II/base/exceptions.h>

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace seiche
{
  namespace
  {
    double
    seconds(const clockid_t clock)
    {
      timespec now{};
      clock_gettime(clock, &now);
      return static_cast<double>(now.tv_sec) + 1e-9 * now.tv_nsec;
    }

    double
    cpu_clock()
    {
      return seconds(CLOCK_PROCESS_CPUTIME_ID);
    }

    std::string
    line(const unsigned int depth,
         const std::string &name,
         const std::string &calls,
         const double       cpu,
         const double       total,
         const double       wall)
    {
      const std::string label = std::string(2 * depth, ' ') + name;
      return fmt::format("{:<40}{:>9}{:>12.3f}{:>8.1f} %{:>12.3f}\n",
                         label,
                         calls,
                         cpu,
                         total > 0. ? 100. * cpu / total : 0.,
                         wall);
    }
  } // namespace



  double
  wall_clock()
  {
    return seconds(CLOCK_MONOTONIC);
  }



  TimerTree::Scope::Scope(TimerTree &timer_tree, const char *name)
    : tree(timer_tree)
  {
    tree.enter(name);
  }



  TimerTree::Scope::~Scope()
  {
    tree.leave();
  }



  TimerTree::TimerTree()
    : sections(1)
  {
    sections[0].name       = "run";
    sections[0].calls      = 1;
    sections[0].cpu_start  = cpu_clock();
    sections[0].wall_start = wall_clock();
  }



  void
  TimerTree::enter(const char *name)
  {
    const auto &children = sections[current].children;
    const auto  child =
      std::find_if(children.begin(), children.end(), [&](const unsigned int i) {
        return sections[i].name == name;
      });
    unsigned int index;
    if (child != children.end())
      index = *child;
    else
      {
        index = sections.size();
        sections.emplace_back();
        sections[index].name   = name;
        sections[index].parent = current;
        sections[current].children.push_back(index);
      }
    current = index;
    ++sections[current].calls;
    sections[current].cpu_start  = cpu_clock();
    sections[current].wall_start = wall_clock();
  }



  void
  TimerTree::leave()
  {
    Assert(current != 0, dealii::ExcMessage("No section is open."));
    Section &section = sections[current];
    section.cpu += cpu_clock() - section.cpu_start;
    section.wall += wall_clock() - section.wall_start;
    current = section.parent;
  }



  std::pair<double, double>
  TimerTree::elapsed(const unsigned int index) const
  {
    const Section &section = sections[index];
    // open sections are the current one and those around it
    for (unsigned int open = current;; open = sections[open].parent)
      {
        if (open == index)
          return {section.cpu + cpu_clock() - section.cpu_start,
                  section.wall + wall_clock() - section.wall_start};
        if (open == 0)
          return {section.cpu, section.wall};
      }
  }



  std::map<std::string, double>
  TimerTree::phase_seconds() const
  {
    std::map<std::string, double> result;
    double                        rest = cpu_seconds();
    for (unsigned int i = 1; i < sections.size(); ++i)
      if (sections[i].children.empty())
        {
          const double cpu = elapsed(i).first;
          result[sections[i].name] += cpu;
          rest -= cpu;
        }
    result["other"] += std::max(0., rest);
    return result;
  }



  double
  TimerTree::cpu_seconds() const
  {
    return elapsed(0).first;
  }



  double
  TimerTree::wall_seconds() const
  {
    return elapsed(0).second;
  }



  void
  TimerTree::report_section(const unsigned int index,
                            const unsigned int depth,
                            const double       total,
                            std::string       &text) const
  {
    const Section &section = sections[index];
    const auto     own     = elapsed(index);
    text += line(depth,
                 section.name,
                 std::to_string(section.calls),
                 own.first,
                 total,
                 own.second);
    if (section.children.empty())
      return;

    auto rest = own;
    for (const unsigned int child : section.children)
      {
        const auto part = elapsed(child);
        rest.first -= part.first;
        rest.second -= part.second;
        report_section(child, depth + 1, total, text);
      }
    text += line(depth + 1,
                 "other",
                 "",
                 std::max(0., rest.first),
                 total,
                 std::max(0., rest.second));
  }



  std::string
  TimerTree::report() const
  {
    std::string text = fmt::format("{:<40}{:>9}{:>12}{:>10}{:>12}\n",
                                   "section",
                                   "calls",
                                   "cpu [s]",
                                   "share",
                                   "wall [s]");
    report_section(0, 0, cpu_seconds(), text);
    return text;
  }
} // namespace seiche
