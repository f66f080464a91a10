// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/ghost_penalty.h>
#include <seiche/utilities/shape_functions.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/quadrature_lib.h>

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
                      "on thin cells, gamma_v [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Ghost velocity time",
                      velocity_time,
                      "Time T_v of that damping: a physical time, so that it "
                      "does not grow with small steps [s]",
                      Patterns::Double(1e-300));
    prm.add_parameter("Sliver treatment",
                      sliver_treatment,
                      "Cells with little fluid: lumped mass, averaged "
                      "subscale term");
    prm.leave_subsection();
  }

  template <int dim>
  void
  GhostFaceMatrix<dim>::evaluate(const GhostFace      &face,
                                 const Occupancy<dim> &occupancy)
  {
    const auto &locator = occupancy.locator;
    h                   = 0.5 * (locator.extent(face.lower)[face.direction] +
               locator.extent(face.upper)[face.direction]);
    if (locator.level(face.lower) == locator.level(face.upper) &&
        !occupancy.hanging().has_matrix(face.lower) &&
        !occupancy.hanging().has_matrix(face.upper))
      evaluate_conforming(face, occupancy);
    else
      evaluate_hanging(face, occupancy);
  }

  template <int dim>
  void
  GhostFaceMatrix<dim>::evaluate_conforming(const GhostFace      &face,
                                            const Occupancy<dim> &occupancy)
  {
    const auto        &locator = occupancy.locator;
    const unsigned int n       = face.direction;
    const double       h_lower = locator.extent(face.lower)[n];
    const double       h_upper = locator.extent(face.upper)[n];
    // jump of the normal derivative in terms of the three nodes on a line
    const double jump[3] = {1. / h_lower,
                            -1. / h_lower - 1. / h_upper,
                            1. / h_upper};

    // node (s, t): position s = 0, 1, 2 along the normal, t within the face
    constexpr unsigned int n_face = 1u << (dim - 1);
    n_nodes                       = 3 * n_face;
    const auto corner             = [&](const unsigned int t,
                            const unsigned int upper_side) {
      unsigned int index = upper_side << n, bit = 0;
      for (unsigned int d = 0; d < dim; ++d)
        if (d != n)
          index |= ((t >> bit++) & 1u) << d;
      return index;
    };
    const unsigned int *lower = occupancy.cell_nodes(face.lower);
    const unsigned int *upper = occupancy.cell_nodes(face.upper);
    for (unsigned int t = 0; t < n_face; ++t)
      {
        nodes[t]              = lower[corner(t, 0)];
        nodes[n_face + t]     = lower[corner(t, 1)];
        nodes[2 * n_face + t] = upper[corner(t, 1)];
      }

    for (unsigned int t = 0; t < n_face; ++t)
      for (unsigned int r = 0; r < n_face; ++r)
        {
          double       mass = 1.; // of the face's multilinear functions
          unsigned int bit  = 0;
          for (unsigned int d = 0; d < dim; ++d)
            if (d != n)
              {
                const bool same = ((t >> bit) & 1u) == ((r >> bit) & 1u);
                mass *= locator.extent(face.lower)[d] / (same ? 3. : 6.);
                ++bit;
              }
          for (unsigned int s = 0; s < 3; ++s)
            for (unsigned int q = 0; q < 3; ++q)
              B[s * n_face + t][q * n_face + r] = jump[s] * jump[q] * mass;
        }
  }

  template <int dim>
  void
  GhostFaceMatrix<dim>::evaluate_hanging(const GhostFace      &face,
                                         const Occupancy<dim> &occupancy)
  {
    const auto            &locator = occupancy.locator;
    constexpr unsigned int n       = LinearShape<dim>::n_nodes;
    // the face of the smaller cell
    const bool lower_is_small =
      locator.level(face.lower) >= locator.level(face.upper);
    const unsigned int small = lower_is_small ? face.lower : face.upper;
    const Point<dim>   begin = locator.lower_corner(small);
    const auto        &size  = locator.extent(small);

    n_nodes = 2 * n;
    for (unsigned int a = 0; a < n; ++a)
      {
        nodes[a]     = occupancy.cell_nodes(face.lower)[a];
        nodes[n + a] = occupancy.cell_nodes(face.upper)[a];
      }
    for (auto &row : B)
      std::fill(std::begin(row), std::end(row), 0.);
    const QGauss<dim - 1> quadrature(2);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        Point<dim>   x      = begin;
        double       weight = quadrature.weight(q);
        unsigned int bit    = 0;
        for (unsigned int d = 0; d < dim; ++d)
          if (d == face.direction)
            x[d] += lower_is_small ? size[d] : 0.;
          else
            {
              x[d] += quadrature.point(q)[bit++] * size[d];
              weight *= size[d];
            }
        double jump[max_nodes];
        for (const bool upper : {false, true})
          {
            const unsigned int cell = upper ? face.upper : face.lower;
            double             N[n], slope[n][dim];
            LinearShape<dim>::evaluate(locator.to_unit(cell, x), N, slope);
            double *here = jump + (upper ? n : 0);
            for (unsigned int a = 0; a < n; ++a)
              here[a] = (upper ? 1. : -1.) * slope[a][face.direction] /
                        locator.extent(cell)[face.direction];
            occupancy.condense(cell, here);
          }
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < n_nodes; ++b)
            B[a][b] += jump[a] * jump[b] * weight;
      }
  }

  GhostCoefficients
  ghost_coefficients(const FreeSurfaceParameters &parameters,
                     const GhostFace             &face,
                     const double                 h,
                     const double                 density,
                     const double                 tau_momentum,
                     const bool                   damping)
  {
    const double      inertia = density * h * h * h;
    GhostCoefficients result;
    result.acceleration = parameters.acceleration * inertia;
    result.pressure     = parameters.pressure * tau_momentum * h;
    if (damping && face.thin)
      result.velocity =
        parameters.velocity * inertia / parameters.velocity_time;
    return result;
  }

  template struct GhostFaceMatrix<2>;
  template struct GhostFaceMatrix<3>;
} // namespace seiche
