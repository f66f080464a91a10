// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_node_means_h
#define seiche_space_node_means_h

#include <seiche/space/occupancy.h>

namespace seiche
{
  /// Means of value(cell) over the occupied cells at each own node, weighted by
  /// their measures; zero where there are none (of the density in doc/theory.md
  /// (2.1b)). Collective.
  template <int dim, typename Value>
  typename Occupancy<dim>::Vector
  node_means(const Occupancy<dim> &occupancy, const Value &value)
  {
    using Vector = typename Occupancy<dim>::Vector;
    Vector measures(occupancy.nodes.partitioner()),
      means(occupancy.nodes.partitioner());
    for (const unsigned int cell : occupancy.cells.occupied())
      for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
        {
          const unsigned int node = occupancy.nodes.of_cell(cell)[a];
          const double measure = occupancy.locator.cells.geometry(cell).measure;
          measures.local_element(node) += measure;
          means.local_element(node) += measure * value(cell);
        }
    measures.compress(dealii::VectorOperation::add);
    means.compress(dealii::VectorOperation::add);
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      if (measures.local_element(i) > 0.)
        means.local_element(i) /= measures.local_element(i);
    return means;
  }
} // namespace seiche

#endif
