// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/chambers.h>

#include <boost/pending/disjoint_sets.hpp>

#include <map>
#include <optional>

namespace seiche
{
  template <int dim>
  Chambers<dim>::Chambers(const BackgroundGrid<dim> &background_grid)
    : grid(background_grid)
  {
    // level 0 is known to all ranks, and has its vertices for good
    const auto                         &mesh = grid.triangulation;
    boost::disjoint_sets_with_storage<> joined(mesh.n_vertices());
    for (const auto &cell : mesh.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        joined.union_set(cell->vertex_index(0), cell->vertex_index(v));
    for (const auto &[side, other] : mesh.get_periodic_face_map())
      if (side.first->level() == 0)
        joined.union_set(side.first->vertex_index(0),
                         other.first.first->vertex_index(0));

    std::map<std::size_t, unsigned int> numbers;
    of_coarse_cell.resize(mesh.n_cells(0));
    for (const auto &cell : mesh.cell_iterators_on_level(0))
      {
        const unsigned int chamber =
          numbers
            .try_emplace(joined.find_set(cell->vertex_index(0)), numbers.size())
            .first->second;
        of_coarse_cell[cell->index()] = chamber;
        open.resize(numbers.size(), 0);
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() &&
              grid.wall_at(face).condition == WallCondition::open)
            open[chamber] = 1;
      }
  }

  template <int dim>
  dealii::BoundingBox<dim>
  Chambers<dim>::box(const unsigned int chamber) const
  {
    std::optional<dealii::BoundingBox<dim>> around;
    for (const auto &cell : grid.triangulation.cell_iterators_on_level(0))
      if (of_coarse_cell[cell->index()] == chamber)
        {
          if (around)
            around->merge_with(cell->bounding_box());
          else
            around = cell->bounding_box();
        }
    return *around;
  }

  template <int dim>
  double
  Chambers<dim>::volume(
    const unsigned int                                             chamber,
    const std::function<double(const unsigned int, const double)> &place) const
  {
    double sum = 0.;
    for (const auto &cell : grid.triangulation.cell_iterators_on_level(0))
      if (of_coarse_cell[cell->index()] == chamber)
        {
          const auto box     = cell->bounding_box().get_boundary_points();
          double     measure = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            measure *= place(d, box.second[d]) - place(d, box.first[d]);
          sum += measure;
        }
    return sum;
  }

  template class Chambers<2>;
  template class Chambers<3>;
} // namespace seiche
