// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/ghost_face_matrix.h>
#include <seiche/space/point_batch.h>

#include <deal.II/base/quadrature_lib.h>

namespace seiche
{
  using namespace dealii;

  template <int dim, int degree>
  void
  GhostFaceMatrix<dim, degree>::evaluate(const GhostFace      &face,
                                         const Occupancy<dim> &occupancy)
  {
    find_nodes(face, occupancy);
    if (is_conforming(face, occupancy))
      evaluate_conforming(face, occupancy);
    else
      integrate(face, occupancy);
  }

  template <int dim, int degree>
  bool
  GhostFaceMatrix<dim, degree>::is_conforming(const GhostFace      &face,
                                              const Occupancy<dim> &occupancy)
  {
    const auto &cells = occupancy.locator.cells;
    return degree == 1 && cells.level(face.lower) == cells.level(face.upper) &&
           occupancy.template unknowns<degree>(face.lower).matrix == nullptr &&
           occupancy.template unknowns<degree>(face.upper).matrix == nullptr;
  }

  template <int dim, int degree>
  void
  GhostFaceMatrix<dim, degree>::find_nodes(const GhostFace      &face,
                                           const Occupancy<dim> &occupancy)
  {
    const auto &cells = occupancy.locator.cells;
    h = 0.5 * (cells.geometry(face.lower).edges[face.direction] +
               cells.geometry(face.upper).edges[face.direction]);
    if (is_conforming(face, occupancy))
      return find_lines(face, occupancy);
    constexpr unsigned int n = Shape::n_nodes;
    n_nodes                  = 2 * n;
    for (unsigned int a = 0; a < n; ++a)
      {
        nodes[a]     = occupancy.template unknowns<degree>(face.lower)[a];
        nodes[n + a] = occupancy.template unknowns<degree>(face.upper)[a];
      }
  }

  template <int dim, int degree>
  void
  GhostFaceMatrix<dim, degree>::find_lines(const GhostFace      &face,
                                           const Occupancy<dim> &occupancy)
  {
    // node (s, t): position s = 0, 1, 2 along the normal, t within the face
    const unsigned int     n      = face.direction;
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
    const auto lower = occupancy.template unknowns<degree>(face.lower);
    const auto upper = occupancy.template unknowns<degree>(face.upper);
    for (unsigned int t = 0; t < n_face; ++t)
      {
        nodes[t]              = lower[corner(t, 0)];
        nodes[n_face + t]     = lower[corner(t, 1)];
        nodes[2 * n_face + t] = upper[corner(t, 1)];
      }
  }

  template <int dim, int degree>
  void
  GhostFaceMatrix<dim, degree>::evaluate_conforming(
    const GhostFace      &face,
    const Occupancy<dim> &occupancy)
  {
    const auto        &locator = occupancy.locator;
    const unsigned int n       = face.direction;
    const double       h_lower = locator.cells.geometry(face.lower).edges[n];
    const double       h_upper = locator.cells.geometry(face.upper).edges[n];
    // jump of the normal derivative in terms of the three nodes on a line
    const double jump[3] = {1. / h_lower,
                            -1. / h_lower - 1. / h_upper,
                            1. / h_upper};

    constexpr unsigned int n_face = 1u
                                    << (dim - 1); // node (s, t): find_lines()
    for (unsigned int t = 0; t < n_face; ++t)
      for (unsigned int r = 0; r < n_face; ++r)
        {
          double       mass = 1.; // of the face's multilinear functions
          unsigned int bit  = 0;
          for (unsigned int d = 0; d < dim; ++d)
            if (d != n)
              {
                const bool same = ((t >> bit) & 1u) == ((r >> bit) & 1u);
                mass *= locator.cells.geometry(face.lower).edges[d] /
                        (same ? 3. : 6.);
                ++bit;
              }
          for (unsigned int s = 0; s < 3; ++s)
            for (unsigned int q = 0; q < 3; ++q)
              B[s * n_face + t][q * n_face + r] = jump[s] * jump[q] * mass;
        }
  }

  template <int dim, int degree>
  void
  GhostFaceMatrix<dim, degree>::normal_derivatives(
    const Occupancy<dim> &occupancy,
    const unsigned int    cell,
    const unsigned int    direction,
    const Point<dim>     &x,
    const double          sign,
    double               *first,
    double               *second)
  {
    constexpr unsigned int n        = Shape::n_nodes;
    const auto            &geometry = occupancy.locator.cells.geometry(cell);
    const Point<dim> unit = geometry.to_unit(occupancy.locator.image(x, cell));
    const auto       unknowns = occupancy.template unknowns<degree>(cell);
    PointBatch<dim, degree, double> point;
    point.reinit(geometry, unit);
    for (unsigned int a = 0; a < n; ++a)
      first[a] = sign * point.gradient_n[direction][a];
    unknowns.condense(first);
    if constexpr (degree > 1)
      {
        for (unsigned int a = 0; a < n; ++a)
          second[a] = sign *
                      Shape::second_derivative(unit, a, direction, direction) /
                      (geometry.edges[direction] * geometry.edges[direction]);
        unknowns.condense(second);
      }
  }

  template <int dim, int degree>
  void
  GhostFaceMatrix<dim, degree>::integrate(const GhostFace      &face,
                                          const Occupancy<dim> &occupancy)
  {
    const auto            &locator = occupancy.locator;
    constexpr unsigned int n       = Shape::n_nodes;
    // the face of the smaller cell
    const bool lower_is_small =
      locator.cells.level(face.lower) >= locator.cells.level(face.upper);
    const unsigned int small = lower_is_small ? face.lower : face.upper;
    const Point<dim>   begin = locator.cells.geometry(small).lower;
    const auto        &size  = locator.cells.geometry(small).edges;

    for (auto &row : B)
      std::fill(std::begin(row), std::end(row), 0.);
    static const QGauss<dim - 1> quadrature(degree + 1);
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
        double first[max_nodes], second[max_nodes] = {};
        normal_derivatives(
          occupancy, face.lower, face.direction, x, -1., first, second);
        normal_derivatives(
          occupancy, face.upper, face.direction, x, 1., first + n, second + n);
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < n_nodes; ++b)
            B[a][b] += weight * (first[a] * first[b] +
                                 0.25 * h * h * second[a] * second[b]);
      }
  }

  template struct GhostFaceMatrix<2, 1>;
  template struct GhostFaceMatrix<2, 2>;
  template struct GhostFaceMatrix<3, 1>;
  template struct GhostFaceMatrix<3, 2>;
} // namespace seiche
