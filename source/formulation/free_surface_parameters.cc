// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/free_surface_parameters.h>
#include <seiche/parameters/input_file.h>

#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  using namespace dealii;

  void
  FreeSurfaceParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Free surface");
    prm.add_parameter("Ghost acceleration",
                      acceleration,
                      "Ghost penalty on jumps of the acceleration's normal "
                      "derivative, gamma_a [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Ghost pressure",
                      pressure,
                      "Ghost penalty on jumps of the pressure's normal "
                      "derivative, gamma_p [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Ghost velocity",
                      velocity,
                      "Damping of jumps of the velocity's normal derivative "
                      "where there is hardly more than drops and spray, "
                      "gamma_v [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Ghost velocity time",
                      velocity_time,
                      "Time T_v of that damping: a physical time, so that it "
                      "does not grow with small steps [s]",
                      Patterns::Double(1e-300));
    prm.add_parameter("Point inertia",
                      point_inertia,
                      "Inertia of the points' own extent (second moments), in "
                      "multiples of that of a box with a point's volume: keeps "
                      "nodes with little mass from running away; more than 4 "
                      "slows fronts; 0: none [-]",
                      Patterns::Double(0., 16.));
    prm.leave_subsection();
  }

  void
  FreeSurfaceParameters::check(const InputFile &input,
                               const bool       is_mixed) const
  {
    if (acceleration > 0. || velocity > 0. || (is_mixed && pressure > 0.))
      input.cites("burman2010 coombs2023");
    if (point_inertia > 0.)
      input.cites("bardenhagen2004");
    input.read_only_if(is_mixed,
                       "Free surface/Ghost pressure",
                       "Formulation/Name = displacement-pressure");
    input.read_only_if(velocity > 0.,
                       "Free surface/Ghost velocity time",
                       "Free surface/Ghost velocity");
  }
} // namespace seiche
