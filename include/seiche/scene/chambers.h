// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_chambers_h
#define seiche_scene_chambers_h

#include <seiche/scene/background_grid.h>

#include <functional>
#include <vector>

namespace seiche
{
  /**
   * @brief The parts into which obstacles divide the domain.
   *
   * Cells that share a vertex, across a periodic side too, belong to one
   * chamber. Refinement and moving walls change nothing. The same on all ranks.
   */
  template <int dim>
  class Chambers
  {
  public:
    /// @p grid must outlive the object.
    explicit Chambers(const BackgroundGrid<dim> &grid);

    unsigned int
    size() const
    {
      return open.size();
    }

    /// Index of the chamber that holds a cell.
    unsigned int
    index(typename dealii::Triangulation<dim>::cell_iterator cell) const
    {
      if (size() == 1)
        return 0;
      while (cell->level() > 0)
        cell = cell->parent();
      return of_coarse_cell[cell->index()];
    }

    /// True if one of its sides is open.
    bool
    is_open(const unsigned int chamber) const
    {
      return open[chamber];
    }

    /// The box around it [m], as the grid was made.
    dealii::BoundingBox<dim>
    box(const unsigned int chamber) const;

    /// Volume [m^dim] with the grid lines at @p place (direction, place in
    /// BackgroundGrid [m]).
    double
    volume(const unsigned int chamber,
           const std::function<double(const unsigned int, const double)> &place)
      const;

    const BackgroundGrid<dim> &grid;

  private:
    std::vector<unsigned int> of_coarse_cell;
    std::vector<char>         open;
  };
} // namespace seiche

#endif
