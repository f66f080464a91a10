// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/basis.h>
#include <seiche/space/mesh_nodes.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  using Vector = LinearAlgebra::distributed::Vector<double>;

  namespace
  {
    template <int dim>
    void
    add_wall(std::vector<NodeWall>  &walls,
             const NodeWall         &wall,
             const CellLocator<dim> &locator)
    {
      for (auto &known : walls)
        if (known.wall == wall.wall && known.component == wall.component)
          {
            known.sides |= wall.sides;
            known.is_normal |= wall.is_normal;
            if (locator.cells.geometry(wall.cell).measure <
                locator.cells.geometry(known.cell).measure)
              known.cell = wall.cell;
            return;
          }
      walls.push_back(wall);
    }
  } // namespace

  template <int dim>
  MeshNodes<dim>::MeshNodes(const CellLocator<dim> &cell_locator,
                            const FE_Q<dim>        &element)
    : locator(cell_locator)
    , fe(element)
    , dof_handler(cell_locator.grid.triangulation)
  {}

  template <int dim>
  void
  MeshNodes<dim>::reinit()
  {
    dof_handler.distribute_dofs(fe);
    const NodeMasters<dim> masters(dof_handler, locator);
    hanging.reinit(dof_handler, locator, masters);
    if (fe.degree > 1)
      linear_cells.reinit(dof_handler, locator, masters, hanging);
    number_cells();
    update_places();
    find_walls();
  }

  template <int dim>
  void
  MeshNodes<dim>::update_places()
  {
    find_positions();
    cut_walls.reinit(*this);
    find_volumes();
  }

  template <int dim>
  void
  MeshNodes<dim>::number_cells()
  {
    // masters of a ghost cell's hanging nodes may lie beyond the ghost layer
    const unsigned int                   n_nodes = fe.n_dofs_per_cell();
    std::vector<types::global_dof_index> indices(
      hanging.nodes(0), hanging.nodes(0) + locator.cells.size() * n_nodes);
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    IndexSet relevant(dof_handler.n_dofs());
    relevant.add_indices(indices.begin(), indices.end());
    layout = std::make_shared<const Utilities::MPI::Partitioner>(
      dof_handler.locally_owned_dofs(),
      relevant,
      locator.grid.triangulation.get_communicator());

    cell_nodes.resize(locator.cells.size() * n_nodes);
    for (std::size_t i = 0; i < cell_nodes.size(); ++i)
      cell_nodes[i] = layout->global_to_local(hanging.nodes(0)[i]);
  }

  template <int dim>
  void
  MeshNodes<dim>::find_positions()
  {
    const unsigned int n_nodes = fe.n_dofs_per_cell();
    positions.assign(size(), Point<dim>());
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      for (unsigned int a = 0; a < n_nodes; ++a)
        if (!hanging.hangs(cell, a))
          {
            Point<dim> x = locator.cells.geometry(cell).to_real(
              unit_place<dim>(fe.degree, a));
            for (unsigned int d = 0; d < dim; ++d)
              if (line_index<dim>(fe.degree, a, d) == fe.degree &&
                  locator.lattice.at_seam(cell, {d, /*upper=*/true}))
                x[d] = locator.lines.domain().lower_bound(d);
            positions[cell_nodes[cell * n_nodes + a]] = x;
          }
  }

  template <int dim>
  void
  MeshNodes<dim>::find_walls()
  {
    const unsigned int n_nodes = fe.n_dofs_per_cell();
    Vector             mask(layout);
    walls_of_node.assign(size(), {});
    components_of_walls.assign(size(), 0);
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      for (const BoxFace face : GeometryInfo<dim>::face_indices())
        {
          const Wall<dim> *const wall =
            locator.cells.closed_wall_at(cell, face);
          if (wall == nullptr)
            continue;
          const bool all = wall->condition == WallCondition::no_slip;
          for (unsigned int a = 0; a < n_nodes; ++a)
            if (is_on_face<dim>(fe.degree, a, face) && !hanging.hangs(cell, a))
              for (unsigned int c = 0; c < dim; ++c)
                if (all || c == face.direction())
                  {
                    const unsigned int node = cell_nodes[cell * n_nodes + a];
                    components_of_walls[node] |= 1u << c;
                    add_wall<dim>(walls_of_node[node],
                                  {wall->number,
                                   c,
                                   face.is_upper() ? 2u : 1u,
                                   cell,
                                   c == face.direction()},
                                  locator);
                  }
        }
    // an owner sees all cells around its nodes, a ghost's copy may not
    for (unsigned int i = 0; i < layout->locally_owned_size(); ++i)
      mask.local_element(i) = components_of_walls[i];
    mask.update_ghost_values();
    for (unsigned int i = 0; i < components_of_walls.size(); ++i)
      components_of_walls[i] = static_cast<unsigned int>(mask.local_element(i));
  }

  template <int dim>
  void
  MeshNodes<dim>::find_volumes()
  {
    const unsigned int  n_nodes = fe.n_dofs_per_cell();
    constexpr double    hat     = 1. / GeometryInfo<dim>::vertices_per_cell;
    std::vector<double> integral(n_nodes), full_integral(n_nodes);
    Vector              volume(layout), full(layout), cut(layout);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        const VertexValues<dim> of_vertices = cut_walls.hat_integrals(cell);
        std::fill(integral.begin(), integral.end(), 0.);
        std::fill(full_integral.begin(), full_integral.end(), 0.);
        for (unsigned int v = 0; v < of_vertices.size(); ++v)
          {
            integral[vertex_node<dim>(fe.degree, v)]      = of_vertices[v];
            full_integral[vertex_node<dim>(fe.degree, v)] = hat;
          }
        if (const NodeMatrix *matrix = hanging.matrix(cell))
          {
            matrix->condense(integral.data());
            matrix->condense(full_integral.data());
          }
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            const unsigned int node = cell_nodes[cell * n_nodes + a];
            volume.local_element(node) +=
              locator.cells.geometry(cell).measure * integral[a];
            full.local_element(node) +=
              locator.cells.geometry(cell).measure * full_integral[a];
            cut.local_element(node) += cut_walls.cuts(cell);
          }
      }
    volume.compress(VectorOperation::add);
    volume.update_ghost_values();
    volumes.resize(size());
    for (unsigned int i = 0; i < volumes.size(); ++i)
      volumes[i] = volume.local_element(i);
    if (!cut_walls.exist())
      return;
    for (Vector *vector : {&cut, &full})
      {
        vector->compress(VectorOperation::add);
        vector->update_ghost_values();
      }
    at_cut_walls.resize(size());
    full_volumes.resize(size());
    for (unsigned int i = 0; i < size(); ++i)
      {
        at_cut_walls[i] = cut.local_element(i) > 0.;
        full_volumes[i] = full.local_element(i);
      }
  }

  template class MeshNodes<2>;
  template class MeshNodes<3>;
} // namespace seiche
