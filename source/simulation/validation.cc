// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/scene_picture.h>
#include <seiche/simulation/validation.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/folder_name.h>

#include <filesystem>
#include <iostream>

namespace seiche
{
  namespace
  {
    /// The line that names the picture, or nothing.
    template <int dim>
    std::string
    draw(const PlannedScene<dim> &planned, const std::string &file)
    {
      try
        {
          const std::string title =
            std::filesystem::path(planned.scene.input.filename)
              .stem()
              .string() +
            ": " + planned.plan.size_text();
          checked_file::write(file, [&](std::ostream &stream) {
            stream << scene_picture(planned.scene, planned.bodies, title);
          });
          return "  picture: " + file + '\n';
        }
      catch (const FileError &error)
        {
          std::cerr << "warning: no picture: " << error.what() << '\n';
          return "";
        }
    }
  } // namespace



  template <int dim>
  void
  validate(const PlannedScene<dim> &planned, const std::string &output)
  {
    const InputFile      &input   = planned.scene.input;
    const ScenePlan<dim> &plan    = planned.plan;
    const std::string     picture = draw(planned, folder_name(output) + ".svg");
    for (const std::string &doubt : plan.doubts(output))
      std::cerr << "warning: " << doubt << '\n';
    for (const std::string &in_vain : input.without_effect())
      std::cerr << "warning: " << in_vain << '\n';
    std::cout << input.filename << " is valid: " << plan.size_text() << '\n'
              << plan.cost_text() << "  " << plan.scales.text() << '\n'
              << picture << std::flush;
  }

  template void
  validate(const PlannedScene<2> &, const std::string &);
  template void
  validate(const PlannedScene<3> &, const std::string &);
} // namespace seiche
