// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/config.h>

#include <seiche/utilities/version.h>

#include <boost/version.hpp>

#include <HYPRE_config.h>
#include <Trilinos_version.h>
#include <cholmod.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <mpi.h>

namespace seiche
{
  namespace
  {
    /// "Open MPI v4.1.4", without what the library says of its packager.
    std::string
    mpi_version()
    {
      char text[MPI_MAX_LIBRARY_VERSION_STRING];
      int  length = 0;
      MPI_Get_library_version(text, &length);
      const std::string whole(text, static_cast<std::size_t>(length));
      return whole.substr(0, whole.find_first_of(",\n"));
    }

    std::string
    hdf5_version()
    {
      unsigned int major = 0, minor = 0, release = 0;
      H5get_libversion(&major, &minor, &release);
      return fmt::format("{}.{}.{}", major, minor, release);
    }
  } // namespace

  std::string
  version_text()
  {
    const std::pair<const char *, std::string> lines[] = {
      {"deal.II", DEAL_II_PACKAGE_VERSION},
      {"Trilinos", TRILINOS_VERSION_STRING},
      {"p4est",
       fmt::format("{}.{}.{}",
                   DEAL_II_P4EST_VERSION_MAJOR,
                   DEAL_II_P4EST_VERSION_MINOR,
                   DEAL_II_P4EST_VERSION_SUBMINOR)},
      {"HYPRE", HYPRE_RELEASE_VERSION},
      {"CHOLMOD",
       fmt::format("{}.{}.{}",
                   CHOLMOD_MAIN_VERSION,
                   CHOLMOD_SUB_VERSION,
                   CHOLMOD_SUBSUB_VERSION)},
      {"HDF5", hdf5_version()},
      {"MPI", mpi_version()},
      {"Boost",
       fmt::format("{}.{}.{}",
                   BOOST_VERSION / 100000,
                   BOOST_VERSION / 100 % 1000,
                   BOOST_VERSION % 100)},
      {"compiler", __VERSION__},
      {"build", SEICHE_BUILD}};
    std::string text = fmt::format("seiche {}\n", program_version);
    for (const auto &[name, version] : lines)
      text += fmt::format("  {:<9} {}\n", name, version);
    return text;
  }
} // namespace seiche
