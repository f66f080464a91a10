// SPDX-License-Identifier: LGPL-2.1-or-later
// Grid lines, obstacles and walls; the refused grids.
#include <iomanip>
#include <map>

#include "scene_from_text.h"

namespace
{
  template <int dim>
  void
  describe(const std::string &text)
  {
    const SceneFromText<dim>          scene(text);
    const seiche::BackgroundGrid<dim> grid(scene.grid_parameters,
                                           MPI_COMM_WORLD);
    std::cout << dim << "D: " << grid.triangulation.n_cells(0)
              << " coarse cells, " << grid.triangulation.n_active_cells()
              << " cells, lattice";
    for (unsigned int d = 0; d < dim; ++d)
      std::cout << ' ' << grid.n_lattice_cells(d);
    std::cout << std::endl;
    for (unsigned int d = 0; d < dim; ++d)
      for (const auto &segment : grid.segments(d))
        std::cout << "  direction " << d << " from " << segment.begin << " to "
                  << segment.end << " cells " << segment.first << " + "
                  << segment.cells << std::endl;

    std::map<unsigned int, double> area;
    double                         volume = 0.;
    for (const auto &cell : grid.triangulation.active_cell_iterators())
      {
        volume += cell->measure();
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face))
            area[cell->face(face)->boundary_id()] +=
              cell->face(face)->measure();
      }
    std::cout << "  volume " << volume << std::endl;
    for (const auto &wall : area)
      std::cout << "  wall " << wall.first << ' ' << grid.wall_name(wall.first)
                << " condition "
                << static_cast<int>(grid.wall_condition(wall.first)) << " area "
                << wall.second << std::endl;
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
  std::cout << std::setprecision(10);

  describe<2>(box("set Break points x = 1.2\n set Cells x = 24, 40\n"
                  "set Cell size = 0.05\nend\n"));
  describe<2>(
    box("set Cell size = 0.1\nend\n"
        "subsection Walls\n set Top = open\n set Left = no-slip\nend\n"
        "subsection Obstacle weir\n set Lower corner = 1.61, 0\n"
        "set Upper corner = 2.02, 0.5\n set Condition = no-slip\n"
        "end\n"));
  describe<3>("subsection Grid\n set Lower corner = -1, 0, 0\n"
              "set Upper corner = 1, 1, 1\n set Cell size = 0.125\nend\n"
              "subsection Obstacle post\n set Lower corner = -0.25, 0.25, 0\n"
              "set Upper corner = 0.25, 0.75, 1\nend\n");

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
