// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_node_matrix_h
#define seiche_space_node_matrix_h

#include <algorithm>
#include <map>
#include <vector>

namespace seiche
{
  /**
   * @brief A small matrix C that gives the values at a cell's own nodes from
   * those at a list of as many unknowns: v = C v^, R^ = C^T R, K^ = C^T K C
   * (doc/theory.md (4.8), (9.1)).
   *
   * Its row sums are one. Compressed rows, of which most have one entry.
   */
  class NodeMatrix
  {
  public:
    static constexpr unsigned int max_nodes = 27; ///< FE_Q(2) in 3D

    /// @p dense [n][n]
    NodeMatrix(const std::vector<double> &dense, const unsigned int n_nodes)
      : n(n_nodes)
      , begin_of_row(1, 0)
    {
      for (unsigned int a = 0; a < n; ++a)
        {
          for (unsigned int b = 0; b < n; ++b)
            if (dense[a * n + b] != 0.)
              {
                column.push_back(b);
                weight.push_back(dense[a * n + b]);
              }
          begin_of_row.push_back(column.size());
        }
    }

    /// values <- C values [n]
    void
    expand(double *values) const
    {
      double result[max_nodes];
      for (unsigned int a = 0; a < n; ++a)
        {
          result[a] = 0.;
          for (unsigned int k = begin_of_row[a]; k < begin_of_row[a + 1]; ++k)
            result[a] += weight[k] * values[column[k]];
        }
      std::copy(result, result + n, values);
    }

    /// values <- C^T values [n]
    void
    condense(double *values) const
    {
      double result[max_nodes] = {};
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int k = begin_of_row[a]; k < begin_of_row[a + 1]; ++k)
          result[column[k]] += weight[k] * values[a];
      std::copy(result, result + n, values);
    }

    /// matrix <- C^T matrix C
    template <unsigned int n_nodes>
    void
    condense_matrix(double (&matrix)[n_nodes][n_nodes]) const
    {
      double values[n_nodes];
      for (unsigned int b = 0; b < n_nodes; ++b)
        {
          for (unsigned int a = 0; a < n_nodes; ++a)
            values[a] = matrix[a][b];
          condense(values);
          for (unsigned int a = 0; a < n_nodes; ++a)
            matrix[a][b] = values[a];
        }
      for (unsigned int a = 0; a < n_nodes; ++a)
        condense(matrix[a]);
    }

    /// True if row a is that of the identity.
    bool
    is_free(const unsigned int a) const
    {
      return begin_of_row[a + 1] == begin_of_row[a] + 1 &&
             column[begin_of_row[a]] == a && weight[begin_of_row[a]] == 1.;
    }

    /// [n][n]
    std::vector<double>
    dense() const
    {
      std::vector<double> result(n * n, 0.);
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int k = begin_of_row[a]; k < begin_of_row[a + 1]; ++k)
          result[a * n + column[k]] = weight[k];
      return result;
    }

  private:
    const unsigned int        n;
    std::vector<unsigned int> begin_of_row, column;
    std::vector<double>       weight;
  };

  /// Different matrices of a mesh, each stored once; pointers stay valid until
  /// clear().
  class NodeMatrices
  {
  public:
    /// @p dense [n_nodes][n_nodes]
    const NodeMatrix *
    store(const std::vector<double> &dense, const unsigned int n_nodes)
    {
      return &known.try_emplace(dense, dense, n_nodes).first->second;
    }

    void
    clear()
    {
      known.clear();
    }

  private:
    std::map<std::vector<double>, NodeMatrix> known;
  };
} // namespace seiche

#endif
