// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_cell_unknowns_h
#define seiche_space_cell_unknowns_h

#include <seiche/space/basis.h>
#include <seiche/space/node_matrix.h>

#include <array>
#include <cstdint>

namespace seiche
{
  /// Bit a of component c: something of the element's node a.
  template <int dim>
  using ComponentBits = std::array<std::uint32_t, dim>;

  /**
   * @brief The unknowns of a cell as those of an element of some degree, which
   * is that of the cell or of the mesh; lexicographic but for masters of
   * hanging nodes.
   *
   * Nodal values of a cell are arrays [n_nodes] or [dim][n_nodes] at the
   * element's own nodes. Of a vector field some components may be zero in this
   * cell alone, whatever the unknowns are (doc/theory.md (8.0c)).
   */
  template <int dim, int degree>
  struct CellUnknowns
  {
    static constexpr unsigned int n_nodes = Basis<dim, degree>::n_nodes;
    using NodalScalar                     = double[n_nodes];
    using NodalVector                     = double[dim][n_nodes];

    const unsigned int *list;
    const std::uint8_t *places; ///< in the list; null: one after the other
    const NodeMatrix   *matrix; ///< null: identity
    const ComponentBits<dim> *zeros = nullptr; ///< null: none

    unsigned int
    place(const unsigned int a) const
    {
      return places != nullptr ? places[a] : a;
    }

    /// Local node.
    unsigned int
    operator[](const unsigned int a) const
    {
      return list[place(a)];
    }

    bool
    is_zero(const unsigned int component, const unsigned int a) const
    {
      return zeros != nullptr && (((*zeros)[component] >> a) & 1u) != 0;
    }

    /// f(component, node of the element) for the components that are zero.
    template <typename Function>
    void
    for_each_zero(const Function &f) const
    {
      if (zeros != nullptr)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int a = 0; a < n_nodes; ++a)
            if (is_zero(c, a))
              f(c, a);
    }

    /// Values at the element's own nodes from those at the unknowns.
    void
    expand(double *values) const
    {
      if (matrix != nullptr)
        matrix->expand(values);
    }

    /// The transpose.
    void
    condense(double *values) const
    {
      if (matrix != nullptr)
        matrix->condense(values);
    }

    /// matrix <- C^T matrix C
    void
    condense_matrix(double (&values)[n_nodes][n_nodes]) const
    {
      if (matrix != nullptr)
        matrix->condense_matrix(values);
    }

    /// Nodal values of a field, of which ghost values are known: @p field is
    /// its first own entry.
    void
    read(const double *field, NodalScalar &values) const
    {
      for_each_node([&](const unsigned int a, const unsigned int node) {
        values[a] = field[node];
      });
      expand(values);
    }
    void
    read(const double *field, NodalVector &values) const
    {
      read_nodes(field, values);
      for_each_zero(
        [&](const unsigned int c, const unsigned int a) { values[c][a] = 0.; });
    }

    /// The same with values of @p unseen instead of zeros.
    void
    read(const double *field, const double *unseen, NodalVector &values) const
    {
      read_nodes(field, values);
      if (zeros == nullptr)
        return;
      NodalVector others;
      read_nodes(unseen, others);
      for_each_zero([&](const unsigned int c, const unsigned int a) {
        values[c][a] = others[c][a];
      });
    }

    /// As if no component were zero in this cell alone.
    void
    read_nodes(const double *field, NodalVector &values) const
    {
      for_each_node([&](const unsigned int a, const unsigned int node) {
        for (unsigned int c = 0; c < dim; ++c)
          values[c][a] = field[dim * node + c];
      });
      for (unsigned int c = 0; c < dim; ++c)
        expand(values[c]);
    }

    /// Add sums over the cell to a field; they are condensed in place. What
    /// belongs to zero components is left out.
    void
    add(NodalScalar &values, double *field) const
    {
      condense(values);
      for_each_node([&](const unsigned int a, const unsigned int node) {
        field[node] += values[a];
      });
    }
    void
    add(NodalVector &values, double *field) const
    {
      for_each_zero(
        [&](const unsigned int c, const unsigned int a) { values[c][a] = 0.; });
      add_to_nodes(values, field);
    }

    /// Add what add() leaves out.
    void
    add_to_zeros(const NodalVector &values, double *field) const
    {
      if (zeros == nullptr)
        return;
      NodalVector left = {};
      for_each_zero([&](const unsigned int c, const unsigned int a) {
        left[c][a] = values[c][a];
      });
      add_to_nodes(left, field);
    }

    /// As if no component were zero in this cell alone.
    void
    add_to_nodes(NodalVector &values, double *field) const
    {
      for (unsigned int c = 0; c < dim; ++c)
        condense(values[c]);
      for_each_node([&](const unsigned int a, const unsigned int node) {
        for (unsigned int c = 0; c < dim; ++c)
          field[dim * node + c] += values[c][a];
      });
    }

  private:
    /// f(a, local node): no question at each node where there is no list.
    template <typename Function>
    void
    for_each_node(const Function &f) const
    {
      if (places == nullptr)
        for (unsigned int a = 0; a < n_nodes; ++a)
          f(a, list[a]);
      else
        for (unsigned int a = 0; a < n_nodes; ++a)
          f(a, list[places[a]]);
    }
  };
} // namespace seiche

#endif
