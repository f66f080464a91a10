// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/parameters/nearest_name.h>
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
    prm.add_parameter("Condition",
                      condition,
                      "What the wall does to the fluid: slip: no flow to or "
                      "from it, and along it nothing but its Friction; "
                      "unilateral: the same, but the fluid may leave it; "
                      "no-slip: the fluid sticks to it, or slips by Navier's "
                      "law. [-]",
                      Patterns::Selection("slip|unilateral|no-slip"));
    prm.add_parameter("Slip length",
                      slip_length,
                      "Of Navier's law with Condition = no-slip: depth below "
                      "the wall at which the fluid's velocity would be the "
                      "wall's; 0: the fluid sticks. [m]",
                      Patterns::Double(0.));
    prm.add_parameter("Friction",
                      friction,
                      "Skin friction coefficient c_f unless no-slip: "
                      "drag c_f/2 rho |v| v per area. [-]",
                      Patterns::Double(0.));
    motion.add_parameters(
      prm,
      "Where the solid has gone from its place at t = 0: one expression of t "
      "per direction, separated by \";\"; empty: nowhere. [m]");
    prm.add_parameter(
      "Stop distance",
      stop_distance,
      "Distance from other solids and walls at which a solid "
      "that the fluid moves is stopped, for fluid between them "
      "is seen while it is about a cell thick; 0: 1.5 diagonals "
      "of the cells there. [m]",
      Patterns::Double(0.));
    prm.add_parameter("Restitution",
                      restitution,
                      "Rate at which it leaves again, over that at which it "
                      "came, before the fluid takes part. [-]",
                      Patterns::Double(0., 1.));
    prm.leave_subsection();
  }

  template <int dim>
  void
  SolidParameters<dim>::check(const InputFile &input) const
  {
    shape.check(input);
    motion.check(input);
    input.read_only_if(condition == "no-slip",
                       section() + "/Slip length",
                       "Condition = no-slip");
    input.read_only_if(condition != "no-slip",
                       section() + "/Friction",
                       "Condition = slip or unilateral");
    for (const char *const entry : {"/Stop distance", "/Restitution"})
      input.read_only_if(motion.body.any(),
                         section() + entry,
                         section() + "/Free");
    if (condition == "no-slip")
      input.cites("juntunen2009");
    if (condition == "unilateral")
      input.cites("chouly2013");
    if (friction > 0.)
      input.cites("schlichting1979");
  }

  template <int dim>
  std::vector<Solid<dim>>
  make_solids(const std::vector<SolidParameters<dim>> &solids,
              const InputFile                         &input,
              const BoundingBox<dim>                  &domain,
              const std::vector<ShapeParameters<dim>> &named,
              const double                             end_time,
              const double                             step)
  {
    std::vector<Solid<dim>> result;
    for (const auto &parameters : solids)
      {
        auto shape = parameters.shape.make(input, domain, named);
        if (parameters.side == "inside")
          shape = complement_shape<dim>(std::move(shape), domain);
        Solid<dim> solid;
        solid.name           = parameters.name;
        solid.shape_at_start = std::move(shape);
        solid.shape          = solid.shape_at_start;
        if (parameters.condition == "no-slip")
          solid.slip_length = parameters.slip_length;
        else
          solid.friction = parameters.friction;
        solid.may_be_left   = parameters.condition == "unilateral";
        solid.stop_distance = parameters.stop_distance;
        solid.restitution   = parameters.restitution;
        if (parameters.motion.any())
          solid.motion = std::make_shared<RigidMotion<dim>>(
            parameters.motion, input, domain, end_time, step);
        result.push_back(solid.at(/*time=*/0.));
      }
    return result;
  }

  template <int dim>
  void
  add_moorings(const std::vector<MooringParameters<dim>> &moorings,
               const InputFile                           &input,
               std::vector<Solid<dim>>                   &solids)
  {
    std::vector<std::string> free;
    for (const Solid<dim> &solid : solids)
      if (solid.is_free())
        free.push_back(solid.name);
    for (const auto &parameters : moorings)
      {
        const auto        held = std::find_if(solids.begin(),
                                       solids.end(),
                                       [&](const Solid<dim> &solid) {
                                         return solid.name == parameters.solid;
                                       });
        const std::string hint = nearest_hint(parameters.solid, free);
        input.require(held != solids.end() && held->is_free(),
                      parameters.path("Solid"),
                      free.empty() ?
                        "no solid is moved by the fluid: a mooring holds one "
                        "with Solid NAME/Free." :
                        "not a solid that the fluid moves; these are " +
                          quoted_list(free) + (hint.empty() ? "." : hint));
        held->moorings.push_back(parameters.make(input));
      }
  }

  template <int dim>
  Solid<dim>
  Solid<dim>::at(const double other_time) const
  {
    Solid result = *this;
    result.time  = other_time;
    if (motion != nullptr)
      result.shape = placed_shape<dim>(shape_at_start,
                                       motion->at(other_time),
                                       shape_at_start->bounding_box());
    return result;
  }

  template <int dim>
  RigidWay<dim>
  Solid<dim>::way(const double dt, const double theta) const
  {
    if (motion == nullptr)
      return {};
    const double end = std::min(time + dt, motion->end_time);
    return way_between(motion->at(time), motion->at(end), theta);
  }

  template <int dim>
  RigidWay<dim>
  Solid<dim>::velocity() const
  {
    return motion == nullptr ? RigidWay<dim>() : motion->velocity(time);
  }

  template <int dim>
  bool
  any_moves(const std::vector<Solid<dim>> &solids)
  {
    return std::any_of(solids.begin(), solids.end(), [](const auto &solid) {
      return solid.motion != nullptr;
    });
  }

  template <int dim>
  bool
  any_may_be_left(const std::vector<Solid<dim>> &solids)
  {
    return std::any_of(solids.begin(), solids.end(), [](const auto &solid) {
      return solid.may_be_left;
    });
  }

  template <int dim>
  bool
  any_is_free(const std::vector<Solid<dim>> &solids)
  {
    return std::any_of(solids.begin(), solids.end(), [](const auto &solid) {
      return solid.is_free();
    });
  }

  template <int dim>
  double
  largest_way(const std::vector<Solid<dim>> &solids,
              const BoundingBox<dim>        &domain,
              const double                   dt)
  {
    double result = 0.;
    for (const Solid<dim> &solid : solids)
      if (solid.motion != nullptr)
        {
          const BoundingBox<dim> box =
            common_box(solid.shape->bounding_box(), domain);
          if (!(box.volume() > 0.)) // outside
            continue;
          RigidWay<dim> velocity = solid.velocity();
          velocity *= dt;
          for (const RigidWay<dim> &way :
               {velocity, solid.way(dt, /*theta=*/0.)})
            for (unsigned int v = 0; v < (1u << dim); ++v)
              result = std::max(result, way.at(box.vertex(v)).norm());
        }
    return result;
  }

  template <int dim>
  const Solid<dim> *
  nearest_solid(const std::vector<Solid<dim>> &solids, const Point<dim> &x)
  {
    if (solids.size() == 1)
      return &solids[0];
    const Solid<dim> *result = nullptr;
    double            least  = std::numeric_limits<double>::infinity();
    for (const Solid<dim> &solid : solids)
      if (const double distance = solid.shape->distance(x);
          distance < least || result == nullptr)
        {
          result = &solid;
          least  = distance;
        }
    return result;
  }

  template <int dim>
  double
  distance_from(const std::vector<Solid<dim>> &solids, const Point<dim> &x)
  {
    double result = std::numeric_limits<double>::infinity();
    for (const Solid<dim> &solid : solids)
      result = std::min(result, solid.shape->distance(x));
    return result;
  }

#define INSTANTIATE(dim)                                                       \
  template struct Solid<dim>;                                                  \
  template const Solid<dim> *nearest_solid(const std::vector<Solid<dim>> &,    \
                                           const Point<dim> &);                \
  template double            distance_from(const std::vector<Solid<dim>> &,    \
                                           const Point<dim> &);                \
  template bool              any_moves(const std::vector<Solid<dim>> &);       \
  template bool              any_may_be_left(const std::vector<Solid<dim>> &); \
  template bool              any_is_free(const std::vector<Solid<dim>> &);     \
  template double            largest_way(const std::vector<Solid<dim>> &,      \
                                         const BoundingBox<dim> &,             \
                                         const double);                        \
  template struct SolidParameters<dim>;                                        \
  template std::vector<Solid<dim>> make_solids(                                \
    const std::vector<SolidParameters<dim>> &,                                 \
    const InputFile &,                                                         \
    const BoundingBox<dim> &,                                                  \
    const std::vector<ShapeParameters<dim>> &,                                 \
    const double,                                                              \
    const double);                                                             \
  template void add_moorings(const std::vector<MooringParameters<dim>> &,      \
                             const InputFile &,                                \
                             std::vector<Solid<dim>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
