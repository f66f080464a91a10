// SPDX-License-Identifier: LGPL-2.1-or-later
// Messages of InputFile for a small set of declarations.
#include <seiche/parameters/declarations.h>
#include <seiche/parameters/input_file.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <fstream>
#include <iostream>

namespace
{
  struct Scene
  {
    double                   density = 1., step = 0.1;
    int                      count     = 1;
    std::string              condition = "slip", shape = "box", text;
    std::vector<double>      list;
    std::vector<std::string> bodies, probes;

    explicit Scene(const seiche::InputFile &input)
      : bodies(input.instances("Fluid body"))
      , probes(input.instances("Probe"))
    {}

    void
    add_parameters(dealii::ParameterHandler &prm)
    {
      using namespace dealii::Patterns;
      prm.enter_subsection("Fluid");
      prm.add_parameter(
        "Density", density, "Density of the fluid [kg/m^3].", Double(0.), true);
      prm.leave_subsection();
      prm.enter_subsection("Time");
      prm.add_parameter("Step", step, "Step size [s].", Double(0., 1.));
      prm.add_parameter("Newton steps", count, "Most steps [-].", Integer(1));
      prm.leave_subsection();
      prm.enter_subsection("Walls");
      prm.add_parameter("Left",
                        condition,
                        "Condition on this wall.",
                        Selection("slip|no-slip|open"));
      prm.add_parameter("Lines", list, "Grid lines [m].");
      prm.leave_subsection();
      for (const std::string &body : bodies)
        {
          prm.enter_subsection("Fluid body " + body);
          prm.add_parameter("Shape", shape, "Shape.", Selection("box|ball"));
          prm.add_parameter("Velocity", text, "Velocity [m/s].");
          prm.leave_subsection();
        }
      for (const std::string &probe : probes)
        {
          prm.enter_subsection("Probe " + probe);
          prm.add_parameter("Position", text, "Position [m].");
          prm.leave_subsection();
        }
    }
  };

  void
  write(const std::string &name, const std::string &text)
  {
    std::ofstream(name) << text;
  }

