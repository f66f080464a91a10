// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_half_full_box_h
#define tests_unit_half_full_box_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

// A scene for the postprocessors, its fields, and what they have to find:
// counted by hand, from lattices of points and nodes.
namespace
{
  using namespace dealii;

  // The scene: four cells a direction, the lower half full of points at rest
  // on a no-slip bottom, an obstacle in the upper right.
  template <int dim>
  std::string
  scene()
  {
    const bool        flat = dim == 2;
    const std::string rest = flat ? "" : ", 0.5";
    return "set Dimension = " + std::to_string(dim) +
           std::string("\nsubsection Grid\n  set Lower corner = 0, 0") +
           (flat ? "" : ", 0") + "\n  set Upper corner = 1, 1" +
           (flat ? "" : ", 1") +
           "\n  set Cell size = 0.25\nend\n"
           "subsection Walls\n  set Bottom = no-slip\nend\n"
           "subsection Obstacle post\n  set Lower corner = 0.75, " +
           (flat ? "0.75" : "0, 0.75") + "\n  set Upper corner = 1, 1" +
           (flat ? "" : ", 1") +
           "\nend\n"
           "subsection Time\n  set End time = 0.2\nend\n"
           "subsection Output\n  set Interval = 0.1\n"
           "  set Point series = true\nend\n"
           "subsection Front right\nend\n"
           "subsection Front bottom\n  set Direction = y\n"
           "  set Sense = lower\nend\n"
           "subsection Gauge middle\n  set Position = 0.5, 0" +
           (flat ? "" : ", 0") +
           "\nend\n"
           "subsection Probe inside\n  set Position = 0.4, 0.3" +
           (flat ? "" : ", 0.2") +
           "\nend\n"
           "subsection Probe sensor\n  set Position = 0, 0.25" +
           (flat ? "" : ", 0.25") +
           "\n  set Diameter = 0.1\nend\n"
           "subsection Probe speed\n  set Position = 0.4, 0.3" +
           (flat ? "" : ", 0.2") +
           "\n  set Quantity = velocity\nend\n"
           "subsection Probe dry\n  set Position = 0.5, 0.9" +
           (flat ? "" : ", 0.9") +
           "\nend\n"
           "subsection Tracked point corner\n  set Position = 0, 0" +
           (flat ? "" : ", 0") + "\n  set Centre = 0.5, 0.5" + rest +
           "\nend\n"
           "subsection Force floor\n  set Walls = bottom\nend\n"
           "subsection Force box\n  set Walls = left, right, bottom\n"
           "  set Reference point = 0.5, 0" +
           (flat ? "" : ", 0") +
           "\nend\n"
           "subsection Error p nodes\n  set Sample = nodes\n  set Norm = rms\n"
           "  set Exact = 3 + 2*x + y\nend\n"
           "subsection Error p Gauss\n  set Exact = 3 + 2*x + y\nend\n"
           "subsection Error p points\n  set Sample = material points\n"
           "  set Norm = maximum\n  set Exact = 3 + 2*x + y\nend\n"
           "subsection Error p shifted\n  set Exact = 103 + 2*x + y\n"
           "  set Norm = rms\n  set Remove mean = true\nend\n"
           "subsection Error p off\n  set Exact = 5 + 2*x + y\n"
           "  set Norm = rms\n  set Scale = 4\n"
           "  set Region upper = 0.5, 0.5" +
           rest +
           "\nend\n"
           "subsection Error v Gauss\n  set Quantity = velocity\n"
           "  set Exact = y; 1 - x" +
           (flat ? "" : "; 0") +
           "\nend\n"
           "subsection Score inside\n"
           "  set Column = probe inside pressure [Pa]\n"
           "  set Measure = last\n  set Time column = pressure_time\nend\n";
  }

  template <int dim>
  double
  exact_pressure(const Point<dim> &x)
  {
    return 3. + 2. * x[0] + x[1];
  }

  template <int dim>
  Tensor<1, dim>
  exact_velocity(const Point<dim> &x)
  {
    Tensor<1, dim> v;
    v[0] = x[1];
    v[1] = 1. - x[0];
    return v;
  }

  /// A linear displacement of the step; it leaves no wall at zero.
  template <int dim>
  Tensor<1, dim>
  displacement(const Point<dim> &x)
  {
    Tensor<1, dim> u;
    u[0] = -0.04 * x[0];
    u[1] = 0.02 * x[1];
    return u;
  }



  constexpr double point_mass = 0.5; // [kg]
  constexpr double gravity    = 10.; // downwards [m/s^2]
  constexpr double time_step  = 0.1; // [s]
  constexpr double theta      = 0.5; // where pressure and forces belong

