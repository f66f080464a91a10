// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances from a wall at rest and one that moves: those of before count while
// the places stay, and the wall at rest is not asked again.
#include <seiche/mesh/solid_distances.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "scene_from_text.h"

namespace
{
  using namespace dealii;
  using namespace seiche;

  /// What is left of a plane.
  template <int dim>
  class Plane : public Shape<dim>
  {
  public:
    explicit Plane(const double x)
      : place(x)
    {}

    double
    distance(const Point<dim> &x) const override
    {
      ++asked;
      return x[0] - place;
    }

    BoundingBox<dim>
    bounding_box() const override
    {
      return {};
    }

    mutable unsigned int asked = 0;

  private:
    const double place;
  };

  template <int dim>
  void
  test()
  {
    const InputFile input(file_with("set Dimension = 2\n"), {});
    Point<dim>      upper;
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = 1.;
    RigidMotionParameters<dim> swinging;
    swinging.displacement = dim == 2 ? "t; 0" : "t; 0; 0";
    const auto at_rest    = std::make_shared<const Plane<dim>>(0.5);

    std::vector<Solid<dim>> solids(2);
    solids[0].shape  = at_rest;
    solids[1].motion = std::make_shared<RigidMotion<dim>>(
      swinging, input, BoundingBox<dim>({Point<dim>(), upper}), 1., 0.1);
    std::vector<Point<dim>> places(5, upper);

    SolidDistances<dim> distances;
    double              error = 0.;
    const auto          check = [&](const double x_of_moving) {
      solids[1].shape = std::make_shared<const Plane<dim>>(x_of_moving);
      const auto found = distances.at(solids, places);
      for (unsigned int i = 0; i < places.size(); ++i)
        error = std::max(error,
                         std::abs(found[i] - places[i][0] +
                                  std::max(0.5, x_of_moving)));
      std::cout << ' ' << at_rest->asked;
    };
    std::cout << dim << "D, asked";
    check(0.2);
    check(0.7);
    places[3][0] = 0.3;
    check(0.4);
    places.pop_back();
    check(0.6);
    check(0.1);
    std::cout << ", error " << error << '\n';
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
