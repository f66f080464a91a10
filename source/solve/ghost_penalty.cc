// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/ghost_penalty.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;
  } // namespace

  template <int dim>
  GhostPenalty<dim>::GhostPenalty(const NodePattern<dim> &p)
    : pattern(p)
  {}

  template <int dim>
  void
  GhostPenalty<dim>::clear()
  {
    rows.clear();
    pairs.clear();
    first_pair.assign(1, 0);
  }

  template <int dim>
  void
  GhostPenalty<dim>::assemble(const std::vector<GhostFace> &faces,
                              const Coefficients           &coefficients)
  {
    start_rows(faces);
    std::tuple<GhostFaceMatrix<dim, 1>, GhostFaceMatrix<dim, 2>> matrices;
    for (const GhostFace &face : faces)
      with_degree(pattern.degree(face), [&](const auto degree) {
        auto &matrix = std::get<degree - 1>(matrices);
        matrix.evaluate(face, pattern.occupancy);
        add_face(matrix, coefficients(face, matrix.h, degree));
      });
    compress();
  }

  template <int dim>
  void
  GhostPenalty<dim>::start_rows(const std::vector<GhostFace> &faces)
  {
    clear();
    row_of_node.assign(pattern.occupancy.nodes.n_local(), none);
    const auto start_row = [&](const unsigned int node) {
      if (row_of_node[node] != none)
        return;
      row_of_node[node] = rows.size();
      rows.push_back(node);
      for (unsigned int entry = pattern.row_begin(node);
           entry < pattern.row_begin(node + 1);
           ++entry)
        pairs.push_back({entry, none, GhostCoefficients()});
      first_pair.push_back(pairs.size());
    };
    for (const GhostFace &face : faces)
      for (const unsigned int cell : {face.lower, face.upper})
        with_degree(pattern.degree(face), [&](const auto degree) {
          const auto nodes = pattern.occupancy.template unknowns<degree>(cell);
          for (unsigned int a = 0; a < Basis<dim, degree>::n_nodes; ++a)
            start_row(nodes[a]);
        });
  }

  template <int dim>
  template <int degree>
  void
  GhostPenalty<dim>::add_face(const GhostFaceMatrix<dim, degree> &face,
                              const GhostCoefficients            &coefficients)
  {
    constexpr unsigned int max_nodes = GhostFaceMatrix<dim, degree>::max_nodes;
    const unsigned int     n         = face.n_nodes;
    unsigned int order[max_nodes], columns[max_nodes], entries[max_nodes];
    const auto   column = [&](const unsigned int a) {
      return pattern.column_of_local(face.nodes[a]);
    };
    for (unsigned int a = 0; a < n; ++a) // insertion sort
      {
        unsigned int k = a;
        for (; k > 0 && column(order[k - 1]) > column(a); --k)
          order[k] = order[k - 1];
        order[k] = a;
      }
    for (unsigned int k = 0; k < n; ++k)
      columns[k] = column(order[k]);
    for (unsigned int a = 0; a < n; ++a)
      {
        const unsigned int node = face.nodes[a];
        pattern.find_entries(node, columns, n, entries);
        Pair *row = &pairs[first_pair[row_of_node[node]]];
        for (unsigned int k = 0; k < n; ++k)
          {
            const double B    = face.B[a][order[k]];
            Pair        &pair = row[entries[k] - pattern.row_begin(node)];
            pair.node         = face.nodes[order[k]];
            pair.sum.acceleration += coefficients.acceleration * B;
            pair.sum.velocity += coefficients.velocity * B;
            pair.sum.pressure += coefficients.pressure * B;
          }
      }
  }

  template <int dim>
  void
  GhostPenalty<dim>::compress()
  {
    unsigned int kept = 0, begin = 0;
    for (unsigned int row = 0; row < rows.size(); ++row)
      {
        for (unsigned int k = begin; k < first_pair[row + 1]; ++k)
          if (pairs[k].node != none)
            pairs[kept++] = pairs[k];
        begin               = first_pair[row + 1];
        first_pair[row + 1] = kept;
      }
    pairs.resize(kept);
  }

  template <int dim>
  void
  GhostPenalty<dim>::add_residual(const StepCoefficients &step,
                                  const Vector           &inertia_offset,
                                  const Vector           &rate_offset,
                                  const BlockVector      &solution,
                                  BlockVector            &residual) const
  {
    const double *u = solution.block(0).begin(), *a = inertia_offset.begin(),
                 *v     = rate_offset.begin();
    const bool    mixed = solution.n_blocks() == 2;
    const double *p     = mixed ? solution.block(1).begin() : nullptr;
    for (unsigned int row = 0; row < rows.size(); ++row)
      {
        double force[dim] = {}, volume = 0.;
        for (unsigned int k = first_pair[row]; k < first_pair[row + 1]; ++k)
          {
            const GhostCoefficients &sum  = pairs[k].sum;
            const unsigned int       node = pairs[k].node;
            for (unsigned int i = 0; i < dim; ++i)
              {
                const unsigned int dof = dim * node + i;
                force[i] +=
                  sum.acceleration * (step.inertia * u[dof] + a[dof]) +
                  sum.velocity * (step.rate * u[dof] + v[dof]);
              }
            if (mixed)
              volume += sum.pressure * p[node];
          }
        for (unsigned int i = 0; i < dim; ++i)
          residual.block(0).local_element(dim * rows[row] + i) += force[i];
        if (mixed)
          residual.block(1).local_element(rows[row]) += volume;
      }
  }

  template <int dim>
  void
  GhostPenalty<dim>::add_tangent(const StepCoefficients &step,
                                 BlockMatrix<dim>       &matrix) const
  {
    for (unsigned int row = 0; row < rows.size(); ++row)
      for (unsigned int k = first_pair[row]; k < first_pair[row + 1]; ++k)
        {
          const GhostCoefficients &sum = pairs[k].sum;
          matrix.add_pair(pairs[k].entry,
                          rows[row],
                          pairs[k].node,
                          sum.acceleration * step.inertia +
                            sum.velocity * step.rate,
                          sum.pressure);
        }
  }

  template class GhostPenalty<2>;
  template class GhostPenalty<3>;
} // namespace seiche