  /// Places of a lattice with n a direction, the first at @p first.
  template <int dim, typename Function>
  void
  for_each_place(const unsigned int n,
                 const double       first,
                 const double       spacing,
                 const Function    &action)
  {
    for (unsigned int k = 0; k < Utilities::pow(n, dim); ++k)
      {
        Point<dim> x;
        for (unsigned int d = 0, rest = k; d < dim; ++d, rest /= n)
          x[d] = first + spacing * (rest % n);
        action(x);
      }
  }



  /// The points, where they start.
  template <int dim, typename Function>
  void
  for_each_point(const Function &action)
  {
    for_each_place<dim>(8, 0.0625, 0.125, [&](const Point<dim> &x) {
      if (x[dim - 1] < 0.5)
        action(x);
    });
  }



  /// x times v, in 2D its only component the third.
  template <int dim>
  std::array<double, 3>
  moment(const Tensor<1, dim> &x, const Tensor<1, dim> &v)
  {
    std::array<double, 3> a{}, b{};
    for (unsigned int d = 0; d < dim; ++d)
      {
        a[d] = x[d];
        b[d] = v[d];
      }
    return {{a[1] * b[2] - a[2] * b[1],
             a[2] * b[0] - a[0] * b[2],
             a[0] * b[1] - a[1] * b[0]}};
  }



  /// Sums over the points at the start, or when they have moved.
  template <int dim>
  struct Totals
  {
    explicit Totals(const double motion)
    {
      for_each_point<dim>([&](const Point<dim> &start) {
        const Point<dim> x(start + motion * displacement(start));
        const auto       v = exact_velocity(x);
        momentum += point_mass * v;
        for (unsigned int r = 0; r < 3; ++r)
          spin[r] += point_mass * moment<dim>(x, v)[r];
        kinetic += 0.5 * point_mass * v.norm_square();
        potential += point_mass * gravity * x[dim - 1];
        speed = std::max(speed, v.norm());
        ++n_points;
      });
    }

    unsigned int          n_points = 0;
    double                kinetic = 0., potential = 0., speed = 0.;
    Tensor<1, dim>        momentum;
    std::array<double, 3> spin{};
  };



  const std::array<std::string, 3> axes = {{"x", "y", "z"}};

  using Numbers = std::map<std::string, double>;

