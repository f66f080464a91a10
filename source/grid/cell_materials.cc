// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/cell_materials.h>
#include <seiche/materials/viscous_stress.h>
#include <seiche/space/node_means.h>
#include <seiche/space/point_batch.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  CellMaterials<dim>::CellMaterials(
    const std::vector<Material> &scene_materials,
    const Occupancy<dim>        &grid_occupancy)
    : materials(scene_materials)
    , occupancy(grid_occupancy)
  {
    for (const Material &material : materials)
      {
        is_newtonian  = is_newtonian && material.law->is_constant;
        bound.density = std::max(bound.density, material.density);
      }
  }

  template <int dim>
  std::set<PointColumn>
  CellMaterials<dim>::columns(const std::vector<Material> &materials)
  {
    return materials.size() > 1 ? std::set<PointColumn>{PointColumn::material} :
                                  std::set<PointColumn>();
  }

  template <int dim>
  void
  CellMaterials<dim>::update(const PointCloud<dim> &points)
  {
    neglect_viscosities();
    if (!are_several())
      return;
    sum_points(points);
    fill_empty_cells();
    main.assign(occupancy.locator.cells.n_owned(), 0);
    mixed.assign(occupancy.locator.cells.n_owned(), 0);
    densities.assign(occupancy.locator.cells.size(), materials[0].density);
    totals.assign(occupancy.locator.cells.n_owned(), 0.);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        double       mass = 0., sum = 0.;
        unsigned int n_held = 0;
        for (unsigned int m = 0; m < materials.size(); ++m)
          {
            const double held = volumes[m][cell];
            mass += materials[m].density * held;
            sum += held;
            n_held += held > 0.;
            if (held > volumes[main[cell]][cell])
              main[cell] = m;
          }
        mixed[cell]  = n_held > 1;
        totals[cell] = sum;
        if (sum > 0.)
          densities[cell] = mass / sum;
      }
    occupancy.locator.cells.exchange_to_ghosts(densities);
    node_density = node_means(occupancy, [this](const unsigned int cell) {
      return densities[cell];
    });
    // nodes without fluid, which have no mass either
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      if (node_density.local_element(i) == 0.)
        node_density.local_element(i) = bound.density;
  }

  template <int dim>
  void
  CellMaterials<dim>::sum_points(const PointCloud<dim> &points)
  {
    volumes.assign(materials.size(),
                   std::vector<double>(occupancy.locator.cells.size(), 0.));
    const double *material = points.data(PointColumn::material);
    const double *initial  = points.data(PointColumn::initial_volume);
    for (const unsigned int cell : occupancy.cells.occupied())
      for (const std::size_t p : points.points_in(cell))
        volumes[material[p]][cell] += initial[p];
    for (auto &of_material : volumes)
      occupancy.locator.cells.exchange_to_ghosts(of_material);
  }

  template <int dim>
  void
  CellMaterials<dim>::fill_empty_cells()
  {
    const auto volumes_of_points = volumes;
    for (const unsigned int cell : occupancy.cells.occupied())
      if (!occupancy.cells.holds_points(cell))
        {
          // the one that there is most of: no mixture without points
          std::vector<double> around(materials.size(), 0.);
          for (const unsigned int neighbor :
               occupancy.locator.cells.vertex_neighbors(cell))
            for (unsigned int m = 0; m < materials.size(); ++m)
              around[m] += volumes_of_points[m][neighbor];
          const unsigned int most =
            std::max_element(around.begin(), around.end()) - around.begin();
          volumes[most][cell] = occupancy.locator.cells.geometry(cell).measure;
        }
  }

  template <int dim>
  void
  CellMaterials<dim>::update_viscosities(const Vector &velocity)
  {
    neglect_viscosities();
    if (!are_several() && is_newtonian)
      {
        bound.viscosity = materials[0].law->scale;
        return;
      }
    viscosities.assign(occupancy.locator.cells.size(), 0.);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        viscosities[cell] =
          viscosity(cell, is_newtonian ? 0. : shear_in(cell, velocity));
        bound.viscosity = std::max(bound.viscosity, viscosities[cell]);
      }
    occupancy.locator.cells.exchange_to_ghosts(viscosities);
    bound.viscosity = Utilities::MPI::max(
      bound.viscosity, occupancy.nodes.partitioner()->get_mpi_communicator());
  }

  template <int dim>
  double
  CellMaterials<dim>::shear_in(const unsigned int cell,
                               const Vector      &velocity) const
  {
    return with_degree(occupancy.degree(cell), [&](const auto degree) {
      PointBatch<dim, degree, double> centre;
      centre.reinit(occupancy.locator.cells.geometry(cell),
                    CellGeometry<dim>::unit_centre());
      double nodal[dim][centre.n_nodes];
      occupancy.template unknowns<degree>(cell).read(velocity.begin(), nodal);
      return gamma_square(shear_rate(centre.gradient(nodal)));
    });
  }

  template <int dim>
  double
  CellMaterials<dim>::viscosity(const unsigned int cell,
                                const double       gamma_square) const
  {
    if (!are_several())
      return materials[0].law->viscosity(gamma_square);
    double mean = 0.;
    for (unsigned int m = 0; m < materials.size(); ++m)
      if (const double held = share(m, cell); held > 0.)
        mean += held * materials[m].law->viscosity(gamma_square);
    return mean;
  }

  template class CellMaterials<2>;
  template class CellMaterials<3>;
} // namespace seiche
