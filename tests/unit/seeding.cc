// SPDX-License-Identifier: LGPL-2.1-or-later
// Number, mass, spacing and jitter of the points at the start.
#include <cmath>

#include "scene_from_text.h"

namespace
{
  using namespace dealii;

  /// What is known of the points of a scene with density 2 kg/m^3.
  template <int dim>
  struct Truth
  {
    unsigned int   n_points;
    double         spacing; // [m]
    double         volume;
    Point<dim>     centre;
    Tensor<2, dim> gradient = {}; // v = gradient x, or 0 beyond @p end
    double         end      = 10.;
    double         blur     = 1e-9; // of the centre [m]
  };



  template <int dim>
  void
  seed(const std::string &name,
       const std::string &text,
       const Truth<dim>  &truth)
  {
    const SeededScene<dim> seeded(text,
                                  2.,
                                  {seiche::PointColumn::velocity_gradient});
    const auto            &points = seeded.points;
    double                 mass   = 0.;
    Tensor<1, dim>         centre;
    bool                   right = true;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const double m = points.data(seiche::PointColumn::mass)[p];
        const auto   x = points.position(p);
        mass += m;
        centre += m * x;
        const auto G = (x[0] < truth.end ? 1. : 0.) * truth.gradient;
        const auto v = G * x;
        for (unsigned int d = 0; d < dim; ++d)
          {
            right &= std::abs(points.data(seiche::PointColumn::velocity, d)[p] -
                              v[d]) < 1e-12;
            for (unsigned int e = 0; e < dim; ++e)
              right &=
                std::abs(points.data(seiche::PointColumn::velocity_gradient,
                                     d * dim + e)[p] -
                         G[d][e]) < 1e-7; // by differences
          }
      }
    const double off = truth.centre.distance(Point<dim>(centre / mass));
    const std::set<std::uint64_t> ids(points.ids().begin(), points.ids().end());
    const auto                   &result = seeded.result;
    std::cout << dim << "D " << name << ": " << result.n_points
              << " points, as many as expected "
              << verdict(result.n_points == truth.n_points &&
                         points.size() == truth.n_points)
              << ", different ids " << verdict(ids.size() == points.size())
              << ", spacing "
              << verdict(std::abs(2. * result.half_spacing - truth.spacing) <
                         1e-12)
              << ", mass " << verdict(std::abs(mass - 2. * truth.volume) < 1e-9)
              << ", centre " << verdict(off < truth.blur)
              << ", velocities and gradients " << verdict(right) << std::endl;
  }



  /// Jitter moves each point of a lattice evenly by up to this share of the
  /// spacing either way. Both scenes have the same points in the same order.
  void
  compare_jittered(const std::string &text,
                   const double       jitter,
                   const double       spacing)
  {
    const SeededScene<2> even(text, 2.);
    const SeededScene<2> moved(text + "subsection Points\n set Jitter = " +
                                 std::to_string(jitter) + "\nend\n",
                               2.);
    Tensor<1, 2>         mean, square;
    double               largest = 0.;
    const auto           n       = even.points.size();
    for (std::size_t p = 0; p < n; ++p)
      {
        const Tensor<1, 2> way =
          (moved.points.position(p) - even.points.position(p)) /
          (jitter * spacing);
        for (unsigned int d = 0; d < 2; ++d)
          {
            mean[d] += way[d] / n;
            square[d] += way[d] * way[d] / n;
            largest = std::max(largest, std::abs(way[d]));
          }
      }
    std::cout << "jitter: same points "
              << verdict(even.points.ids() == moved.points.ids())
              << ", even in both directions "
              << verdict(largest < 1. && largest > 0.999 &&
                         mean.norm() < 0.02 &&
                         std::abs(square[0] - 1. / 3.) < 0.01 &&
                         std::abs(square[1] - 1. / 3.) < 0.01)
              << std::endl;
  }



  const std::string tank = "subsection Grid\n set Lower corner = 0, 0\n"
                           "set Upper corner = 3.22, 3.0\n"
                           "set Break points x = 1.2\n set Cells x = 24, 40\n"
                           "set Cells y = 60\nend\n";
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        column =
    "subsection Fluid body column\n set Lower corner = 0, 0\n"
    "set Upper corner = 1.2, 0.6\n set Velocity = 2*y; -3*x + y\nend\n";
  const Tensor<2, 2> shear({{0., 2.}, {-3., 1.}});
  const Truth<2>     whole = {
        24 * 12 * 16, 0.0125, 1.2 * 0.6, Point<2>(0.6, 0.3), shear};
  Truth<2> other = whole;
  seed<2>("column", tank + column, whole);
  other.blur = 1e-4; // a random walk of 4608 points by half a spacing
  seed<2>("jittered",
          tank + column + "subsection Points\n set Jitter = 0.5\nend\n",
          other);
  compare_jittered(tank + column, 0.5, 0.0125);
  seed<2>("faces between grid lines",
          tank + "subsection Fluid body a\n set Lower corner = 0.113, 0.201\n"
                 "set Upper corner = 1.307, 0.333\nend\n",
          {1056, 0.006, 1.194 * 0.132, Point<2>(0.71, 0.267)});
  other = {24 * 12 * 24, 0.011125, 1.8 * 0.6, Point<2>(0.9, 0.3), shear, 1.2};
  seed<2>("first body wins",
          tank + column +
            "subsection Fluid body wide\n set Lower corner = 0.6, 0\n"
            "set Upper corner = 1.8, 0.6\nend\n",
          other);
  seed<2>("ball",
          tank + "subsection Fluid body ball\n set Shape = ball\n"
                 "set Centre = 1, 1\n set Radius = 0.5\nend\n",
          {5084, 0.0125, 0.25 * numbers::PI, Point<2>(1., 1.)});
  other = {(24 * 12 - 8 * 6) * 16,
           0.0125,
           1.2 * 0.6 - 0.4 * 0.3,
           Point<2>(0.6, 0.33),
           shear};
  seed<2>("around an obstacle",
          tank + column +
            "subsection Obstacle a\n set Lower corner = 0.4, 0\n"
            "set Upper corner = 0.8, 0.3\nend\n",
          other);
  const Tensor<2, 3> turn({{0., 0., 1.}, {1., 0., 0.}, {0., 2., 0.}});
  seed<3>("column",
          "subsection Grid\n set Lower corner = 0, 0, 0\n"
          "set Upper corner = 1.6, 0.4, 0.8\n set Cell size = 0.05\nend\n"
          "subsection Fluid body column\n set Lower corner = 0, 0, 0\n"
          "set Upper corner = 0.4, 0.4, 0.4\n set Velocity = z; x; 2*y\nend\n"
          "subsection Points\n set Per cell and direction = 2\nend\n",
          {8 * 8 * 8 * 8, 0.025, 0.064, Point<3>(0.2, 0.2, 0.2), turn});

  print_input_error([]() {
    seed<2>("nothing",
            tank + "subsection Fluid body drop\n set Shape = ball\n"
                   "set Centre = 1, 1\n set Radius = 0.001\nend\n",
            {});
  });
  print_input_error([]() {
    seed<2>("singular",
            tank + "subsection Fluid body drop\n set Shape = ball\n"
                   "set Centre = 1, 1\n set Radius = 0.5\n"
                   "set Velocity = log(0.9 - x); 0\nend\n",
            {});
  });
}