  /// Each node of a wet cell holds the fluid with the force 1 in each of its
  /// fixed directions: at sides in the normal one, on the bottom in all that
  /// no side has. The fluid answers where the node is in the mean of the step.
  template <int dim>
  void
  add_force(const std::string           &name,
            const std::set<unsigned int> walls, // by number: left, right, ...
            const Point<dim>            &reference,
            Numbers                     &numbers)
  {
    Tensor<1, dim>        force;
    std::array<double, 3> torque{};
    for_each_place<dim>(5, 0., 0.25, [&](const Point<dim> &x) {
      if (x[dim - 1] > 0.5)
        return;
      Tensor<1, dim> f;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const bool at_side = x[d] == 0. || (x[d] == 1. && d + 1 < dim);
          const bool fixed   = at_side || x[dim - 1] == 0.;
          const auto wall    = at_side ? 2 * d + (x[d] > 0.) : 2 * (dim - 1);
          if (fixed && walls.count(wall) > 0)
            f[d] = -1.;
        }
      force += f;
      const auto part = moment<dim>(x + theta * displacement(x) - reference, f);
      for (unsigned int r = 0; r < 3; ++r)
        torque[r] += part[r];
    });
    for (unsigned int d = 0; d < dim; ++d)
      numbers["force " + name + " " + axes[d] + " [N]"] = force[d];
    for (unsigned int r = dim == 2 ? 2 : 0; r < 3; ++r)
      numbers["moment " + name + " " + axes[r] + " [N m]"] = torque[r];
  }



  /// Columns and ledger of the totals.
  template <int dim>
  void
  add_totals(Numbers &numbers)
  {
    const Totals<dim> start(0.), now(1.);
    const double      ratio           = 0.96 * 1.02;
    numbers["points"]                 = now.n_points;
    numbers["mass [kg]"]              = point_mass * now.n_points;
    numbers["volume_relative_change"] = ratio - 1.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        numbers["momentum " + axes[d] + " [kg m/s]"] = now.momentum[d];
        numbers["ledger linear_momentum_change " + axes[d]] =
          now.momentum[d] - start.momentum[d];
      }
    double change = 0., size = 0.;
    for (unsigned int r = dim == 2 ? 2 : 0; r < 3; ++r)
      {
        numbers["angular momentum " + axes[r] + " [kg m^2/s]"] = now.spin[r];
        change += std::pow(now.spin[r] - start.spin[r], 2);
        size += std::pow(start.spin[r], 2);
      }
    const double energy                      = now.kinetic + now.potential;
    const double first                       = start.kinetic + start.potential;
    numbers["kinetic energy [J]"]            = now.kinetic;
    numbers["potential energy [J]"]          = now.potential;
    numbers["relative_energy"]               = energy / first;
    numbers["speed_max [m/s]"]               = now.speed;
    numbers["volume_ratio_min"]              = ratio;
    numbers["volume_ratio_max"]              = ratio;
    numbers["overfull_fraction"]             = 0.;
    numbers["outflow_points"]                = 0.;
    numbers["ledger mass_relative_change"]   = 0.;
    numbers["ledger volume_relative_change"] = ratio - 1.;
    numbers["ledger angular_momentum_relative_change"] =
      std::sqrt(change / size);
    numbers["ledger energy_initial"]           = first;
    numbers["ledger energy_final"]             = energy;
    numbers["ledger energy_max_relative_gain"] = energy / first - 1.;
    numbers["ledger lost_points"]              = 0.;
    numbers["ledger outflow_points"]           = 0.;
    numbers["ledger overfull_fraction"]        = 0.;
    numbers["ledger overfull_fraction_mean"]   = 0.;
  }



  /// Probes, and errors against fields that are exact. @p mixed: the pressure
  /// is the grid's; else it is that of the points, which carry it from the
  /// middle of the step, and what nodes make of it has no entry here.
  template <int dim>
  void
  add_fields(const bool mixed, Numbers &numbers)
  {
    numbers["probe speed velocity x [m/s]"] = 0.3;
    numbers["probe speed velocity y [m/s]"] = 0.6;
    if (dim == 3)
      numbers["probe speed velocity z [m/s]"] = 0.;
    numbers["probe dry pressure [Pa]"] = 0.;
    numbers["error v Gauss [-]"]       = 0.;
    if (mixed)
      {
        numbers["probe inside pressure [Pa]"] = 4.1;
        numbers["probe sensor pressure [Pa]"] = 3.25;
        for (const char *name : {"nodes", "Gauss", "points", "shifted"})
          numbers["error p " + std::string(name) + " [-]"] = 0.;
        numbers["error p off [-]"] = (5. - 3.) / 4.;
        numbers["errors inside"]   = 4.1;
        return;
      }
    double &error = numbers["error p points [-]"];
    for_each_point<dim>([&](const Point<dim> &x) {
      const auto u = displacement(x);
      error        = std::max(error,
                       std::abs(exact_pressure(Point<dim>(x + u)) -
                                exact_pressure(Point<dim>(x + theta * u))));
    });
  }



  /// All numbers after two steps from the same start.
  template <int dim>
  Numbers
  by_hand(const bool mixed)
  {
    Numbers numbers = {{"time [s]", 2. * time_step},
                       {"dt [s]", time_step},
                       {"pressure_time [s]", (mixed ? 1.5 : 2.) * time_step},
                       {"front right [m]", 0.96},
                       {"front bottom [m]", 0.}};
    add_totals<dim>(numbers);
    add_fields<dim>(mixed, numbers);

    const double level                = dim == 2 ? 0.51 : 0.5;
    numbers["gauge middle [m]"]       = level;
    numbers["gauge middle spray [m]"] = level;
    // volume of the points by the weights of hats of one cell, of which the
    // wall cuts off a half in 3D
    double &depth = numbers["depth middle [m]"];
    for_each_point<dim>([&](const Point<dim> &start) {
      const Point<dim> x      = start + displacement(start);
      double           volume = Utilities::fixed_power<dim>(0.125);
      volume *= std::max(0., 1. - std::abs(x[0] - 0.5) / 0.25) / 0.25;
      if (dim == 3)
        volume *= std::max(0., 1. - x[1] / 0.25) / 0.125;
      depth += volume;
    });

    Point<dim> corner, centre, middle_of_floor;
    for (unsigned int d = 0; d < dim; ++d)
      {
        corner[d] = 0.0625;
        centre[d] = 0.5;
      }
    middle_of_floor[0]     = 0.5;
    const Point<dim> moved = corner + displacement(corner);
    for (unsigned int d = 0; d < dim; ++d)
      numbers["point corner " + axes[d] + " [m]"] = moved[d];
    numbers["point corner radius ratio [-]"] =
      moved.distance(centre) / corner.distance(centre);

    add_force<dim>("floor", {2 * (dim - 1)}, Point<dim>(), numbers);
    add_force<dim>("box", {0, 1, 2 * (dim - 1)}, middle_of_floor, numbers);
    return numbers;
  }
} // namespace

#endif
