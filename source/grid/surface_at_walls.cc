// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/surface.h>

// The part of Surface that continues the fluid into solids (doc/theory.md,
// section 8).
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Rounds of fill and level set.
    constexpr unsigned int n_continuations = 4;
  } // namespace

  template <int dim>
  typename Surface<dim>::Vector
  Surface<dim>::continued_fill(const Vector &wet_fill)
  {
    Vector wet(wet_fill);
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      wet.local_element(i) = wet_share(i);
    wet.update_ghost_values();
    level_at_walls.reinit(wet, wet_fill);
    Vector result(wet_fill);
    // nodes without any fluid are dry, whatever solids hold of their hats
    for (unsigned int round = 0; round < n_continuations; ++round)
      {
        set_level(result);
        Vector dry(level);
        dry = 0.;
        for (unsigned int cell = 0; cell < occupancy.locator.cells.n_owned();
             ++cell)
          if (occupancy.cells.is_active(cell) && walls().wet_share(cell) < 1.)
            {
              VertexValues<dim> hats =
                walls().hats_in_solids(cell, rounded<dim>(level_in(cell)));
              for (double &value : hats)
                value *= occupancy.locator.cells.geometry(cell).measure;
              occupancy.add_vertex_values(cell, hats.data(), dry);
            }
        dry.compress(VectorOperation::add);
        for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
          if (const double whole = whole_volume(i);
              whole > 0. && wet_fill.local_element(i) > 0.)
            result.local_element(i) = wet_share(i) * wet_fill.local_element(i) +
                                      dry.local_element(i) / whole;
      }
    return result;
  }

  template typename Surface<2>::Vector
  Surface<2>::continued_fill(const Vector &);
  template typename Surface<3>::Vector
  Surface<3>::continued_fill(const Vector &);
} // namespace seiche
