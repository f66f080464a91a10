// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_density_projection_h
#define seiche_grid_density_projection_h

#include <seiche/grid/fill.h>
#include <seiche/space/cell_laplacian.h>

#include <unordered_map>

namespace seiche
{
  /**
   * @brief Moves points until they fill the inside of the fluid evenly: the
   * nodal fill f goes to that of the inside, f_h, with the way that they go
   * (Kugelstadt, Longva, Thuerey and Bender 2019; doc/theory.md (5.1)).
   *
   * On the nodes S with f_h > 1/2 that no unilateral wall has let go of, and on
   * those with f > 1,
   *
   *     sum_J psi_J int grad N_I . grad N_J = min(1, r n) (f_h - f)_I V_I,
   *
   * n the cells that fluid passes in the step, f_h - f not less than -1 (hats
   * of which a wall leaves next to nothing), psi = 0 elsewhere; a point moves
   * by grad psi, its velocity follows by Taylor with the gradient that it
   * carries. In a full box without a surface the mean of the right-hand side is
   * left out. Integrals are over what solids leave of a cell: no point is sent
   * through their walls.
   */
  template <int dim>
  class DensityProjection
  {
  public:
    /// @p rate: r [-]; 0: nothing happens. @p fill must outlive the object.
    DensityProjection(const Fill<dim> &fill, const double rate);

    /// Move the points after a step in which fluid passes @p cells and at whose
    /// end the grid has the box @p domain; Fill is that of its start. No point
    /// moves by more than a tenth of its cell in a direction, or through a
    /// wall. Collective.
    void
    apply(const double                    cells,
          const dealii::BoundingBox<dim> &domain,
          PointCloud<dim>                &points);

    using Vector = typename Occupancy<dim>::Vector;

    /// The Laplacian on S, the identity elsewhere. Collective.
    void
    vmult(Vector &dst, const Vector &src) const;

  private:
    using Laplacian = CellLaplacian<dim, 1>;

    /// Of occupied cells that solids cut.
    void
    find_laplacians_at_walls();

    /// Of an occupied cell; @p of_box may become that of its box.
    const Laplacian &
    laplacian(const unsigned int cell, Laplacian &of_box) const;

    /// S, and the inverse of the Laplacian's diagonal there.
    void
    choose_nodes();

    void
    find_potential(const double share);

    void
    move(const dealii::BoundingBox<dim> &domain, PointCloud<dim> &points) const;

    const Fill<dim>          &fill;
    const Occupancy<dim>     &occupancy;
    const double              rate;
    Vector                    potential, is_free, inverse_diagonal;
    std::vector<unsigned int> free_cells; ///< with a node of S
    std::unordered_map<unsigned int, Laplacian> at_walls;
    bool any_fixed = false; ///< else psi has no zero
  };
} // namespace seiche

#endif
