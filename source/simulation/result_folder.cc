// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/result_folder.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/compatibility.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/references.h>
#include <seiche/utilities/result_names.h>
#include <seiche/utilities/version.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <filesystem>

namespace seiche
{
  namespace
  {
    void
    write_parameters(const dealii::ParameterHandler &prm,
                     const std::string              &directory)
    {
      checked_file::write(directory + "/" + result_names::parameters,
                          [&](std::ostream &stream) {
                            prm.print_parameters(
                              stream,
                              dealii::ParameterHandler::PRM |
                                dealii::ParameterHandler::KeepDeclarationOrder);
                          });
    }

    // of every scene, beside what its options cite
    constexpr const char *always_cited =
      "sulsky1994 moreno eisenstat1996 bangerth2011 p4est2011";

    /// The papers of the methods that the checked scene uses, of the libraries
    /// and of the program.
    void
    write_references(const InputFile &input, const std::string &directory)
    {
      input.cites(always_cited);
      input.cites(compatibility::dealii_paper);
      checked_file::write(
        directory + "/" + result_names::references, [&](std::ostream &stream) {
          stream
            << "% What a text about this run should cite, from the options "
               "of its scene.\n% Of the program itself: CITATION.cff. "
               "seiche "
            << program_version << "\n";
          for (const std::string &key : input.cited())
            stream << '\n' << reference(key);
        });
    }
  } // namespace



  ResultFolder::ResultFolder(const std::string     &output_directory,
                             const ParameterValues &parameters,
                             const MPI_Comm         mpi_communicator)
    : directory(output_directory)
    , earlier(output_directory)
    , checkpoints(output_directory, parameters, mpi_communicator)
    , communicator(mpi_communicator)
  {}



  bool
  ResultFolder::exists() const
  {
    bool result = false;
    on_first_rank(communicator,
                  [&]() { result = std::filesystem::is_directory(directory); });
    return dealii::Utilities::MPI::broadcast(communicator, result);
  }



  void
  ResultFolder::take()
  {
    try
      {
        on_first_rank(communicator,
                      [&]() { checked_file::make_directory(directory); });
      }
    catch (const FileError &error)
      {
        throw InputError(error.what()); // the user named a wrong place
      }
    on_first_rank(communicator, [&]() {
      lock.acquire(directory);
      earlier.settle();
    });
  }



  void
  ResultFolder::clear(RunReport &report) const
  {
    on_first_rank(communicator, [&]() {
      if (earlier.move_aside())
        report.header("the results of an earlier run are now in " +
                      earlier.place());
      checkpoints.clear();
    });
  }



  void
  ResultFolder::begin(const InputFile                &input,
                      const dealii::ParameterHandler &prm,
                      RunReport                      &report,
                      const bool                      continues) const
  {
    on_first_rank(communicator, [&]() {
      write_parameters(prm, directory);
      write_references(input, directory);
      report.open_files(continues);
    });
  }
} // namespace seiche
