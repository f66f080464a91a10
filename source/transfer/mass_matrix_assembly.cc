// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/ghost_face_matrix.h>
#include <seiche/mesh/assembled_faces.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/mass_matrix.h>

// The part of MassMatrix that assembles it.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// As gamma_a of the ghost penalty on accelerations, with which it shares
    /// the scale rho h^3, near the surface. Elsewhere less: clusters and gaps
    /// of the points leave combinations of a cell's nodes free in full cells
    /// too.
    constexpr double ghost_factor = 0.1, inner_factor = 0.01;
  } // namespace

  template <int dim>
  MassMatrix<dim>::MassMatrix(const PointCloud<dim>    &cloud,
                              const Fill<dim>          &grid_fill,
                              const CellMaterials<dim> &materials,
                              const bool                ghost_penalty,
                              const Field              *masses_of_linear_cells)
    : points(cloud)
    , fill(grid_fill)
    , occupancy(grid_fill.occupancy)
    , linear_masses(masses_of_linear_cells)
  {
    inverse_diagonal.reinit(occupancy.zero_components.exist() ? 2 : 1);
    for (unsigned int k = 0; k < inverse_diagonal.n_blocks(); ++k)
      inverse_diagonal.block(k).reinit(occupancy.nodes.vector_partitioner());
    inverse_diagonal.collect_sizes();
    occupancy.for_each_degree([&](const auto degree) {
      this->template collect_cells<degree>();
      this->template add_diagonals_of_edge_cells<degree>(inverse_diagonal);
    });
    if (ghost_penalty)
      with_degree(occupancy.fe.degree, [&](const auto degree) {
        this->template collect_faces<degree>(materials);
      });
    invert_diagonal();
  }

  template <int dim>
  void
  MassMatrix<dim>::invert_diagonal()
  {
    for (const Block &block : blocks)
      for (unsigned int a = 0; a < block.nodes.size(); ++a)
        for (unsigned int c = 0; c < dim; ++c)
          inverse_diagonal.block(0).local_element(dim * block.nodes[a] + c) +=
            block.factor * matrices[block.matrix][a * block.nodes.size() + a];
    inverse_diagonal.compress(VectorOperation::add);
    if (linear_masses != nullptr)
      inverse_diagonal += *linear_masses;
    for (unsigned int k = 0; k < inverse_diagonal.n_blocks(); ++k)
      for (unsigned int i = 0;
           i < inverse_diagonal.block(k).locally_owned_size();
           ++i)
        {
          double &value = inverse_diagonal.block(k).local_element(i);
          value         = value > 0. ? 1. / value : 0.;
        }
  }

  template <int dim>
  template <int degree>
  void
  MassMatrix<dim>::collect_cells()
  {
    PointBatch<dim, degree, double> point;
    constexpr unsigned int          n_nodes = point.n_nodes;
    const double                   *mass    = points.data(PointColumn::mass);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        if (occupancy.degree(cell) != degree || is_lumped(cell))
          continue;
        const auto &geometry = points.locator.cells.geometry(cell);
        double      matrix[n_nodes][n_nodes] = {};
        for (const std::size_t p : points.points_in(cell))
          {
            point.reinit_values(geometry.to_unit(points.position(p)));
            for (unsigned int a = 0; a < n_nodes; ++a)
              for (unsigned int b = 0; b < n_nodes; ++b)
                matrix[a][b] += mass[p] * point.N[a] * point.N[b];
          }
        const auto unknowns = occupancy.template unknowns<degree>(cell);
        if (unknowns.zeros == nullptr)
          unknowns.condense_matrix(matrix);
        const std::vector<double> values(&matrix[0][0],
                                         &matrix[0][0] + n_nodes * n_nodes);
        if (unknowns.zeros != nullptr)
          {
            edge_cells.push_back({cell, values});
            continue;
          }
        std::vector<unsigned int> nodes(n_nodes);
        for (unsigned int a = 0; a < n_nodes; ++a)
          nodes[a] = unknowns[a];
        blocks.push_back({nodes, matrices.size(), 1.});
        matrices.push_back(values);
      }
  }

  template <int dim>
  template <int degree>
  void
  MassMatrix<dim>::collect_faces(const CellMaterials<dim> &materials)
  {
    GhostFaceMatrix<dim, degree> face_matrix;
    // of faces between equal cells, by direction
    struct Last
    {
      CellGeometry<dim> geometry;
      std::size_t       matrix;
    };
    std::array<Last, dim> last;
    const auto geometry = [&](const unsigned int cell) -> const auto &
    {
      return occupancy.locator.cells.geometry(cell);
    };
    const auto is_plain = [&](const unsigned int cell) {
      return occupancy.template unknowns<degree>(cell).matrix == nullptr;
    };
    for_each_assembled_face(
      occupancy.locator,
      occupancy.cells.occupied(),
      [&](const unsigned int cell) {
        return occupancy.cells.is_occupied(cell);
      },
      [&](const unsigned int lower,
          const unsigned int upper,
          const unsigned int direction) {
        if (is_lumped(lower) && is_lumped(upper))
          return;
        const GhostFace face = {lower, upper, direction, /*fragment=*/false};
        const bool      is_regular = is_plain(lower) && is_plain(upper) &&
                                geometry(lower).is_congruent(geometry(upper));
        const bool is_known =
          is_regular && geometry(lower).is_congruent(last[direction].geometry);
        if (is_known)
          face_matrix.find_nodes(face, occupancy);
        else
          {
            face_matrix.evaluate(face, occupancy);
            matrices.push_back(face_matrix.dense());
          }
        if (is_regular && !is_known)
          last[direction] = {geometry(lower), matrices.size() - 1};
        const double factor =
          (fill.is_cut(lower) || fill.is_cut(upper) ? ghost_factor :
                                                      inner_factor) *
          materials.mean(lower, upper).mass(std::pow(face_matrix.h, 3));
        blocks.push_back(
          {{face_matrix.nodes, face_matrix.nodes + face_matrix.n_nodes},
           is_known ? last[direction].matrix : matrices.size() - 1,
           factor});
      });
  }

  template <int dim>
  template <int degree>
  void
  MassMatrix<dim>::add_diagonals_of_edge_cells(Field &diagonal) const
  {
    constexpr unsigned int n = Basis<dim, degree>::n_nodes;
    for (const EdgeCell &edge_cell : edge_cells)
      {
        if (occupancy.degree(edge_cell.cell) != degree)
          continue;
        const auto nodes = occupancy.template unknowns<degree>(edge_cell.cell);
        for (unsigned int k = 0; k < diagonal.n_blocks(); ++k)
          for (unsigned int c = 0; c < dim; ++c)
            {
              double matrix[n][n];
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int b = 0; b < n; ++b)
                  matrix[a][b] = nodes.is_zero(c, a) == (k == 1) &&
                                     nodes.is_zero(c, b) == (k == 1) ?
                                   edge_cell.values[a * n + b] :
                                   0.;
              nodes.condense_matrix(matrix);
              for (unsigned int a = 0; a < n; ++a)
                diagonal.block(k).local_element(dim * nodes[a] + c) +=
                  matrix[a][a];
            }
      }
  }

  template MassMatrix<2>::MassMatrix(const PointCloud<2> &,
                                     const Fill<2> &,
                                     const CellMaterials<2> &,
                                     const bool,
                                     const MassMatrix<2>::Field *);
  template MassMatrix<3>::MassMatrix(const PointCloud<3> &,
                                     const Fill<3> &,
                                     const CellMaterials<3> &,
                                     const bool,
                                     const MassMatrix<3>::Field *);
} // namespace seiche
