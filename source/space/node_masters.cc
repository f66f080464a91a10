// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/node_masters.h>
#include <seiche/utilities/compatibility.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_tools.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Index 0 ... degree of a lexicographic node in direction d.
    unsigned int
    place(const unsigned int node,
          const unsigned int d,
          const unsigned int degree)
    {
      unsigned int rest = node;
      for (unsigned int e = 0; e < d; ++e)
        rest /= degree + 1;
      return rest % (degree + 1);
    }

    /// Place of a node in a cell in halves of its edges.
    template <int dim>
    std::array<unsigned int, dim>
    halves(const unsigned int node, const unsigned int degree)
    {
      std::array<unsigned int, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = place(node, d, degree) * 2 / degree;
      return result;
    }

    bool
    is_on(const unsigned int node,
          const BoxFace      face,
          const unsigned int degree)
    {
      return place(node, face.direction(), degree) ==
             (face.is_upper() ? degree : 0);
    }
  } // namespace



  template <int dim>
  void
  get_nodes(const DoFHandler<dim>                &dof_handler,
            const CellLocator<dim>               &locator,
            const unsigned int                    cell,
            std::vector<types::global_dof_index> &nodes)
  {
    const auto &fe = dof_handler.get_fe();
    static const std::array<std::vector<unsigned int>, 2> hierarchic = {
      {FETools::lexicographic_to_hierarchic_numbering<dim>(1),
       FETools::lexicographic_to_hierarchic_numbering<dim>(2)}};
    const typename DoFHandler<dim>::active_cell_iterator iterator(
      &dof_handler.get_triangulation(),
      locator.cells.iterator(cell)->level(),
      locator.cells.iterator(cell)->index(),
      &dof_handler);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    iterator->get_dof_indices(dofs);
    nodes.resize(dofs.size());
    for (unsigned int a = 0; a < nodes.size(); ++a)
      nodes[a] = dofs[hierarchic[fe.degree - 1][a]];
  }



  template <int dim>
  NodeMasters<dim>::NodeMasters(const DoFHandler<dim>  &dof_handler,
                                const CellLocator<dim> &locator)
    : hanging(compatibility::locally_relevant_dofs(dof_handler))
  {
    DoFTools::make_hanging_node_constraints(dof_handler, hanging);
    const bool any_seam = locator.grid.parameters.any_periodic();
    if (any_seam)
      add_hanging_at_seam(dof_handler, locator);
    hanging.close();
    if (any_seam)
      {
        find_twins(dof_handler, locator);
        share_unknowns(dof_handler, locator);
      }
  }



  template <int dim>
  typename NodeMasters<dim>::Weights
  NodeMasters<dim>::masters(const Node node) const
  {
    Weights result;
    for (const auto &[master, weight] :
         *hanging.get_constraint_entries(hanging_twin(node)))
      result.emplace_back(unknown(master), weight);
    return result;
  }



  template <int dim>
  void
  NodeMasters<dim>::add_hanging_at_seam(const DoFHandler<dim>  &dof_handler,
                                        const CellLocator<dim> &locator)
  {
    const auto        &fe     = dof_handler.get_fe();
    const unsigned int degree = fe.degree;
    const auto         hierarchic =
      FETools::lexicographic_to_hierarchic_numbering<dim>(degree);
    std::vector<Node> fine, coarse;
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      for (const BoxFace face : GeometryInfo<dim>::face_indices())
        {
          if (!locator.lattice.at_seam(cell, face))
            continue;
          const unsigned int other = locator.cells.neighbor(cell, face);
          if (other == locator.invalid ||
              locator.cells.level(other) == locator.cells.level(cell))
            continue;
          get_nodes(dof_handler, locator, cell, fine);
          get_nodes(dof_handler, locator, other, coarse);
          const auto         origin = locator.lattice.place(other, {});
          const unsigned int size   = 2 * locator.lattice.size(other);
          for (unsigned int a = 0; a < fine.size(); ++a)
            {
              if (!is_on(a, face, degree) || hanging.is_constrained(fine[a]))
                continue;
              const auto here =
                locator.lattice.place(cell, halves<dim>(a, degree));
              Point<dim> unit; // of the coarse cell, on the opposite face
              for (unsigned int d = 0; d < dim; ++d)
                {
                  // 0 stands for the other end, too
                  const double upper =
                    here[d] < origin[d] ? origin[d] + size : here[d];
                  unit[d] = d == face.direction() ? !face.is_upper() :
                                                    (upper - origin[d]) / size;
                }
              Weights weights;
              for (unsigned int b = 0; b < coarse.size(); ++b)
                if (is_on(b, face.opposite(), degree))
                  if (const double N = fe.shape_value(hierarchic[b], unit);
                      std::abs(N) > 1e-12)
                    weights.emplace_back(coarse[b], N);
              if (weights.size() == 1)
                continue; // they coincide
              hanging.add_line(fine[a]);
              for (const auto &[master, weight] : weights)
                hanging.add_entry(fine[a], master, weight);
            }
        }
  }



  template <int dim>
  void
  NodeMasters<dim>::find_twins(const DoFHandler<dim>  &dof_handler,
                               const CellLocator<dim> &locator)
  {
    const unsigned int degree = dof_handler.get_fe().degree;
    std::map<std::array<unsigned int, dim>, std::vector<Node>> at_place;
    std::vector<Node>                                          nodes;
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      {
        if (!locator.lattice.at_seam(cell))
          continue;
        get_nodes(dof_handler, locator, cell, nodes);
        for (unsigned int a = 0; a < nodes.size(); ++a)
          for (const BoxFace face : GeometryInfo<dim>::face_indices())
            if (locator.lattice.at_seam(cell, face) && is_on(a, face, degree))
              at_place[locator.lattice.place(cell, halves<dim>(a, degree))]
                .push_back(nodes[a]);
      }
    for (auto &entry : at_place)
      {
        auto &twins = entry.second;
        std::sort(twins.begin(), twins.end());
        const auto hangs =
          std::find_if(twins.begin(), twins.end(), [&](const Node node) {
            return hanging.is_constrained(node);
          });
        for (const Node node : twins)
          seam[node] = {twins.front(), hangs == twins.end() ? node : *hangs};
      }
  }



  template <int dim>
  void
  NodeMasters<dim>::share_unknowns(const DoFHandler<dim>  &dof_handler,
                                   const CellLocator<dim> &locator)
  {
    // doubles hold integers up to 2^53
    LinearAlgebra::distributed::Vector<double> numbers(
      dof_handler.locally_owned_dofs(),
      compatibility::locally_relevant_dofs(dof_handler),
      locator.grid.triangulation.get_communicator());
    for (const Node node : dof_handler.locally_owned_dofs())
      numbers(node) = static_cast<double>(unknown(node));
    numbers.update_ghost_values();
    for (const Node node : compatibility::locally_relevant_dofs(dof_handler))
      if (const Node number = static_cast<Node>(numbers(node)); number != node)
        seam.try_emplace(node, Twins{number, node}).first->second.unknown =
          number;
  }



  template class NodeMasters<2>;
  template class NodeMasters<3>;
  template void
  get_nodes(const DoFHandler<2> &,
            const CellLocator<2> &,
            const unsigned int,
            std::vector<types::global_dof_index> &);
  template void
  get_nodes(const DoFHandler<3> &,
            const CellLocator<3> &,
            const unsigned int,
            std::vector<types::global_dof_index> &);
} // namespace seiche
