// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of MeshAdaptation that shares the mesh out among the ranks.
#include <seiche/grid/mesh_adaptation.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    // Work in units of a thousandth of a full cell's (doc/scaling.md). Nodes of
    // the surface have longer rows (ghost faces).
    constexpr unsigned int weight_of_empty_cell       = 1;
    constexpr unsigned int weight_of_cell             = 400;
    constexpr unsigned int weight_of_node             = 600;
    constexpr unsigned int weight_of_surface_node     = 1200;
    constexpr unsigned int weight_of_point            = 4; // transfers
    constexpr unsigned int weight_of_quadrature_point = 41;

    constexpr double tolerated_imbalance = 1.1;
  } // namespace

  template <int dim>
  unsigned int
  MeshAdaptation<dim>::weight(const unsigned int cell) const
  {
    if (!holds_fluid[cell])
      return weight_of_empty_cell;
    const unsigned int work_of_point =
      weight_of_point + (gauss_in_full_cells ? 0 : weight_of_quadrature_point);
    const double work_of_nodes =
      at_surface[cell] ? weight_of_surface_node * nodes(cell) : weight_of_node;
    return weight_of_cell + static_cast<unsigned int>(work_of_nodes) +
           points.n_points_in(cell) * work_of_point;
  }

  template <int dim>
  double
  MeshAdaptation<dim>::nodes(const unsigned int cell) const
  {
    // between 2^dim for a cell alone and one inside; 1.43 at a plane surface
    // in 3D (exact: 1.5)
    constexpr double   alone = 1 << dim;
    constexpr double   most  = dim == 2 ? 8. : 26.;
    const auto         all   = locator.cells.vertex_neighbors(cell);
    const unsigned int n =
      std::count_if(all.begin(), all.end(), [&](const unsigned int c) {
        return holds_fluid[c];
      });
    return alone / (1. + (alone - 1.) * std::min(1., n / most));
  }

  template <int dim>
  double
  MeshAdaptation<dim>::imbalance()
  {
    find_fluid(); // it may have moved since the mesh was last adapted
    return imbalance_of_weights();
  }

  template <int dim>
  double
  MeshAdaptation<dim>::imbalance_of_weights() const
  {
    double own = 0.;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      own += weight(cell);
    return Utilities::MPI::max(own, communicator) *
           Utilities::MPI::n_mpi_processes(communicator) /
           Utilities::MPI::sum(own, communicator);
  }

  template <int dim>
  bool
  MeshAdaptation<dim>::share_out(const bool at_once)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1 ||
        (!at_once && imbalance_of_weights() <= tolerated_imbalance))
      return false;
    // a rank's cells are one run of the space-filling curve
    const auto own_cells = [&]() {
      return std::make_pair(locator.cells.n_owned(),
                            locator.cells.n_owned() > 0 ?
                              locator.cells.iterator(0)->id().to_string() :
                              std::string());
    };
    const auto before = own_cells();

    // the forest takes the points along with their cells
    using ActiveCell  = typename Triangulation<dim>::active_cell_iterator;
    const auto handle = grid.triangulation.register_data_attach(
      [&](const auto &cell, const auto) {
        return points.pack_cell(locator.cells.index(ActiveCell(cell)));
      },
      /*returns_variable_size_data=*/true);
    grid.repartition([&](const auto &cell) {
      return weight(locator.cells.index(ActiveCell(cell)));
    });
    std::vector<char> packed;
    grid.triangulation.notify_ready_to_unpack(
      handle, [&](const auto &, const auto, const auto &bytes) {
        packed.insert(packed.end(), bytes.begin(), bytes.end());
      });
    locator.reinit();
    points.replace(packed);
    find_fluid();
    return Utilities::MPI::max(own_cells() != before ? 1 : 0, communicator) ==
           1;
  }

  template unsigned int
  MeshAdaptation<2>::weight(const unsigned int) const;
  template unsigned int
  MeshAdaptation<3>::weight(const unsigned int) const;
  template double
  MeshAdaptation<2>::imbalance();
  template double
  MeshAdaptation<3>::imbalance();
  template double
  MeshAdaptation<2>::imbalance_of_weights() const;
  template double
  MeshAdaptation<3>::imbalance_of_weights() const;
  template bool
  MeshAdaptation<2>::share_out(const bool);
  template bool
  MeshAdaptation<3>::share_out(const bool);
} // namespace seiche
