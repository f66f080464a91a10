// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_shape_checks_h
#define tests_unit_shape_checks_h

#include <seiche/scene/box_part.h>
#include <seiche/scene/fluid_body.h>

#include <cmath>
#include <random>

#include "scene_from_text.h"

using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

template <int dim>
std::string
grid_text()
{
  return dim == 2 ? "subsection Grid\n"
                    "  set Lower corner = 0, 0\n"
                    "  set Upper corner = 2, 1\n"
                    "  set Cell size = 0.1\n"
                    "end\n" :
                    "subsection Grid\n"
                    "  set Lower corner = 0, 0, 0\n"
                    "  set Upper corner = 2, 1, 1\n"
                    "  set Cell size = 0.1\n"
                    "end\n";
}

template <int dim>
std::unique_ptr<SceneFromText<dim>>
scene_with(const std::string &entries, const std::string &shapes)
{
  return std::make_unique<SceneFromText<dim>>(grid_text<dim>() + shapes +
                                              "subsection Fluid body a\n" +
                                              entries + "end\n");
}

/// Sum over boxes that fill the domain.
template <int dim>
double
volume_of(const seiche::Shape<dim> &shape, const double tolerance)
{
  const double edge   = dim == 2 ? 0.025 : 0.05;
  double       result = 0.;
  const auto   n      = [edge](const double length) {
    return std::lround(length / edge);
  };
  Tensor<1, dim> extent;
  for (unsigned int d = 0; d < dim; ++d)
    extent[d] = edge;
  for (long k = 0; k < (dim == 3 ? n(1.) : 1); ++k)
    for (long j = 0; j < n(1.); ++j)
      for (long i = 0; i < n(2.); ++i)
        {
          Point<dim> lower;
          lower[0]       = i * edge;
          lower[1]       = j * edge;
          lower[dim - 1] = dim == 3 ? k * edge : lower[1];
          result += std::pow(edge, dim) *
                    seiche::part_inside<dim>(
                      [&](const auto &x) { return shape.level(x); },
                      BoundingBox<dim>({lower, lower + extent}),
                      std::max(1e-6, tolerance))
                      .share;
        }
  return result;
}

/// Near the surface: the distance changes by as much as one goes along the
/// normal, and distance and level agree about the side.
template <int dim>
bool
distance_is_good(const seiche::Shape<dim> &shape)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> place(0., 1.);
  unsigned int                           n_near = 0;
  bool                                   good   = true;
  for (unsigned int i = 0; i < 200000 && n_near < 400; ++i)
    {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = (d == 0 ? 2. : 1.) * place(random);
      const double distance = shape.distance(x);
      good                  = good && (distance < 0.) == (shape.level(x) < 0.);
      if (std::abs(distance) > 5e-3)
        continue;
      // a step back leads to the surface, but for edges and curvature
      const Tensor<1, dim> normal = shape.normal(x);
      good                        = good && std::abs(normal.norm() - 1.) < 1e-9;
      if (std::abs(shape.distance(x - distance * normal)) > 2e-4)
        continue;
      ++n_near;
      const double step = 1e-5;
      const double slope =
        (shape.distance(x + step * normal) - distance) / step;
      good = good && std::abs(slope - 1.) < 0.05;
    }
  return good && n_near > 100;
}

template <int dim>
void
test(const std::string &name,
     const std::string &entries,
     const double       exact_volume,
     const Point<dim>  &lower_corner,
     const Point<dim>  &upper_corner,
     const double       tolerance = 1e-8,
     const std::string &shapes    = "")
{
  const auto   scene   = scene_with<dim>(entries, shapes);
  const auto  &shape   = *scene->bodies[0].shape;
  const auto   corners = shape.bounding_box().get_boundary_points();
  const double volume = volume_of(shape, tolerance), said = shape.volume();
  std::cout << dim << "D " << name << ": volume "
            << verdict(
                 std::abs(volume - exact_volume) < tolerance &&
                 (std::isnan(said) || std::abs(said - exact_volume) < 1e-12))
            << ", distance " << verdict(distance_is_good(shape)) << ", box "
            << verdict(corners.first.distance(lower_corner) < 1e-12 &&
                       corners.second.distance(upper_corner) < 1e-12)
            << std::endl;
}

template <int dim>
void
refused(const std::string &entries, const std::string &shapes = "")
{
  print_input_error([&]() { scene_with<dim>(entries, shapes); });
}

#endif
