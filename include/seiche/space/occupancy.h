// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_occupancy_h
#define seiche_space_occupancy_h

#include <seiche/mesh/cell_locator.h>
#include <seiche/points/point_cloud.h>
#include <seiche/space/basis.h>
#include <seiche/space/cell_unknowns.h>
#include <seiche/space/node_constraints.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

namespace seiche
{
  /**
   * @brief The occupied part of the grid and its compact numbering of nodes.
   *
   * A cell is occupied if it holds a point or has an inside (occupy()), active
   * if it is occupied or at most two cells away from an occupied one at the
   * time of numbering (the halo). Only nodes of active cells exist for vectors,
   * matrices and solvers; the numbering lives until a point comes to the edge
   * of the halo. All fields share the nodes: component c of node i of a vector
   * field is entry dim*i + c. Local node indices: own nodes first, then ghosts.
   * Hanging nodes are no unknowns; their masters may lie on cells without
   * fluid.
   *
   * The numbering of the whole mesh is known to MeshNodes and this class.
   */
  template <int dim>
  class Occupancy
  {
  public:
    using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

    static constexpr unsigned int invalid = static_cast<unsigned int>(-1);

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

    /// Own active cells without points that are occupied as well, until the
    /// next update(). Collective.
    void
    occupy(const std::vector<unsigned int> &cells);

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

    /// Grows by one with each new numbering.
    unsigned int
    generation() const
    {
      return numbering_generation;
    }

    unsigned int
    nodes_per_cell() const
    {
      return fe.n_dofs_per_cell();
    }

    /// Own occupied cells, ascending local numbers.
    const std::vector<unsigned int> &
    occupied_cells() const
    {
      return occupied;
    }

    /// For own and ghost cells.
    bool
    is_occupied(const unsigned int cell) const
    {
      return occupied_flag[cell];
    }

    /// The same without those of occupy().
    bool
    holds_points(const unsigned int cell) const
    {
      return points_flag[cell];
    }

    bool
    is_active(const unsigned int cell) const
    {
      return active_flag[cell];
    }

    /// Local node indices [nodes_per_cell()] of an active own or ghost cell,
    /// masters in place of hanging nodes (expand() after reading values,
    /// condense() before adding); lexicographic.
    const unsigned int *
    cell_nodes(const unsigned int cell) const
    {
      return compact_cell_nodes.data() + cell * nodes_per_cell();
    }

    /// Values at the cell's own nodes from those at cell_nodes(), in place.
    void
    expand(const unsigned int cell, double *values) const
    {
      if (cell_matrices[cell] != nullptr)
        cell_matrices[cell]->expand(values);
    }

    /// The transpose: sums over the cell, to be added at cell_nodes().
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
      if (degree == fe.degree)
        return {cell_nodes(cell), nullptr, cell_matrices[cell]};
      const auto &vertices = mesh_nodes.linear_cells.vertices(cell);
      return {cell_nodes(cell), vertices.places.data(), vertices.matrix};
    }

    /// Own and own-plus-ghost nodes of the compact numbering.
    unsigned int
    n_own_nodes() const
    {
      return n_own;
    }
    unsigned int
    n_local_nodes() const
    {
      return full_of_compact.size();
    }

    dealii::types::global_dof_index
    n_global_nodes() const
    {
      return node_partitioner->size();
    }

    /// Own occupied cells of all ranks.
    std::uint64_t
    n_global_occupied_cells() const
    {
      return global_occupied;
    }

    /// Layout of a scalar field and of a vector field with dim components.
    const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &
    scalar_partitioner() const
    {
      return node_partitioner;
    }
    const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &
    vector_partitioner() const
    {
      return vector_layout;
    }

    /// Integral of the node's hat function of FE_Q(1) over the whole domain
    /// [m^dim]: zero where no vertex of a cell lies.
    double
    node_volume(const unsigned int node) const
    {
      return mesh_nodes.volume(full_of_compact[node]);
    }

    /// Of an own node, or of a node of an own cell; on the lower side if it
    /// lies at a seam: CellLocator::image() is where a cell has it.
    const dealii::Point<dim> &
    node_position(const unsigned int node) const
    {
      return mesh_nodes.position(full_of_compact[node]);
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
      const unsigned int *nodes = cell_nodes(cell);
      for (unsigned int a = 0; a < nodes_per_cell(); ++a)
        at_nodes[a] = vector.local_element(nodes[a]);
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
      const unsigned int *nodes = cell_nodes(cell);
      for (unsigned int v = 0; v < (1u << dim); ++v)
        at_nodes[vertex_node<dim>(fe.degree, v)] = values[v];
      if (const NodeMatrix *hanging = mesh_nodes.hanging.matrix(cell))
        hanging->condense(at_nodes);
      for (unsigned int a = 0; a < nodes_per_cell(); ++a)
        vector.local_element(nodes[a]) += at_nodes[a];
    }

    const CellLocator<dim> &locator;
    const dealii::FE_Q<dim> fe;

    MeshNodes<dim> mesh_nodes;
    /// All walls hold after update().
    NodeConstraints<dim> constraints;

  private:
    void
    find_smallest_extent();

    /// Matrices of the mesh alone.
    void
    reset_matrices();

    /// Choose the active cells and number their nodes. Collective.
    void
    number();

    /// Occupied cells and those around them. Collective.
    void
    activate_cells();

    /// Compact numbers for the nodes that are @p used. Collective.
    void
    number_nodes(const std::vector<char> &used);

    /// Nodes of active cells, known to their owners and to those who need
    /// them. Collective.
    std::vector<char>
    find_used_nodes() const;

    std::vector<const NodeMatrix *> cell_matrices; // null: identity
    double                          smallest = 0.;

    // compact numbering
    bool                      is_numbered          = false;
    unsigned int              numbering_generation = 0;
    unsigned int              n_own                = 0;
    std::uint64_t             global_occupied      = 0;
    std::vector<unsigned int> occupied;
    std::vector<char>         points_flag, occupied_flag, active_flag;
    std::vector<char>         linear_flag; // own and ghost cells
    std::vector<unsigned int> compact_cell_nodes;
    std::vector<unsigned int> full_of_compact;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> node_partitioner;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> vector_layout;
  };
} // namespace seiche

#endif
