// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/field_patches.h>
#include <seiche/postprocess/grid_output.h>
#include <seiche/space/point_batch.h>
#include <seiche/utilities/result_names.h>

#include <deal.II/base/geometry_info.h>

#include <deal.II/grid/reference_cell.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// A row of a patch whose values are given at the vertices alone.
    template <int dim>
    void
    interpolate_from_vertices(const Occupancy<dim> &occupancy,
                              Table<2, float>      &data,
                              const unsigned int    row)
    {
      PointBatch<dim, 1, double> point;
      double                     at_vertex[point.n_nodes];
      for (unsigned int v = 0; v < point.n_nodes; ++v)
        at_vertex[v] = data(row, vertex_node<dim>(occupancy.fe.degree, v));
      for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
        {
          point.reinit_values(unit_place<dim>(occupancy.fe.degree, a));
          data(row, a) = point.value(at_vertex);
        }
    }

    /// The fields' names, without patches.
    template <int dim>
    FieldPatches<dim, dim>
    make_fields(const StepView<dim> &view)
    {
      FieldPatches<dim, dim> grid(view.time, view.step);
      grid.add_vector("velocity [m/s]");
      grid.add_vector("displacement of the step [m]");
      grid.add_scalar("pressure [Pa]");
      grid.add_scalar("nodal fill [-]");
      grid.add_scalar("cell fill [-]");
      grid.add_scalar("inside share [-]");
      grid.add_scalar("cut [-]");
      if (view.fill.has_surface())
        grid.add_scalar("level set [cells]");
      return grid;
    }

    /// One patch for each own occupied cell.
    template <int dim>
    FieldPatches<dim, dim>
    make_patches(const StepView<dim>                   &view,
                 const typename GridState<dim>::Vector &pressure)
    {
      FieldPatches<dim, dim>  grid      = make_fields(view);
      const Fill<dim>        &fill      = view.fill;
      const Occupancy<dim>   &occupancy = view.occupancy;
      const CellLocator<dim> &locator   = occupancy.locator;
      const auto             &cells     = occupancy.cells.occupied();
      grid.patches.resize(cells.size());
      for (std::size_t k = 0; k < cells.size(); ++k)
        {
          const unsigned int       cell  = cells[k];
          DataOutBase::Patch<dim> &patch = grid.patches[k];
          const unsigned int      *nodes = occupancy.nodes.of_cell(cell);
          const unsigned int       n     = occupancy.nodes_per_cell();
          patch.patch_index              = k;
          patch.n_subdivisions           = occupancy.fe.degree;
          patch.reference_cell           = ReferenceCells::get_hypercube<dim>();
          patch.data.reinit(grid.n_rows(), n);
          std::vector<double> values(n); // lexicographic, as patches are
          const auto          set_row = [&](const unsigned int row,
                                   const auto        &vector,
                                   const unsigned int stride,
                                   const unsigned int component) {
            for (unsigned int a = 0; a < values.size(); ++a)
              values[a] = vector.local_element(stride * nodes[a] + component);
            occupancy.expand(cell, values.data());
            for (unsigned int v = 0; v < n; ++v)
              patch.data(row, v) = values[v];
          };
          for (unsigned int d = 0; d < dim; ++d)
            {
              set_row(d, view.state.velocity_np1, dim, d);
              set_row(dim + d, view.state.displacement(), dim, d);
            }
          set_row(2 * dim, pressure, 1, 0);
          const auto set_vertices = [&](const unsigned int row,
                                        const auto        &vector) {
            set_row(row, vector, 1, 0);
            if (occupancy.fe.degree > 1)
              interpolate_from_vertices(occupancy, patch.data, row);
          };
          set_vertices(2 * dim + 1, fill.nodal_fill());
          if (fill.has_surface())
            set_vertices(2 * dim + 5, fill.surface().level_set());
          for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell;
               ++v)
            patch.vertices[v] = locator.cells.geometry(cell).to_real(
              GeometryInfo<dim>::unit_cell_vertex(v));
          for (unsigned int v = 0; v < n; ++v)
            {
              patch.data(2 * dim + 2, v) = fill.cell_fill(cell);
              patch.data(2 * dim + 3, v) = fill.inside_share(cell);
              patch.data(2 * dim + 4, v) = fill.is_cut(cell);
            }
        }
      return grid;
    }
  } // namespace

  template <int dim>
  GridOutput<dim>::GridOutput(
    const FrameSettings                       &settings,
    const std::shared_ptr<NodalPressure<dim>> &nodal_pressure,
    const MPI_Comm                             communicator)
    : series(result_names::grid, settings, communicator)
    , pressure(nodal_pressure)
  {}

  template <int dim>
  void
  GridOutput<dim>::execute(const StepView<dim> &view,
                           StatisticsTable & /*statistics*/)
  {
    if (series.due(view.time))
      series.write_vtu(view.time, make_patches(view, pressure->field(view)));
  }

  template <int dim>
  void
  GridOutput<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("grid frames", [&]() {
      series.save_or_load(archive, {".vtu", ".pvtu"});
    });
  }

  template class GridOutput<2>;
  template class GridOutput<3>;
} // namespace seiche
