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

    /// After all occupied cells are known. Collective.
    void
    update(const PointCloud<dim> &points);

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

    /// Mean density [kg/m^3] of an occupied own or ghost cell.
    double
    density(const unsigned int cell) const
    {
      return are_several() ? densities[cell] : materials[0].density;
    }

    /// Mean density [kg/m^3] of the occupied cells at an own node.
    double
    density_of_node(const unsigned int node) const
    {
      return are_several() ? node_density.local_element(node) :
                             materials[0].density;
    }

    /// Mean viscosity [Pa s] of an own occupied cell at a shear rate,
    /// @p gamma_square [1/s^2].
    double
    viscosity(const unsigned int cell, const double gamma_square) const;

    /// True if the viscosity of a cell does not depend on the shear rate.
    bool
    has_constant_viscosity() const
    {
      return constant_viscosity;
    }

    /// True if none has a viscosity.
    bool
    are_inviscid() const
    {
      return inviscid;
    }

    double
    largest_density() const
    {
      return heaviest;
    }

  private:
    void
    sum_points(const PointCloud<dim> &points);
    void
    fill_empty_cells();

    double &
    volume(const unsigned int material, const unsigned int cell)
    {
      return volumes[material][cell];
    }

    const std::vector<Material> &materials;
    const Occupancy<dim>        &occupancy;
    bool                         constant_viscosity = true, inviscid = true;
    double                       heaviest = 0.; // [kg/m^3]

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
