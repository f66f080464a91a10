// SPDX-License-Identifier: LGPL-2.1-or-later
// Periodic sides: cells across the seam are neighbours, positions beyond it are
// found, nodes on it are one, fields of any nodal values are continuous across
// it, also at level jumps. Same output on any number of ranks.
#include <seiche/grid/mesh_adaptation.h>
#include <seiche/space/occupancy.h>

#include <set>

#include "global_reductions.h"
#include "scene_from_text.h"

namespace
{
  using namespace seiche;
  using dealii::Point;

  /// Periodic along all directions but the last; fluid in the corners of the
  /// box, finer there, and coarser cells everywhere else.
  template <int dim>
  std::string
  scene_text()
  {
    return "subsection Grid\n set Lower corner = " + corner<dim>("-0.3") +
           "\n set Upper corner = " + corner<dim>("1.3") +
           "\n set Cell size = 0.2\nend\n"
           "subsection Walls\n set Left = periodic\n set Right = periodic\n" +
           (dim == 3 ? " set Front = periodic\n set Back = periodic\n" : "") +
           "end\n"
           "subsection Fluid body a\n set Lower corner = " +
           corner<dim>("0.5") + "\n set Upper corner = " + corner<dim>("1.3") +
           "\nend\n"
           "subsection Points\n set Per cell and direction = 2\nend\n"
           "subsection Refinement surface\n set Criterion = free surface\n"
           "set Level = 1\nend\n"
           "subsection Refinement box\n set Criterion = box\n"
           "set Lower corner = " +
           corner<dim>("1.12") +
           "\n set Upper corner = " + corner<dim>("1.27") +
           "\n set Level = 2\nend\n";
  }

  /// A field without any symmetry: its values are those of an arbitrary
  /// function of the node's position, which is the same on all ranks.
  template <int dim>
  double
  rough(const Point<dim> &x)
  {
    double sum = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      sum += (17. + 6. * d) * x[d];
    return std::sin(sum);
  }

  template <int dim, int degree>
  double
  value(const Occupancy<dim>                  &occupancy,
        const typename Occupancy<dim>::Vector &field,
        const unsigned int                     cell,
        const Point<dim>                      &x)
  {
    using Shape = Basis<dim, degree>;
    double      N[Shape::n_nodes], at[Shape::n_nodes], sum = 0.;
    const auto &locator = occupancy.locator;
    Shape::values(locator.cells.geometry(cell).to_unit(locator.image(x, cell)),
                  N);
    for (unsigned int a = 0; a < Shape::n_nodes; ++a)
      at[a] = field.local_element(occupancy.nodes.of_cell(cell)[a]);
    occupancy.expand(cell, at);
    for (unsigned int a = 0; a < Shape::n_nodes; ++a)
      sum += N[a] * at[a];
    return sum;
  }

  /// Largest jump of the field across faces of own cells, those at a seam and
  /// with level jumps among them.
  template <int dim, int degree>
  void
  test_continuity(const Occupancy<dim> &occupancy)
  {
    const auto                     &locator = occupancy.locator;
    typename Occupancy<dim>::Vector field(occupancy.nodes.partitioner());
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      field.local_element(i) = rough<dim>(occupancy.nodes.position(i));
    field.update_ghost_values();

    std::array<unsigned int, 2> n_seam{}; // without, with level jump
    double                      jump = 0.;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      for (unsigned int face = 0; face < 2 * dim; ++face)
        {
          const unsigned int other = locator.cells.neighbor(cell, face);
          if (other == locator.invalid || !occupancy.cells.is_active(cell) ||
              !occupancy.cells.is_active(other))
            continue;
          if (locator.lattice.at_seam(cell, face))
            ++n_seam[locator.cells.level(other) != locator.cells.level(cell)];
          for (unsigned int q = 0; q < (dim == 2 ? 3 : 9); ++q)
            {
              Point<dim> x = locator.cells.geometry(cell).lower;
              for (unsigned int d = 0, rest = q; d < dim; ++d)
                if (d == face / 2)
                  x[d] += (face % 2) * locator.cells.geometry(cell).edges[d];
                else
                  {
                    x[d] += (0.1 + 0.4 * (rest % 3)) *
                            locator.cells.geometry(cell).edges[d];
                    rest /= 3;
                  }
              jump =
                std::max(jump,
                         std::abs(
                           value<dim, degree>(occupancy, field, cell, x) -
                           value<dim, degree>(occupancy, field, other, x)));
            }
        }
    print("degree ",
          degree,
          ": faces at the seam ",
          global_sum(n_seam[0]),
          ", with a level jump ",
          global_sum(n_seam[1]),
          ", jump of a field: ",
          global_max(jump) < 1e-13 ? "none" : "yes");
  }