  void
  read(const std::string &name, const std::vector<std::string> &overrides = {})
  {
    try
      {
        const seiche::InputFile  input(name, overrides);
        Scene                    scene(input);
        dealii::ParameterHandler prm;
        scene.add_parameters(prm);
        input.parse_into(prm);
        std::cout << "read: dimension " << input.dimension() << ", density "
                  << scene.density << ", left " << scene.condition << ", lines";
        for (const double value : scene.list)
          std::cout << ' ' << value;
        for (const std::string &body : scene.bodies)
          std::cout << ", body " << body << " with "
                    << input.value("Fluid body " + body + "/Velocity", "none");
        std::cout << std::endl;
        if (input.is_set("Time/Step"))
          std::cout << "step is set to " << scene.step << std::endl;
        input.require(scene.density < 1e5, "Fluid/Density", "too dense.");
        input.require(scene.step < 1., "Time/Step", "too long.");
      }
    catch (const seiche::InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
  }

  /// Read a text as a file of its own.
  void
  check(const std::string              &title,
        const std::string              &text,
        const std::vector<std::string> &overrides = {})
  {
    std::cout << "-- " << title << std::endl;
    write("dam.prm", text);
    read("dam.prm", overrides);
  }

  void
  accepted(const std::string &fluid)
  {
    check("plain", "set Dimension = 2\n" + fluid);
    check("all syntax",
          "\xEF\xBB\xBF# a comment with a backslash \\\r\nset Dimension=3\r\n"
          "subsection Walls # comment\r\n  set Lines = 1, \\\n    2, \\\n 3\n"
          "  set Left = open\nend\nsubsection Fluid body b\n"
          "  set Velocity = x^2; y=1\nend\nsubsection Fluid body a\nend\n" +
            fluid);
    check("overrides",
          "set Dimension = 2\n" + fluid,
          {"Walls/Left = no-slip",
           "Fluid/Density=7",
           "Fluid body new/Velocity = 1; 2"});
    write("water.inc", fluid);
    check("include and change",
          "set Dimension = 2\ninclude water.inc\nsubsection Fluid\n"
          "  set Density = 3\nend\n");
    check("a default written out",
          "set Dimension = 2\n" + fluid,
          {"Time/Step = 0.1", "Walls/Lines ="});
    check("later check",
          "set Dimension = 2\n" + fluid,
          {"Fluid/Density = 1e6"});
    check("later check of a default",
          "set Dimension = 2\nsubsection Time\nend\n" + fluid,
          {"Time/Step = 1"});
  }

  void
  unknown_names(const std::string &fluid)
  {
    check("unknown entry",
          "set Dimension = 2\nsubsection Fluid\n  set Densty = 3\nend\n");
    check("entry of another subsection",
          "set Dimension = 2\nset Density = 3\n" + fluid);
    check("far from all",
          "set Dimension = 2\nsubsection Walls\n set Colour = red\nend\n" +
            fluid);
    check("unknown subsection",
          "set Dimension = 2\nsubsection Wals\n  set Left = open\nend\n" +
            fluid);
    check("misspelt kind",
          "set Dimension = 2\nsubsection Fluid bdy column\n"
          "  set Shape = box\nend\n" +
            fluid);
    check("kind without name",
          "set Dimension = 2\nsubsection Probe\n  set Position = 1\nend\n" +
            fluid);
    check("unknown entry by --set",
          "set Dimension = 2\n" + fluid,
          {"Fluid/Viscosity = 1"});
  }

  void
  wrong_values(const std::string &fluid)
  {
    check("values",
          "set Dimension = 2\nsubsection Fluid\n  set Density = -5\nend\n"
          "subsection Walls\n  set Left = noslip\n  set Lines = 1; 2\nend\n"
          "subsection Time\n  set Step = 2\n  set Newton steps = 1.5\nend\n"
          "subsection Fluid body b\n  set Shape =\nend\n");
    check("no dimension", fluid);
    check("wrong dimension", "set Dimension = 4\n" + fluid);
    check("mandatory", "set Dimension = 2\nsubsection Fluid\n\nend\n");
    check("mandatory, empty",
          "set Dimension = 2\nsubsection Fluid\n set Density = \nend\n");
    check("set twice",
          "set Dimension = 2\n" + fluid + "subsection Fluid\n" +
            "  set Density = 2\nend\n");
    check(
      "override without =", "set Dimension = 2\n" + fluid, {"Fluid/Density"});
    check("override twice",
          "set Dimension = 2\n" + fluid,
          {"Fluid/Density = 1", "Fluid / Density = 2"});
    check("override without name", "set Dimension = 2\n" + fluid, {"/ = 1"});
  }

  void
  broken_files(const std::string &fluid)
  {
    check("missing end",
          "set Dimension = 2\nsubsection Fluid\n set Density = 1");
    check("too many ends", "set Dimension = 2\nend\n" + fluid);
    check("text after end",
          "set Dimension = 2\nsubsection Fluid\n set Density = 1\nend it\n");
    check("not a line", "set Dimension = 2\nste Density = 1\n" + fluid);
    check("no equals", "set Dimension 2\n" + fluid);
    check("name with slash",
          "set Dimension = 2\nsubsection Fluid body a/b\nend\n" + fluid);
    check("empty", "");
    check("comments only", "# nothing\n\n");
    check("binary", std::string("set Dimension = 2\n\0", 19));
    check("includes itself", "set Dimension = 2\ninclude dam.prm\n" + fluid);
    write("other.inc", "include dam.prm\n");
    check("includes itself by another",
          "set Dimension = 2\ninclude other.inc\n" + fluid);
    check("include of nothing", "set Dimension = 2\ninclude no.inc\n" + fluid);
    std::cout << "-- folder, missing file" << std::endl;
    read(".");
    read("no.prm");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string fluid = "subsection Fluid\n  set Density = 1000\nend\n";
  accepted(fluid);
  unknown_names(fluid);
  wrong_values(fluid);
  broken_files(fluid);
}
