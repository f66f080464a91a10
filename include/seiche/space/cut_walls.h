// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_cut_walls_h
#define seiche_space_cut_walls_h

#include <seiche/mesh/cell_locator.h>
#include <seiche/space/wet_part.h>

#include <cmath>
#include <vector>

namespace seiche
{
  template <int dim>
  class MeshNodes;

  /// A level set or fill without its last digits: classes and parts of cells
  /// are the same on any number of ranks.
  inline double
  rounded(const double value)
  {
    return std::round(value * 1e10) * 1e-10;
  }

  template <int dim>
  VertexValues<dim>
  rounded(VertexValues<dim> levels)
  {
    for (double &level : levels)
      level = rounded(level);
    return levels;
  }

  /**
   * @brief Where solids (GridParameters::solids) cut the cells of the mesh: the
   * distance from the nearest of them is interpolated by FE_Q(1), so that the
   * walls of neighbours, also of different size, fit together.
   */
  template <int dim>
  class CutWalls
  {
  public:
    /// After each change of the mesh or its places. Collective.
    void
    reinit(const MeshNodes<dim> &mesh);

    /// True if there are solids.
    bool
    exist() const
    {
      return !shares.empty();
    }

    /// Share of an own or ghost cell that is outside of the solids.
    double
    wet_share(const unsigned int cell) const
    {
      return exist() ? shares[cell] : 1.;
    }

    /// True if a wall passes through an own or ghost cell, or along its face
    /// on the side of the fluid.
    bool
    cuts(const unsigned int cell) const
    {
      return exist() && part_of_cell[cell] != none;
    }

    /// Distance at the vertices of a cut cell [m], positive in the fluid.
    const VertexValues<dim> &
    distance(const unsigned int cell) const
    {
      return parts[part_of_cell[cell]].distance;
    }

    /// The same at a place in it.
    double
    distance_at(const unsigned int cell, const dealii::Point<dim> &unit) const
    {
      double result = 0.;
      for (unsigned int v = 0; v < distance(cell).size(); ++v)
        result += distance(cell)[v] *
                  dealii::GeometryInfo<dim>::d_linear_shape_function(unit, v);
      return result;
    }

    /// A cut cell outside of the solids, full of fluid.
    const WetPart<dim> &
    whole(const unsigned int cell) const
    {
      return parts[part_of_cell[cell]].whole;
    }

    /// The solid nearest to a place in the unit cell (WallPoint::solid).
    unsigned int
    solid_near(const unsigned int cell, const dealii::Point<dim> &unit) const;

    /// Tell the points of a wall in a cell what solid is there and its normal.
    void
    name_solids(const unsigned int           cell,
                std::vector<WallPoint<dim>> &wall) const;

    /// Integrals over the wet part of a cell of the hat functions of its
    /// vertices, over its measure.
    VertexValues<dim>
    hat_integrals(const unsigned int cell) const;

    /// The same over what of its solids lies where @p level, at its vertices,
    /// is negative.
    VertexValues<dim>
    hats_in_solids(const unsigned int       cell,
                   const VertexValues<dim> &level) const;

  private:
    static constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

    struct Part
    {
      dealii::Point<dim> lower, upper; ///< corners of the cell [m]
      VertexValues<dim>  distance;
      WetPart<dim>       whole;

      bool
      lies_like(const Part &other) const
      {
        return lower == other.lower && upper == other.upper &&
               distance == other.distance;
      }
    };

    const CellLocator<dim>   *locator = nullptr;
    SolidDistances<dim>       distances_of_nodes;
    std::vector<double>       shares;
    std::vector<unsigned int> part_of_cell;
    std::vector<Part>         parts;
  };
} // namespace seiche

#endif
