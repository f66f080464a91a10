// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_background_grid_h
#define seiche_scene_background_grid_h

#include <seiche/scene/grid_segments.h>

#include <deal.II/distributed/tria.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief The background grid: a forest of axis-parallel boxes.
   *
   * Grid lines are given per direction by break points and the number of
   * equal cells between two of them. The coarse cells are as large as the
   * cell counts allow (the largest common power of two is made by
   * refinement); coarse cells inside an obstacle do not exist. The cells of
   * the lines are level 0 for the user; refinement criteria add levels, and
   * cells that none of them claims may be coarser. Boundary ids:
   * 2 d and 2 d + 1 for the lower and upper side of the box in direction d,
   * 2 dim + i for obstacle i. Names of the sides: left, right, bottom, top in
   * 2D; left, right, front, back, bottom, top in 3D.
   *
   * The forest joins periodic sides (balance, ghost cells); what else has to
   * know that they are one place, the seam, asks Cells, which takes them
   * for no boundary, or NodeMasters.
   */
  template <int dim>
  class BackgroundGrid
  {
  public:
    using Segment = GridSegment;
    /// Indices of cells between the grid lines (level 0 of the user): [first,
    /// second) per direction.
    using LatticeBox =
      std::pair<std::array<unsigned int, dim>, std::array<unsigned int, dim>>;

    /// Collective. @p grid_parameters must outlive the grid.
    BackgroundGrid(const GridParameters<dim> &grid_parameters,
                   MPI_Comm                   communicator);

    /// Divide the cells among the ranks so that each gets an equal share of
    /// the weights; own cells only are asked. Collective.
    void
    repartition(
      const std::function<unsigned int(
        const typename dealii::Triangulation<dim>::cell_iterator &)> &weight);

    const std::vector<Segment> &
    segments(const unsigned int direction) const;

    /// Number of cells of level 0 in a direction, obstacles included.
    unsigned int
    n_lattice_cells(const unsigned int direction) const;

    /// Forest level of the cells between the grid lines: the user's level 0.
    unsigned int
    lattice_level() const;

    /// Greatest forest level that refinement may make.
    unsigned int
    finest_level() const;

    /// The cells that do not exist because of obstacle @p index.
    const LatticeBox &
    obstacle_box(const unsigned int index) const;

    const Wall<dim> &
    wall(const unsigned int number) const;

    /// The wall, or open or periodic side, of a face at the boundary.
    template <typename FaceIterator>
    const Wall<dim> &
    wall_at(const FaceIterator &face) const
    {
      return wall(face->boundary_id());
    }

    const GridParameters<dim>                        &parameters;
    dealii::parallel::distributed::Triangulation<dim> triangulation;

  private:
    void
    make_coarse_cells();
    void
    set_boundary_ids();
    void
    join_periodic_sides();

    std::array<std::vector<Segment>, dim> lattice;
    std::vector<LatticeBox>               obstacle_boxes;
    unsigned int                          n_refinements = 0;
  };
} // namespace seiche

#endif
