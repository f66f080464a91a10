// SPDX-License-Identifier: LGPL-2.1-or-later
// Grid lines, obstacles and walls; the refused grids.
#include <cmath>
#include <map>

#include "scene_from_text.h"

namespace
{
  using seiche::WallCondition;

  struct Wall
  {
    std::string   name;
    WallCondition condition;
    double        area; // [m^(dim-1)]

    bool
    operator==(const Wall &other) const
    {
      return name == other.name && condition == other.condition &&
             std::abs(area - other.area) < 1e-12;
    }
  };



  /// The segments of a direction, and whether they leave no gap.
  template <int dim>
  void
  describe_lines(const seiche::BackgroundGrid<dim> &grid, const unsigned int d)
  {
    const auto   domain  = grid.parameters.domain();
    double       end     = domain.lower_bound(d);
    unsigned int n       = 0;
    bool         gapless = true;
    std::cout << "  "
              << "xyz"[d] << ':';
    for (const auto &segment : grid.segments(d))
      {
        gapless &= segment.begin == end && segment.first == n;
        end = segment.end;
        n += segment.cells;
        std::cout << ' ' << segment.cells << " cells to " << segment.end
                  << " m,";
      }
    gapless &= end == domain.upper_bound(d) && n == grid.n_lattice_cells(d);
    std::cout << " no gaps: " << verdict(gapless) << std::endl;
  }



  template <int dim>
  void
  describe(const std::string       &name,
           const std::string       &text,
           const double             volume,
           const std::vector<Wall> &walls)
  {
    const SceneFromText<dim>          scene(text);
    const seiche::BackgroundGrid<dim> grid(scene.grid_parameters,
                                           MPI_COMM_WORLD);
    std::cout << dim << "D " << name << ": "
              << grid.triangulation.n_active_cells() << " cells, "
              << grid.triangulation.n_cells(0) << " coarse ones" << std::endl;
    for (unsigned int d = 0; d < dim; ++d)
      describe_lines(grid, d);

    std::map<unsigned int, double> area;
    double                         sum = 0.;
    for (const auto &cell : grid.triangulation.active_cell_iterators())
      {
        sum += cell->measure();
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face))
            area[cell->face(face)->boundary_id()] +=
              cell->face(face)->measure();
      }
    std::vector<Wall> found;
    for (const auto &[id, size] : area)
      found.push_back({grid.wall(id).name, grid.wall(id).condition, size});
    std::cout << "  volume: " << verdict(std::abs(sum - volume) < 1e-12)
              << ", names, conditions and areas of walls: "
              << verdict(found == walls) << std::endl;
  }



  std::string
  box(const std::string &more)
  {
    return "subsection Grid\n"
           "  set Lower corner = 0, 0\n"
           "  set Upper corner = 3.22, 3.0\n" +
           more;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  constexpr auto slip = WallCondition::slip, no_slip = WallCondition::no_slip,
                 open = WallCondition::open;
  describe<2>("box",
              box("set Break points x = 1.2\n set Cells x = 24, 40\n"
                  "set Cell size = 0.05\nend\n"),
              3.22 * 3.,
              {{"left", slip, 3.},
               {"right", slip, 3.},
               {"bottom", slip, 3.22},
               {"top", slip, 3.22}});
  describe<2>("weir",
              box(
                "set Cell size = 0.1\nend\n"
                "subsection Walls\n set Top = open\n set Left = no-slip\nend\n"
                "subsection Obstacle weir\n set Lower corner = 1.61, 0\n"
                "set Upper corner = 2.02, 0.5\n set Condition = no-slip\n"
                "end\n"),
              3.22 * 3. - 0.41 * 0.5,
              {{"left", no_slip, 3.},
               {"right", slip, 3.},
               {"bottom", slip, 3.22 - 0.41},
               {"top", open, 3.22},
               {"weir", no_slip, 0.41 + 2. * 0.5}});
  describe<3>("post",
              "subsection Grid\n set Lower corner = -1, 0, 0\n"
              "set Upper corner = 1, 1, 1\n set Cell size = 0.125\nend\n"
              "subsection Obstacle post\n set Lower corner = -0.25, 0.25, 0\n"
              "set Upper corner = 0.25, 0.75, 1\nend\n",
              2. - 0.25,
              {{"left", slip, 1.},
               {"right", slip, 1.},
               {"front", slip, 2.},
               {"back", slip, 2.},
               {"bottom", slip, 2. - 0.25},
               {"top", slip, 2. - 0.25},
               {"post", slip, 4. * 0.5}});

  const std::string obstacle = "end\nsubsection Obstacle a\n"
                               "set Lower corner = ";
  for (const std::string &more :
       {std::string("end\n"),
        std::string("set Cell size = 1e-5\nend\n"),
        std::string("set Cells x = 4, 4\n set Cell size = 0.1\nend\n"),
        std::string("set Cells x = 0\n set Cell size = 0.1\nend\n"),
        std::string("set Break points x = 2, 1\n set Cell size = 0.1\nend\n"),
        std::string("set Break points y = 3\n set Cell size = 0.1\nend\n"),
        std::string("set Break points y = a\n set Cell size = 0.1\nend\n"),
        "set Cell size = 0.1\n" + obstacle +
          "1, 1\n set Upper corner = 4, 2\nend\n",
        "set Cell size = 0.1\n" + obstacle +
          "1, 1\n set Upper corner = 2, 1\nend\n",
        "set Cell size = 0.1\n" + obstacle +
          "0, 0\n set Upper corner = 3.22, 3\nend\n"})
    print_input_error([&]() { const SceneFromText<2> scene(box(more)); });
  print_input_error([]() {
    const SceneFromText<2> scene("subsection Grid\n set Lower corner = 0, 0\n"
                                 "set Upper corner = 1, -1\n"
                                 "set Cell size = 0.1\nend\n");
  });
}
