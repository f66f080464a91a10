// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/refinement.h>

#include <boost/algorithm/string.hpp>

#include <algorithm>

// The part of RefinementParameters that reads where a criterion is: walls,
// probes, a box.
namespace seiche
{
  namespace
  {
    std::vector<std::string>
    split(const std::string &text)
    {
      std::vector<std::string> names;
      boost::split(names, text, boost::is_any_of(","));
      for (std::string &name : names)
        boost::trim(name);
      names.erase(std::remove(names.begin(), names.end(), ""), names.end());
      return names;
    }
  } // namespace



  template <int dim>
  void
  RefinementParameters<dim>::read_walls(const InputFile           &input,
                                        const GridParameters<dim> &grid,
                                        const unsigned int         index)
  {
    const std::string path = "Refinement " + criteria[index].name + "/Names";
    std::vector<std::string>              known;
    std::vector<dealii::BoundingBox<dim>> boxes;
    for (const Wall<dim> &wall : grid.walls)
      if (wall.exists())
        {
          known.push_back(wall.name);
          boxes.push_back(wall.box());
        }
    const std::vector<std::string> names = split(texts[index].names);
    for (const std::string &name : names.empty() ? known : names)
      {
        const auto found = std::find(known.begin(), known.end(), name);
        input.require(found != known.end(),
                      path,
                      "there is no wall \"" + name + "\". Walls are " +
                        quoted_list(known) + ".");
        criteria[index].places.push_back(boxes[found - known.begin()]);
      }
  }



  template <int dim>
  void
  RefinementParameters<dim>::read_probes(const InputFile   &input,
                                         const unsigned int index)
  {
    const std::string path = "Refinement " + criteria[index].name + "/Names";
    const std::vector<std::string> known = input.instances("Probe");
    input.require(!known.empty(),
                  path,
                  "there is no probe; add a subsection \"Probe NAME\".");
    const std::vector<std::string> names = split(texts[index].names);
    for (const std::string &name : names.empty() ? known : names)
      {
        input.require(std::find(known.begin(), known.end(), name) !=
                        known.end(),
                      path,
                      "there is no probe \"" + name + "\". Probes are " +
                        quoted_list(known) + ".");
        const std::string position = "Probe " + name + "/Position";
        const auto        place =
          entry_values::point<dim>(input, position, input.value(position));
        criteria[index].places.emplace_back(std::make_pair(place, place));
      }
  }



  template <int dim>
  void
  RefinementParameters<dim>::read_box(const InputFile           &input,
                                      const GridParameters<dim> &grid,
                                      const unsigned int         index)
  {
    const std::string path  = "Refinement " + criteria[index].name + "/";
    const auto        lower = entry_values::point<dim>(input,
                                                path + "Lower corner",
                                                texts[index].lower);
    const auto        upper = entry_values::point<dim>(input,
                                                path + "Upper corner",
                                                texts[index].upper);
    for (unsigned int d = 0; d < dim; ++d)
      {
        input.require(lower[d] < upper[d],
                      path + "Upper corner",
                      "must be greater than \"Lower corner\" in every "
                      "direction.");
        input.require(lower[d] < grid.upper_corner[d] &&
                        upper[d] > grid.lower_corner[d],
                      path + "Lower corner",
                      "the box lies outside of the domain.");
      }
    criteria[index].places.emplace_back(std::make_pair(lower, upper));
  }



  template void
  RefinementParameters<2>::read_walls(const InputFile &,
                                      const GridParameters<2> &,
                                      const unsigned int);
  template void
  RefinementParameters<3>::read_walls(const InputFile &,
                                      const GridParameters<3> &,
                                      const unsigned int);
  template void
  RefinementParameters<2>::read_probes(const InputFile &, const unsigned int);
  template void
  RefinementParameters<3>::read_probes(const InputFile &, const unsigned int);
  template void
  RefinementParameters<2>::read_box(const InputFile &,
                                    const GridParameters<2> &,
                                    const unsigned int);
  template void
  RefinementParameters<3>::read_box(const InputFile &,
                                    const GridParameters<3> &,
                                    const unsigned int);
} // namespace seiche
