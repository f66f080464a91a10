// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_basis_h
#define seiche_space_basis_h

#include <seiche/utilities/box_face.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace seiche
{
  /// Element degrees that the code is built for: 1 to this.
  inline constexpr unsigned int max_degree = 2;

  /// f(std::integral_constant<int, degree>): from a number in a parameter file
  /// to a constant of the compiler.
  template <typename Function>
  auto
  with_degree(const unsigned int degree, const Function &f)
  {
    Assert(degree == 1 || degree == 2, dealii::ExcInternalError());
    return degree == 1 ? f(std::integral_constant<int, 1>()) :
                         f(std::integral_constant<int, 2>());
  }

  /**
   * @brief The shape functions of FE_Q(degree) on a box, in closed form.
   *
   * Nodes are numbered lexicographically, x fastest; node i sits at
   * line_index(i, d)/degree in the unit cell. All loops have fixed bounds, so
   * that a caller's loop over points vectorises.
   */
  template <int dim, int degree>
  struct Basis
  {
    static_assert(degree == 1 || degree == 2, "FE_Q(1) and FE_Q(2)");

    static constexpr unsigned int n_line = degree + 1;
    static constexpr unsigned int n_nodes =
      dim == 2 ? n_line * n_line : n_line * n_line * n_line;

    /// Index 0 ... degree of node i in direction d.
    static constexpr unsigned int
    line_index(const unsigned int i, const unsigned int d)
    {
      return degree == 1 ? (i >> d) & 1u :
                           (d == 0 ? i :
                            d == 1 ? i / 3 :
                                     i / 9) %
                             3;
    }

    /// Node at the vertex v (deal.II's numbering: bit d is coordinate d).
    static constexpr unsigned int
    vertex(const unsigned int v)
    {
      unsigned int node = 0, stride = 1;
      for (unsigned int d = 0; d < dim; ++d, stride *= n_line)
        node += ((v >> d) & 1u) * degree * stride;
      return node;
    }

    /// Values N [n_nodes] at @p unit in the unit cell.
    template <typename Number>
    static void
    values(const dealii::Point<dim, Number> &unit, Number N[])
    {
      Number line[dim][n_line];
      for (unsigned int d = 0; d < dim; ++d)
        line_values(unit[d], line[d]);
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          N[i] = line[0][line_index(i, 0)];
          for (unsigned int d = 1; d < dim; ++d)
            N[i] *= line[d][line_index(i, d)];
        }
    }

    /// Second derivative of shape function i in directions d and e of the
    /// unit cell.
    template <typename Number>
    static Number
    second_derivative(const dealii::Point<dim, Number> &unit,
                      const unsigned int                i,
                      const unsigned int                d,
                      const unsigned int                e)
    {
      Number result = 1.;
      for (unsigned int c = 0; c < dim; ++c)
        {
          Number line[n_line];
          if (c == d && c == e)
            line_curvatures(line);
          else if (c == d || c == e)
            line_slopes(unit[c], line);
          else
            line_values(unit[c], line);
          result *= line[line_index(i, c)];
        }
      return result;
    }

    /// Piecewise multilinear functions of the same nodes [n_nodes]: positive
    /// weights that sum to one, for lumped masses.
    template <typename Number>
    static void
    bilinear_weights(const dealii::Point<dim, Number> &unit, Number N[])
    {
      using std::abs, std::max; // or those of lanes
      if constexpr (degree == 1)
        return values(unit, N);
      Number line[dim][n_line];
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int k = 0; k < n_line; ++k)
          line[d][k] = max(Number(0.), 1. - abs(degree * unit[d] - double(k)));
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          N[i] = line[0][line_index(i, 0)];
          for (unsigned int d = 1; d < dim; ++d)
            N[i] *= line[d][line_index(i, d)];
        }
    }

    // the functions of one direction
    template <typename Number>
    static void
    line_values(const Number x, Number (&N)[n_line])
    {
      if constexpr (degree == 1)
        {
          N[0] = 1. - x;
          N[1] = x;
        }
      else
        {
          N[0] = (1. - x) * (1. - 2. * x);
          N[1] = 4. * x * (1. - x);
          N[2] = x * (2. * x - 1.);
        }
    }

    template <typename Number>
    static void
    line_slopes(const Number x, Number (&dN)[n_line])
    {
      if constexpr (degree == 1)
        {
          dN[0] = -1.;
          dN[1] = 1.;
        }
      else
        {
          dN[0] = 4. * x - 3.;
          dN[1] = 4. - 8. * x;
          dN[2] = 4. * x - 1.;
        }
    }

    template <typename Number>
    static void
    line_curvatures(Number (&ddN)[n_line])
    {
      if constexpr (degree == 1)
        ddN[0] = ddN[1] = 0.;
      else
        {
          ddN[0] = ddN[2] = 4.;
          ddN[1]          = -8.;
        }
    }
  };

  // the same for a degree that the compiler does not know

  /// Index 0 ... degree of node a of a cell in direction d.
  template <int dim>
  unsigned int
  line_index(const unsigned int degree,
             const unsigned int a,
             const unsigned int d)
  {
    return degree == 1 ? Basis<dim, 1>::line_index(a, d) :
                         Basis<dim, 2>::line_index(a, d);
  }

  /// True if node a of a cell lies on a face of it.
  template <int dim>
  bool
  is_on_face(const unsigned int degree,
             const unsigned int a,
             const BoxFace      face)
  {
    return line_index<dim>(degree, a, face.direction()) ==
           (face.is_upper() ? degree : 0);
  }

  /// Node of a cell at its vertex v.
  template <int dim>
  unsigned int
  vertex_node(const unsigned int degree, const unsigned int v)
  {
    return degree == 1 ? Basis<dim, 1>::vertex(v) : Basis<dim, 2>::vertex(v);
  }

  /// Place of node a in the unit cell.
  template <int dim>
  dealii::Point<dim>
  unit_place(const unsigned int degree, const unsigned int a)
  {
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = static_cast<double>(line_index<dim>(degree, a, d)) / degree;
    return result;
  }
} // namespace seiche

#endif
