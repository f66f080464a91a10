// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/mesh_adaptation.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  MeshAdaptation<dim>::MeshAdaptation(BackgroundGrid<dim> &background_grid,
                                      CellLocator<dim>    &cell_locator,
                                      PointCloud<dim>     &point_cloud,
                                      const bool           gauss)
    : grid(background_grid)
    , locator(cell_locator)
    , points(point_cloud)
    , parameters(background_grid.parameters.refinement)
    , gauss_in_full_cells(gauss)
    , communicator(background_grid.triangulation.get_communicator())
  {
    find_fluid();
    share_out();
    if (parameters.is_adaptive())
      adapt_fully();
  }

  template <int dim>
  bool
  MeshAdaptation<dim>::update(const unsigned int step)
  {
    const bool due = step % parameters.adapt_every == 0;
    if (!parameters.is_adaptive())
      {
        if (!due || Utilities::MPI::n_mpi_processes(communicator) == 1)
          return false;
        find_fluid();
        return share_out();
      }
    find_fluid();
    if (!due && !surface_left_its_level())
      return false;
    const bool changed = adapt();
    return share_out() || changed;
  }

  template <int dim>
  void
  MeshAdaptation<dim>::adapt_fully()
  {
    // a cell with few points has children without: new surface
    for (unsigned int pass = 0; pass < 2 * (grid.finest_level() + 2) && adapt();
         ++pass)
      share_out();
  }

  template <int dim>
  void
  MeshAdaptation<dim>::find_fluid()
  {
    holds_fluid.assign(locator.cells.size(), 0);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      holds_fluid[cell] = points.n_points_in(cell) > 0;
    locator.cells.exchange_to_ghosts(holds_fluid);
    at_surface.assign(locator.cells.size(), 0);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (holds_fluid[cell])
        {
          const auto neighbors = locator.cells.vertex_neighbors(cell);
          at_surface[cell] =
            std::any_of(neighbors.begin(),
                        neighbors.end(),
                        [&](const unsigned int c) { return !holds_fluid[c]; });
        }
  }

  template <int dim>
  bool
  MeshAdaptation<dim>::surface_left_its_level() const
  {
    const unsigned int level =
      grid.lattice_level() + parameters.free_surface_level();
    bool left = false;
    for (unsigned int cell = 0; cell < locator.cells.n_owned() && !left; ++cell)
      if (at_surface[cell])
        {
          const auto neighbors = locator.cells.vertex_neighbors(cell);
          left                 = locator.cells.level(cell) < level ||
                 std::any_of(neighbors.begin(),
                             neighbors.end(),
                             [&](const unsigned int c) {
                               return holds_fluid[c] &&
                                      locator.cells.level(c) < level;
                             });
        }
    return Utilities::MPI::max(left ? 1 : 0, communicator) == 1;
  }

  template <int dim>
  bool
  MeshAdaptation<dim>::adapt()
  {
    choose_levels();
    bool owners_changed = false;
    if (a_family_is_shared())
      {
        owners_changed = share_out(/*at_once=*/true);
        choose_levels();
      }
    bool flagged = false;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        const auto &iterator = locator.cells.iterator(cell);
        if (next_level[cell] > locator.cells.level(cell))
          iterator->set_refine_flag();
        else if (next_level[cell] < locator.cells.level(cell))
          iterator->set_coarsen_flag();
        flagged = flagged || next_level[cell] != locator.cells.level(cell);
      }
    if (Utilities::MPI::max(flagged ? 1 : 0, communicator) == 0)
      return owners_changed;
    const auto before = grid.triangulation.get_checksum();
    grid.triangulation.execute_coarsening_and_refinement();
    const bool changed = before != grid.triangulation.get_checksum();
    if (Utilities::MPI::max(changed ? 1 : 0, communicator) == 0)
      return owners_changed;
    locator.reinit();
    points.relocate();
    find_fluid(); // the flags of cells are those of this mesh again
    return true;
  }

  template <int dim>
  bool
  MeshAdaptation<dim>::a_family_is_shared() const
  {
    bool shared = false;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      shared = shared || (next_level[cell] < locator.cells.level(cell) &&
                          !siblings_are_own(cell));
    return Utilities::MPI::max(shared ? 1 : 0, communicator) == 1;
  }

  template <int dim>
  bool
  MeshAdaptation<dim>::siblings_are_own(const unsigned int cell) const
  {
    const auto parent = locator.cells.iterator(cell)->parent();
    for (const auto &child : parent->child_iterators())
      if (!child->is_locally_owned())
        return false;
    return true;
  }

  template class MeshAdaptation<2>;
  template class MeshAdaptation<3>;
} // namespace seiche
