// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_cut_cell_h
#define seiche_space_cut_cell_h

#include <seiche/space/cell_simplices.h>

#include <deal.II/base/symmetric_tensor.h>

namespace seiche
{
  /// A level set is never zero: that is outside.
  inline double
  nonzero_level(const double value)
  {
    constexpr double on_surface = 1e-12;
    return value == 0. ? on_surface : value;
  }

  /// Integrals of 1, x and x x^T over a part of the unit cell.
  template <int dim>
  struct Moments
  {
    double                          volume = 0.;
    dealii::Tensor<1, dim>          first;
    dealii::SymmetricTensor<2, dim> second;

    void
    add(const Moments &other)
    {
      volume += other.volume;
      first += other.first;
      second += other.second;
    }
  };

  /**
   * @brief The part of the unit cell where a multilinear function is negative:
   * its volume, centre and second moments, and a quadrature rule that has them
   * (doc/theory.md (5.0c)).
   *
   * The cell is divided into simplices (cell_simplices()), on each of which the
   * function is taken as linear.
   */
  template <int dim>
  class CutCell
  {
  public:
    static constexpr unsigned int n_vertices =
      dealii::GeometryInfo<dim>::vertices_per_cell;

    explicit CutCell(const VertexValues<dim> &values);

    /// Share of the cell [-].
    double
    volume() const
    {
      return part.volume;
    }

    /// Points of equal weight volume()/n_vertices, inside it or up to 0.02
    /// beside it, that integrate polynomials of degree 2 exactly: the Gauss
    /// points if the function is negative in the whole cell. volume() must not
    /// be zero.
    std::array<dealii::Point<dim>, n_vertices>
    points() const;

  private:
    /// Add the part of a simplex where its function is negative.
    void
    add_inside(const CellSimplex<dim> &simplex, const Moments<dim> &whole);

    Moments<dim> part;
  };
} // namespace seiche

#endif
