// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/refinement.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <array>

namespace seiche
{
  namespace
  {
    struct KindName
    {
      const char    *name;
      RefinementKind kind;
      const char    *description;
    };

    /// THE table of criteria.
    constexpr std::array<KindName, 5> kind_table = {
      {{"fluid",
        RefinementKind::fluid,
        "cells that hold fluid, and \"Layers\" of cells around"},
       {"free surface",
        RefinementKind::free_surface,
        "cells at the free surface, and \"Layers\" of cells on either side"},
       {"walls",
        RefinementKind::walls,
        "fluid up to \"Distance\" from the walls and obstacles in \"Names\""},
       {"probes",
        RefinementKind::probes,
        "fluid up to \"Distance\" from the probes in \"Names\""},
       {"box",
        RefinementKind::box,
        "everything between \"Lower corner\" and \"Upper corner\""}}};

    RefinementKind
    kind_from_string(const std::string &text)
    {
      for (const KindName &entry : kind_table)
        if (text == entry.name)
          return entry.kind;
      Assert(false, dealii::ExcMessage("Unknown criterion: " + text));
      return RefinementKind::fluid;
    }
  } // namespace



  template <int dim>
  RefinementParameters<dim>::RefinementParameters(const InputFile &input)
  {
    for (const std::string &name : input.instances("Refinement"))
      {
        criteria.emplace_back();
        criteria.back().name = name;
        texts.emplace_back();
      }
  }



  template <int dim>
  void
  RefinementParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Double;
    using dealii::Patterns::Integer;
    prm.enter_subsection("Grid");
    prm.add_parameter("Adapt every",
                      adapt_every,
                      "An adaptive mesh (subsections \"Refinement NAME\") "
                      "follows the fluid every so many steps, and at once "
                      "where the free surface reaches a coarser cell. As "
                      "often any mesh is shared out again between several "
                      "ranks. [-]",
                      Integer(1));
    prm.leave_subsection();

    std::string names,
      text = "Where cells have at least this level. Several criteria may "
             "overlap: the greatest level counts.";
    for (const KindName &entry : kind_table)
      {
        names += (names.empty() ? "" : "|") + std::string(entry.name);
        text += std::string(" ") + entry.name + ": " + entry.description + ".";
      }
    for (unsigned int i = 0; i < criteria.size(); ++i)
      {
        prm.enter_subsection("Refinement " + criteria[i].name);
        prm.add_parameter("Criterion",
                          texts[i].kind,
                          text,
                          dealii::Patterns::Selection(names));
        prm.add_parameter("Level",
                          criteria[i].level,
                          "Level of the cells: their edges are 2^-Level of "
                          "those of subsection \"Grid\". Points are seeded "
                          "everywhere for the highest level of all criteria: "
                          "one level more makes 2^dim times as many. [-]",
                          Integer(0, 12));
        prm.add_parameter("Layers",
                          criteria[i].layers,
                          "Cells of this level around the fluid, or on "
                          "either side of the free surface. [-]",
                          Integer(1, 100));
        prm.add_parameter("Distance",
                          criteria[i].distance,
                          "From the walls or probes. [m]",
                          Double(0.));
        prm.add_parameter("Names",
                          texts[i].names,
                          "Of walls (sides of the domain and obstacles) or "
                          "probes, separated by commas; empty: all of them.");
        prm.add_parameter("Lower corner",
                          texts[i].lower,
                          "Corner of the box with the smallest coordinates. "
                          "[m]");
        prm.add_parameter("Upper corner",
                          texts[i].upper,
                          "Opposite corner. [m]");
        prm.leave_subsection();
      }
  }



  template <int dim>
  void
  RefinementParameters<dim>::check(const InputFile           &input,
                                   const GridParameters<dim> &grid)
  {
    for (unsigned int i = 0; i < criteria.size(); ++i)
      {
        RefinementCriterion<dim> &criterion = criteria[i];
        criterion.kind                      = kind_from_string(texts[i].kind);
        criterion.places.clear();
        const std::string path    = "Refinement " + criterion.name + "/";
        const bool        is_box  = criterion.kind == RefinementKind::box;
        const bool        is_near = !is_box && !criterion.follows_fluid();
        input.read_only_if(criterion.follows_fluid(),
                           path + "Layers",
                           "Criterion = fluid or free surface");
        for (const char *entry : {"Distance", "Names"})
          input.read_only_if(is_near,
                             path + entry,
                             "Criterion = walls or probes");
        for (const char *entry : {"Lower corner", "Upper corner"})
          input.read_only_if(is_box, path + entry, "Criterion = box");
        if (is_box)
          read_box(input, grid, i);
        else if (is_near)
          {
            input.require(criterion.distance > 0.,
                          path + "Distance",
                          "this criterion needs one greater than zero [m].");
            if (criterion.kind == RefinementKind::walls)
              read_walls(input, grid, i);
            else
              read_probes(input, i);
          }
      }
    input.require(
      criteria.empty() || std::any_of(criteria.begin(),
                                      criteria.end(),
                                      [](const auto &criterion) {
                                        return criterion.follows_fluid();
                                      }),
      criteria.empty() ? "" : "Refinement " + criteria[0].name + "/Criterion",
      "an adaptive mesh needs the criterion \"fluid\" or \"free "
      "surface\": add one, or the fluid lies in the coarsest "
      "cells.");
  }



  template <int dim>
  unsigned int
  RefinementParameters<dim>::finest_level() const
  {
    unsigned int level = 0;
    for (const auto &criterion : criteria)
      level = std::max(level, criterion.level);
    return level;
  }



  template <int dim>
  unsigned int
  RefinementParameters<dim>::free_surface_level() const
  {
    unsigned int level = 0;
    for (const auto &criterion : criteria)
      if (criterion.kind == RefinementKind::free_surface)
        level = std::max(level, criterion.level);
    return level;
  }



  template struct RefinementParameters<2>;
  template struct RefinementParameters<3>;
} // namespace seiche
