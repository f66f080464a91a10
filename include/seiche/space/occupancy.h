// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_occupancy_h
#define seiche_space_occupancy_h

#include <seiche/space/basis.h>
#include <seiche/space/cell_unknowns.h>
#include <seiche/space/node_constraints.h>
#include <seiche/space/node_numbering.h>
#include <seiche/space/occupied_cells.h>
#include <seiche/space/zero_components.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

namespace seiche
{
  /**
   * @brief Where the fluid is on the grid: occupied cells, the nodes that exist
   * because of them, what holds these, and how fields look in a cell.
   *
   * The numbering of the whole mesh is known to MeshNodes and NodeNumbering.
   */
  template <int dim>
  class Occupancy
  {
  public:
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    Occupancy(const CellLocator<dim> &locator, const unsigned int degree);

    /// Number the full mesh; after each change of the mesh. Collective.
    void
    reinit();

    /// After the locator's grid lines have moved. Collective.
    void
    update_places();

    /// Find occupied cells; renumber if a point is outside the active cells.
    /// Collective.
    void
    update(const PointCloud<dim> &points);

    /// Fields are multilinear in own occupied cells with a true value, until
    /// the next update(); FE_Q(1): nothing changes. Collective.
    void
    set_linear(const std::vector<char> &flags);

    /// Degree of the fields in an own or ghost cell.
    unsigned int
    degree(const unsigned int cell) const
    {
      return linear_flag[cell] ? 1 : fe.degree;
    }

    unsigned int
    nodes_per_cell() const
    {
      return fe.n_dofs_per_cell();
    }

    /// Values at the cell's own nodes from those at nodes.of_cell(), in place.
    void
    expand(const unsigned int cell, double *values) const
    {
      if (cell_matrices[cell] != nullptr)
        cell_matrices[cell]->expand(values);
    }

    /// The transpose: sums over the cell, to be added at nodes.of_cell().
    void
    condense(const unsigned int cell, double *values) const
    {
      if (cell_matrices[cell] != nullptr)
        cell_matrices[cell]->condense(values);
    }

    /// f(std::integral_constant<int, degree>) for the degrees that cells have.
    template <typename Function>
    void
    for_each_degree(const Function &f) const
    {
      f(std::integral_constant<int, 1>());
      if (fe.degree == 2)
        f(std::integral_constant<int, 2>());
    }

    /// The unknowns of a cell as those of an element of this degree, which is
    /// degree(cell) or fe.degree.
    template <int degree>
    CellUnknowns<dim, degree>
    unknowns(const unsigned int cell) const
    {
      const ComponentBits<dim> *zeros = zero_components.in(cell, degree);
      if (degree == fe.degree)
        return {nodes.of_cell(cell), nullptr, cell_matrices[cell], zeros};
      const auto &vertices = mesh_nodes.linear_cells.vertices(cell);
      return {nodes.of_cell(cell),
              vertices.places.data(),
              vertices.matrix,
              zeros};
    }

    /// Smallest edge length of all cells [m].
    double
    smallest_extent() const
    {
      return smallest;
    }

    /// Values [2^dim] at the vertices of an active cell of a nodal vector whose
    /// shape functions are those of FE_Q(1) on the mesh, whatever elements the
    /// unknowns have (set_linear()): fills, level set. Own and ghost nodes must
    /// be there.
    template <typename VectorType>
    void
    vertex_values(const unsigned int cell,
                  const VectorType  &vector,
                  double            *values) const
    {
      // vertices have nodes, which the compiler cannot know: zeros, or it warns
      double              at_nodes[HangingNodes<dim>::max_nodes] = {};
      const unsigned int *numbers = nodes.of_cell(cell);
      for (unsigned int a = 0; a < nodes_per_cell(); ++a)
        at_nodes[a] = vector.local_element(numbers[a]);
      if (const NodeMatrix *hanging = mesh_nodes.hanging.matrix(cell))
        hanging->expand(at_nodes);
      for (unsigned int v = 0; v < (1u << dim); ++v)
        values[v] = at_nodes[vertex_node<dim>(fe.degree, v)];
    }

    /// The transpose: @p values [2^dim] of the vertices of an active cell, added
    /// to the vector's own and ghost nodes.
    template <typename VectorType>
    void
    add_vertex_values(const unsigned int cell,
                      const double      *values,
                      VectorType        &vector) const
    {
      double              at_nodes[HangingNodes<dim>::max_nodes] = {};
      const unsigned int *numbers = nodes.of_cell(cell);
      for (unsigned int v = 0; v < (1u << dim); ++v)
        at_nodes[vertex_node<dim>(fe.degree, v)] = values[v];
      if (const NodeMatrix *hanging = mesh_nodes.hanging.matrix(cell))
        hanging->condense(at_nodes);
      for (unsigned int a = 0; a < nodes_per_cell(); ++a)
        vector.local_element(numbers[a]) += at_nodes[a];
    }

    const CellLocator<dim> &locator;
    const dealii::FE_Q<dim> fe;

    MeshNodes<dim>     mesh_nodes;
    OccupiedCells<dim> cells;
    NodeNumbering<dim> nodes;
    /// All walls hold after update(), no component is zero in a cell alone.
    NodeConstraints<dim> constraints;
    ZeroComponents<dim>  zero_components;

  private:
    void
    find_smallest_extent();

    /// Matrices of the mesh alone.
    void
    reset_matrices();

    std::vector<const NodeMatrix *> cell_matrices; // null: identity
    std::vector<char>               linear_flag;   // own and ghost cells
    double                          smallest    = 0.;
    bool                            is_numbered = false;
  };
} // namespace seiche

#endif
