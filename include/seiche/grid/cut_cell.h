// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_cut_cell_h
#define seiche_grid_cut_cell_h

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

#include <array>

namespace seiche
{
  /**
   * @brief The part of the unit cell where a multilinear function is negative:
   * its volume, centre and second moments, and a quadrature rule that has them.
   *
   * The cell is divided into simplices around its centre (in 3D around the
   * centres of its faces, too), on each of which the function is taken as
   * linear.
   */
  template <int dim>
  class CutCell
  {
  public:
    static constexpr unsigned int n_vertices =
      dealii::GeometryInfo<dim>::vertices_per_cell;
    using Values = std::array<double, n_vertices>;

    /// @p values at the vertices, bit d of whose number is coordinate d.
    explicit CutCell(const Values &values);

    /// Share of the cell [-].
    double
    volume() const
    {
      return sum;
    }

    /// Points of equal weight volume()/n_vertices, inside it or up to 0.02
    /// beside it, that integrate polynomials of degree 2 exactly: the Gauss
    /// points if the function is negative in the whole cell. volume() must not
    /// be zero.
    std::array<dealii::Point<dim>, n_vertices>
    points() const;

  private:
    struct Simplex
    {
      std::array<dealii::Point<dim>, dim + 1> vertices;
      std::array<double, dim + 1>             values;
    };

    void
    divide(const Values &values);

    /// The part of a simplex where its function is negative.
    void
    add_negative(const Simplex &simplex);

    void
    add(const Simplex &simplex);

    double                          sum = 0.;
    dealii::Tensor<1, dim>          first;  ///< integral of x
    dealii::SymmetricTensor<2, dim> second; ///< integral of x x^T
  };
} // namespace seiche

#endif
