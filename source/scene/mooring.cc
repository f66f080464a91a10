// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/mooring.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// From the anchor, without its last coordinate [m].
    template <int dim>
    Tensor<1, dim>
    across(const Mooring<dim> &mooring, const Placement<dim> &body)
    {
      Tensor<1, dim> result = body.place(mooring.fairlead) - mooring.anchor;
      result[dim - 1]       = 0.;
      return result;
    }
  } // namespace

  template <int dim>
  Catenary::Ends
  Mooring<dim>::ends(const Placement<dim> &body) const
  {
    return line.ends(across(*this, body).norm(),
                     body.place(fairlead)[dim - 1] - anchor[dim - 1],
                     on_ground);
  }

  template <int dim>
  Tensor<1, dim>
  Mooring<dim>::force(const Placement<dim> &body) const
  {
    const Catenary::Ends at       = ends(body);
    const Tensor<1, dim> way      = across(*this, body);
    const double         distance = way.norm();
    Tensor<1, dim>       result;
    if (distance > 0.)
      result = -at.horizontal / distance * way;
    result[dim - 1] = -at.vertical;
    return result;
  }

  template <int dim>
  std::vector<std::string>
  Mooring<dim>::columns(const std::string &name)
  {
    const std::string start = "mooring " + name + " ";
    return {start + "tension [N]",
            start + "tension at anchor [N]",
            start + "on ground [m]"};
  }

  template <int dim>
  std::vector<double>
  Mooring<dim>::values(const Placement<dim> &body) const
  {
    const Catenary::Ends at = ends(body);
    return {std::hypot(at.horizontal, at.vertical), at.anchor, at.lying};
  }

  template <int dim>
  void
  MooringParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection(std::string(kind) + " " + name);
    prm.add_parameter("Solid",
                      solid,
                      "The Solid NAME, moved by the fluid, that it holds. [-]");
    prm.add_parameter("Fairlead",
                      fairlead,
                      "Its end on the solid, as that lies at t = 0. [m]");
    prm.add_parameter("Anchor", anchor, "Its other end, which is fixed. [m]");
    prm.add_parameter("Ground",
                      ground,
                      "level: at the anchor lies level ground without "
                      "friction, on which a part of the line may lie while "
                      "its fairlead is above; none: it hangs free. [-]",
                      Patterns::Selection("level|none"));
    prm.add_parameter("Length",
                      length,
                      "Of the line without tension. [m]",
                      Patterns::Double(0.));
    prm.add_parameter("Weight",
                      weight,
                      "Of the line in the water, per length; the last "
                      "coordinate points upwards. 2D: per metre across, too. "
                      "[N/m]",
                      Patterns::Double(0.));
    prm.add_parameter("Axial stiffness",
                      stiffness,
                      "Force over strain, E A; 2D: per metre. [N]",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }

  template <int dim>
  Mooring<dim>
  MooringParameters<dim>::make(const InputFile &input) const
  {
    const auto require_positive = [&](const double       value,
                                      const std::string &entry) {
      input.require(value > 0., path(entry), "must be greater than zero.");
    };
    require_positive(length, "Length");
    require_positive(weight, "Weight");
    require_positive(stiffness, "Axial stiffness");
    input.require(!fairlead.empty(),
                  path("Fairlead"),
                  "the place on the solid at which the line ends is needed.");
    input.require(!anchor.empty(),
                  path("Anchor"),
                  "the place at which the line is held is needed.");
    input.cites("jonkman2007");
    Mooring<dim> result;
    result.name = name;
    result.fairlead =
      entry_values::point<dim>(input, path("Fairlead"), fairlead);
    result.anchor    = entry_values::point<dim>(input, path("Anchor"), anchor);
    result.on_ground = ground == "level";
    result.line      = {length, weight, stiffness};
    input.require(result.fairlead.distance(result.anchor) > 1e-6 * length,
                  path("Anchor"),
                  "anchor and fairlead are one place.");
    return result;
  }

  template struct Mooring<2>;
  template struct Mooring<3>;
  template struct MooringParameters<2>;
  template struct MooringParameters<3>;
} // namespace seiche