  template <int dim>
  void
  test_nodes(const Occupancy<dim> &occupancy)
  {
    const auto domain = occupancy.locator.lines.domain();
    double     volume = 0.;
    std::vector<std::array<double, dim>> own;
    bool                                 inside = true;
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      {
        volume += occupancy.nodes.volume(i);
        const Point<dim>        x = occupancy.nodes.position(i);
        std::array<double, dim> rounded;
        for (unsigned int d = 0; d < dim; ++d)
          {
            rounded[d] = std::round(1e6 * x[d]);
            inside =
              inside && (d + 1 == dim || x[d] < domain.upper_bound(d) - 1e-9);
          }
        own.push_back(rounded);
      }
    std::set<std::array<double, dim>> all;
    for (const auto &of_rank :
         dealii::Utilities::MPI::all_gather(communicator, own))
      all.insert(of_rank.begin(), of_rank.end());
    print("nodes ",
          occupancy.nodes.n_global(),
          ", at ",
          all.size(),
          " places, on upper sides: ",
          global_sum(inside ? 0u : 1u) == 0 ? "none" : "some",
          ", volume of active ones below that of the box: ",
          global_sum(volume) < domain.volume() * (1. + 1e-12) ? "yes" : "no");
  }

  template <int dim>
  void
  test_locator(const CellLocator<dim> &locator)
  {
    unsigned int wrong = 0;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        for (unsigned int face = 0; face < 2 * (dim - 1); ++face)
          {
            // from the middle of the cell to a little beyond the face
            Point<dim> x = locator.cells.geometry(cell).box().center();
            x[face / 2] += (face % 2 == 0 ? -0.51 : 0.51) *
                           locator.cells.geometry(cell).edges[face / 2];
            const unsigned int found = locator.find(x, cell);
            const auto         near  = locator.cells.vertex_neighbors(cell);
            wrong +=
              locator.cells.wall_at(cell, face) ||
              std::find(near.begin(), near.end(), found) == near.end() ||
              found != locator.find(x) ||
              !locator.cells.geometry(found).holds(
                locator.periods.wrapped(x)) ||
              locator.image(locator.periods.wrapped(x), cell).distance(x) >
                1e-12;
            const unsigned int other = locator.cells.neighbor(cell, face);
            wrong += other != locator.invalid && other != found;
          }
      }
    print("cells that miss a neighbour ", global_sum(wrong));
  }

  template <int dim>
  void
  test()
  {
    print(dim, "D");
    const SceneFromText<dim> scene(scene_text<dim>());
    BackgroundGrid<dim>      grid(scene.grid_parameters, communicator);
    CellLocator<dim>         locator(grid);
    PointCloud<dim>          points(locator, {}, communicator);
    seed_bodies(scene.seeding,
                scene.bodies,
                scene.input,
                material_of_density(1000.),
                points);
    MeshAdaptation<dim> adaptation(grid,
                                   locator,
                                   points,
                                   /*gauss_in_full_cells=*/true);
    print("cells ", grid.triangulation.n_global_active_cells());
    test_locator(locator);
    for (const unsigned int degree : {1, 2})
      {
        Occupancy<dim> occupancy(locator, degree);
        occupancy.update(points);
        if (degree == 1)
          {
            test_nodes(occupancy);
            test_continuity<dim, 1>(occupancy);
          }
        else
          {
            test_continuity<dim, 2>(occupancy);
            std::vector<char> linear(locator.cells.n_owned());
            for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
              linear[cell] =
                locator.cells.geometry(cell).box().center()[dim - 1] > 0.9;
            occupancy.set_linear(linear);
            print("some cells linear:");
            test_continuity<dim, 2>(occupancy);
          }
      }

    // once around, with the seam in the way
    double         way  = 0.;
    unsigned int   step = 0;
    Occupancy<dim> occupancy(locator, /*degree=*/1);
    for (; step < 40; ++step)
      {
        for (std::size_t p = 0; p < points.size(); ++p)
          for (unsigned int d = 0; d + 1 < dim; ++d)
            points.data(PointColumn::position, d)[p] += 0.04;
        way += 0.04;
        points.locate();
        if (adaptation.update(step + 1))
          occupancy.reinit();
        occupancy.update(points);
      }
    double error = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const Point<dim>       x = points.position(p);
        dealii::Tensor<1, dim> off;
        for (unsigned int d = 0; d < dim; ++d)
          off[d] = std::remainder(x[d] - 0.5125, /*spacing*/ 0.025);
        error = std::max(error, off.norm());
        for (unsigned int d = 0; d < dim; ++d)
          error = std::max(error, std::max(0.5 - x[d], x[d] - 1.3));
      }
    print("points ",
          points.n_global(),
          ", back at their places after ",
          std::lround(way / 1.6),
          " turn: ",
          global_max(error) < 1e-12 ? "yes" : "no",
          ", cells ",
          grid.triangulation.n_global_active_cells());
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
