// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/solid.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  SolidParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection(std::string(kind) + " " + name);
    shape.add_parameters(prm);
    prm.add_parameter("Fluid",
                      side,
                      "On which side of the surface the fluid is: outside of "
                      "the shape, or inside, as in a tank of that shape. [-]",
                      Patterns::Selection("outside|inside"));
    prm.leave_subsection();
  }

  template <int dim>
  std::vector<Solid<dim>>
  make_solids(const std::vector<SolidParameters<dim>> &solids,
              const InputFile                         &input,
              const BoundingBox<dim>                  &domain,
              const std::vector<ShapeParameters<dim>> &named)
  {
    std::vector<Solid<dim>> result;
    for (const auto &solid : solids)
      {
        auto shape = solid.shape.make(input, domain, named);
        if (solid.side == "inside")
          shape = complement_shape<dim>(std::move(shape), domain);
        result.push_back({solid.name, std::move(shape)});
      }
    return result;
  }

  template <int dim>
  const Solid<dim> *
  nearest_solid(const std::vector<Solid<dim>> &solids, const Point<dim> &x)
  {
    if (solids.size() <= 1)
      return solids.empty() ? nullptr : &solids[0];
    return &*std::min_element(solids.begin(),
                              solids.end(),
                              [&x](const auto &a, const auto &b) {
                                return a.shape->distance(x) <
                                       b.shape->distance(x);
                              });
  }

  template const Solid<2> *
  nearest_solid<2>(const std::vector<Solid<2>> &, const Point<2> &);
  template const Solid<3> *
  nearest_solid<3>(const std::vector<Solid<3>> &, const Point<3> &);
  template struct SolidParameters<2>;
  template struct SolidParameters<3>;
  template std::vector<Solid<2>>
  make_solids(const std::vector<SolidParameters<2>> &,
              const InputFile &,
              const BoundingBox<2> &,
              const std::vector<ShapeParameters<2>> &);
  template std::vector<Solid<3>>
  make_solids(const std::vector<SolidParameters<3>> &,
              const InputFile &,
              const BoundingBox<3> &,
              const std::vector<ShapeParameters<3>> &);
} // namespace seiche
