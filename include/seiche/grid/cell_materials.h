// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_cell_materials_h
#define seiche_grid_cell_materials_h

#include <seiche/materials/material.h>
#include <seiche/space/occupancy.h>

#include <vector>

namespace seiche
{
  /**
   * @brief The materials of a scene and which of them each cell holds, from the
   * points in it: shares and mean density as in doc/theory.md (2.1b).
   *
   * Cells without points, which the surface has given an inside, take what
   * their neighbours hold. With one material nothing is counted.
   */
  template <int dim>
  class CellMaterials
  {
  public:
    using Vector = typename Occupancy<dim>::Vector;

    /// References must outlive the object; at least one material.
    CellMaterials(const std::vector<Material> &materials,
                  const Occupancy<dim>        &occupancy);

    /// After all occupied cells are known; viscosities count as zero until
    /// they are updated. Collective.
    void
    update(const PointCloud<dim> &points);

    /// Viscosities of the means from now on: at the shear rates that this field
    /// has at the centres of the cells. Collective if they differ.
    void
    update_viscosities(const Vector &velocity);

    /// They are zero from now on: for equations without viscous terms.
    void
    neglect_viscosities()
    {
      viscosities.clear();
      bound.viscosity = 0.;
    }

    /// Columns that the points need beyond the always present ones.
    static std::set<PointColumn>
    columns(const std::vector<Material> &materials);

    /// In the order of their numbers.
    const std::vector<Material> &
    all() const
    {
      return materials;
    }

    bool
    are_several() const
    {
      return materials.size() > 1;
    }

    /// That of a point.
    const Material &
    of_point(const PointCloud<dim> &points, const std::size_t point) const
    {
      return are_several() ?
               materials[points.data(PointColumn::material)[point]] :
               materials[0];
    }

    /// That with the largest volume in an own occupied cell.
    const Material &
    of_cell(const unsigned int cell) const
    {
      return materials[are_several() ? main[cell] : 0];
    }

    /// True if an own occupied cell holds more than one.
    bool
    is_mixed(const unsigned int cell) const
    {
      return are_several() && mixed[cell];
    }

    /// Share of the volume of an own occupied cell that a material has [0,1],
    /// with several.
    double
    share(const unsigned int material, const unsigned int cell) const
    {
      return volumes[material][cell] / totals[cell];
    }

    /// Means of an occupied own or ghost cell.
    FluidProperties
    mean(const unsigned int cell) const
    {
      return {densities.empty() ? bound.density : densities[cell],
              viscosities.empty() ? bound.viscosity : viscosities[cell]};
    }

    /// Means of two cells.
    FluidProperties
    mean(const unsigned int lower, const unsigned int upper) const
    {
      const FluidProperties a = mean(lower), b = mean(upper);
      return {0.5 * (a.density + b.density), 0.5 * (a.viscosity + b.viscosity)};
    }

    /// The largest of all materials or cells.
    const FluidProperties &
    largest() const
    {
      return bound;
    }

    /// True if all cells have the same means. Local.
    bool
    are_uniform() const
    {
      return densities.empty() && viscosities.empty();
    }

    /// Of an own node with this mass [kg], by the mean density of the occupied
    /// cells there [m^dim].
    double
    volume_of_node(const unsigned int node, const double mass) const
    {
      return mass /
             (are_several() ? node_density.local_element(node) : bound.density);
    }

  private:
    void
    sum_points(const PointCloud<dim> &points);
    void
    fill_empty_cells();

    /// Mean [Pa s] of an own occupied cell at a shear rate.
    double
    viscosity(const unsigned int cell, const double gamma_square) const;
    /// gamma^2 [1/s^2] of a velocity in its centre.
    double
    shear_in(const unsigned int cell, const Vector &velocity) const;

    const std::vector<Material> &materials;
    const Occupancy<dim>        &occupancy;
    bool                         is_newtonian = true; // all
    FluidProperties              bound;
    std::vector<double>          viscosities; // [cell], if they differ

    // with several materials
    std::vector<std::vector<double>> volumes; // [material][cell] of points
    std::vector<double>              totals;  // [cell]
    std::vector<unsigned int>        main;
    std::vector<char>                mixed;
    std::vector<double>              densities;
    Vector                           node_density;
  };
} // namespace seiche

#endif
