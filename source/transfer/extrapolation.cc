// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/point_batch.h>
#include <seiche/transfer/extrapolation.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class Extrapolation
    {
    public:
      using Vector = typename GridState<dim>::Vector;
      using Shape  = Basis<dim, 1>;

      Extrapolation(const PointCloud<dim> &points,
                    const Fill<dim>       &grid_fill,
                    GridState<dim>        &state)
        : fill(grid_fill)
        , occupancy(grid_fill.occupancy)
        , cells_with_points(occupancy.nodes.partitioner())
        , count(occupancy.nodes.partitioner())
      {
        for (const unsigned int cell : occupancy.cells.occupied())
          if (points.n_points_in(cell) > 0 && !fill.is_spray(cell))
            for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
              cells_with_points.local_element(
                occupancy.nodes.of_cell(cell)[a]) += 1.;
        cells_with_points.compress(VectorOperation::add);
        cells_with_points.update_ghost_values();
        add_field(state.pressure_guess, 1);
        add_field(state.velocity_n, dim);
        if (state.acceleration_n.size() > 0)
          add_field(state.acceleration_n, dim);
      }

      void
      run()
      {
        const auto &locator = occupancy.locator;
        for (const unsigned int cell : occupancy.cells.occupied())
          {
            if (has_field(cell) || fill.is_spray(cell))
              continue;
            bool found = false;
            for (const unsigned int face : GeometryInfo<dim>::face_indices())
              found =
                add_from(locator.cells.neighbor(cell, face), cell) || found;
            if (!found)
              for (const unsigned int other :
                   locator.cells.vertex_neighbors(cell))
                add_from(other, cell);
          }
        count.compress(VectorOperation::add);
        for (Field &field : fields)
          divide(field);
      }

    private:
      struct Field
      {
        Vector      &values;
        Vector       sums;
        unsigned int n_components;
      };

      void
      add_field(Vector &values, const unsigned int n_components)
      {
        fields.push_back({values, Vector(values), n_components});
        fields.back().sums = 0.;
        fields.back().sums.zero_out_ghost_values();
      }

      /// Of component @p c at the vertices of a cell.
      void
      read(const Field       &field,
           const unsigned int c,
           const unsigned int cell,
           double            *values) const
      {
        double              at_nodes[HangingNodes<dim>::max_nodes];
        const unsigned int *nodes = occupancy.nodes.of_cell(cell);
        for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
          at_nodes[a] =
            field.values.local_element(field.n_components * nodes[a] + c);
        occupancy.expand(cell, at_nodes);
        for (unsigned int v = 0; v < Shape::n_nodes; ++v)
          values[v] = at_nodes[vertex_node<dim>(occupancy.fe.degree, v)];
      }

      unsigned int
      vertex(const unsigned int cell, const unsigned int v) const
      {
        return occupancy.nodes.of_cell(
          cell)[vertex_node<dim>(occupancy.fe.degree, v)];
      }

      bool
      is_known(const unsigned int node) const
      {
        return cells_with_points.local_element(node) > 0.;
      }

      bool
      has_field(const unsigned int cell) const
      {
        for (unsigned int v = 0; v < Shape::n_nodes; ++v)
          if (!is_known(vertex(cell, v)))
            return false;
        return true;
      }

      /// False if @p donor has no field to continue.
      bool
      add_from(const unsigned int donor, const unsigned int cell)
      {
        if (donor == CellLocator<dim>::invalid ||
            !occupancy.cells.is_occupied(donor) || !has_field(donor))
          return false;
        PointBatch<dim, 1, double> at[Shape::n_nodes];
        double                     values[Shape::n_nodes];
        for (unsigned int v = 0; v < Shape::n_nodes; ++v)
          if (const unsigned int node = vertex(cell, v); !is_known(node))
            {
              count.local_element(node) += 1.;
              at[v].reinit_values(
                occupancy.locator.cells.geometry(donor).to_unit(
                  occupancy.locator.image(occupancy.nodes.position(node),
                                          donor)));
            }
        for (Field &field : fields)
          for (unsigned int c = 0; c < field.n_components; ++c)
            {
              read(field, c, donor, values);
              for (unsigned int v = 0; v < Shape::n_nodes; ++v)
                if (const unsigned int node = vertex(cell, v); !is_known(node))
                  field.sums.local_element(field.n_components * node + c) +=
                    at[v].value(values);
            }
        return true;
      }

      /// Means in place of the values that do not exist.
      void
      divide(Field &field)
      {
        field.sums.compress(VectorOperation::add);
        for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
          if (const double n = count.local_element(node); n > 0.)
            for (unsigned int c = 0; c < field.n_components; ++c)
              {
                const unsigned int i          = field.n_components * node + c;
                field.values.local_element(i) = field.sums.local_element(i) / n;
              }
        field.values.update_ghost_values();
      }

      const Fill<dim>      &fill;
      const Occupancy<dim> &occupancy;
      Vector                cells_with_points, count; // of the nodes
      std::vector<Field>    fields;
    };
  } // namespace

  template <int dim>
  void
  extrapolate_fields(const PointCloud<dim> &points,
                     const Fill<dim>       &fill,
                     GridState<dim>        &state)
  {
    Extrapolation<dim>(points, fill, state).run();
  }

  template void
  extrapolate_fields(const PointCloud<2> &, const Fill<2> &, GridState<2> &);
  template void
  extrapolate_fields(const PointCloud<3> &, const Fill<3> &, GridState<3> &);
} // namespace seiche
