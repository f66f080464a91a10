// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_scene_from_text_h
#define tests_unit_scene_from_text_h

#include <seiche/parameters/input_file.h>
#include <seiche/points/seeding.h>
#include <seiche/scene/background_grid.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "verdict.h"

/// The items on one line, from the first rank.
template <typename... T>
void
print(const T &...items)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      (std::cout << ... << items);
      std::cout << std::endl;
    }
}

/// The place with the same coordinate in all directions.
template <int dim>
std::string
corner(const std::string &coordinate)
{
  std::string text = coordinate;
  for (unsigned int d = 1; d < dim; ++d)
    text += ", " + coordinate;
  return text;
}

/// The materials of a scene with one, inviscid, of this density [kg/m^3].
inline std::vector<seiche::Material>
material_of_density(const double density)
{
  return {{"", density, seiche::make_viscosity_laws().front().law}};
}

/// A parameter file with the text of a test; one per rank.
inline std::string
file_with(const std::string &text)
{
  const std::string name =
    "scene" +
    std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
    ".prm";
  std::ofstream(name) << text;
  return name;
}

/// Grid, fluid bodies and points of a scene, as the program makes them.
template <int dim>
struct SceneFromText
{
  explicit SceneFromText(const std::string &text)
    : input(file_with("set Dimension = " + std::to_string(dim) + "\n" + text),
            {})
    , grid_parameters(input)
  {
    std::vector<seiche::FluidBodyParameters<dim>> entries;
    for (const std::string &name : input.instances("Fluid body"))
      {
        entries.emplace_back(name);
      }
    std::vector<seiche::ShapeParameters<dim>> shapes;
    for (const std::string &name : input.instances("Shape"))
      shapes.emplace_back("Shape " + name);
    dealii::ParameterHandler prm;
    seiche::InputFile::declare_dimension(prm);
    grid_parameters.add_parameters(prm);
    seeding.add_parameters(prm);
    for (auto &body : entries)
      body.add_parameters(prm);
    for (auto &shape : shapes)
      shape.add_subsection(prm);
    input.parse_into(prm);
    grid_parameters.check(input);
    seeding.check(input);
    if (!entries.empty())
      bodies = seiche::make_fluid_bodies(
        entries, input, grid_parameters.domain(), shapes, {});
  }

  seiche::InputFile                   input;
  seiche::GridParameters<dim>         grid_parameters;
  seiche::SeedingParameters           seeding;
  std::vector<seiche::FluidBody<dim>> bodies;
};

/// A scene with grid and points, of one material of a density [kg/m^3].
template <int dim>
struct SeededScene
{
  SeededScene(const std::string                   &text,
              const double                         density,
              const std::set<seiche::PointColumn> &columns = {},
              const MPI_Comm communicator                  = MPI_COMM_WORLD)
    : scene(text)
    , grid(scene.grid_parameters, communicator)
    , locator(grid)
    , points(locator, columns, communicator)
    , result(seiche::seed_bodies(scene.seeding,
                                 scene.bodies,
                                 scene.input,
                                 material_of_density(density),
                                 points))
  {}

  const SceneFromText<dim>    scene;
  seiche::BackgroundGrid<dim> grid;
  seiche::CellLocator<dim>    locator;
  seiche::PointCloud<dim>     points;
  const seiche::SeedingResult result;
};

/// Prints the message of the InputError that the action throws.
template <typename Action>
void
print_input_error(const Action &action)
{
  try
    {
      action();
      std::cout << "accepted" << std::endl;
    }
  catch (const seiche::InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

#endif
