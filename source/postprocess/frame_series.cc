// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/field_patches.h>
#include <seiche/postprocess/frame_series.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/result_names.h>
#include <seiche/utilities/state_archive.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>

namespace seiche
{
  using namespace dealii;

  FrameSeries::FrameSeries(const std::string   &series_name,
                           const FrameSettings &frame_settings,
                           const MPI_Comm       mpi_communicator)
    : name(series_name)
    , settings(frame_settings)
    , communicator(mpi_communicator)
  {}

  bool
  FrameSeries::due(const double time)
  {
    // sums of steps reach a multiple of the interval up to rounding only
    const double slack = 1e-6 * settings.interval;
    if (frames > 0 && time < next - slack &&
        time < settings.end_time * (1. - 1e-12))
      return false;
    next =
      settings.interval * (std::floor(time / settings.interval + 1e-6) + 1.);
    return true;
  }

  std::string
  FrameSeries::next_name(const std::vector<std::string> &extensions)
  {
    if (frames == 0)
      on_all_ranks(communicator, [&]() {
        if (Utilities::MPI::this_mpi_process(communicator) == 0)
          remove_later_frames(extensions);
      });
    return result_names::frame(name, frames++);
  }

  template <int patch_dim, int dim>
  void
  FrameSeries::write_vtu(const double                        time,
                         const FieldPatches<patch_dim, dim> &data)
  {
    const unsigned int n    = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const std::string  path = settings.directory + "/";
    const std::string  stem = next_name({".vtu", ".pvtu"});

    // VTK refuses a piece without cells: only ranks with data write one
    const std::vector<int> filled =
      Utilities::MPI::all_gather(communicator, data.patches.empty() ? 0 : 1);
    if (std::find(filled.begin(), filled.end(), 1) == filled.end())
      return; // nor a file without pieces
    std::vector<std::string> pieces;
    std::string              own_piece;
    for (unsigned int r = 0; r < n; ++r)
      if (filled[r])
        {
          pieces.push_back(n == 1 ? stem + ".vtu" :
                                    result_names::piece(stem, r));
          if (r == rank)
            own_piece = path + pieces.back();
        }
    on_all_ranks(communicator, [&]() {
      if (!own_piece.empty())
        checked_file::write(own_piece,
                            [&](std::ostream &out) { data.write_vtu(out); });
    });

    // the index names only what is complete on the disk
    index.emplace_back(time, n == 1 ? pieces[0] : stem + ".pvtu");
    on_all_ranks(communicator, [&]() {
      if (rank > 0)
        return;
      if (n > 1)
        checked_file::write(path + stem + ".pvtu", [&](std::ostream &out) {
          data.write_pvtu_record(out, pieces);
        });
      write_index();
    });
  }

  void
  FrameSeries::write_index() const
  {
    checked_file::write(settings.directory + "/" + result_names::index(name),
                        [&](std::ostream &out) {
                          DataOutBase::write_pvd_record(out, index);
                        });
  }

  void
  FrameSeries::save_or_load(StateArchive                   &archive,
                            const std::vector<std::string> &extensions)
  {
    archive("frames", frames);
    archive("next", next);
    archive("index", index);
    if (!archive.loading())
      return;
    on_all_ranks(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) > 0)
        return;
      if (!index.empty())
        write_index(); // first: it must not name what is gone
      remove_later_frames(extensions);
    });
  }

  void
  FrameSeries::remove_later_frames(
    const std::vector<std::string> &extensions) const
  {
    const std::string prefix = name + "_";
    for (const auto &entry :
         std::filesystem::directory_iterator(settings.directory))
      {
        const std::string file      = entry.path().filename().string();
        const std::string extension = entry.path().extension().string();
        if (file.compare(0, prefix.size(), prefix) != 0 ||
            std::find(extensions.begin(), extensions.end(), extension) ==
              extensions.end())
          continue;
        unsigned int number = 0;
        const auto   digits = std::from_chars(file.data() + prefix.size(),
                                            file.data() + file.size(),
                                            number);
        if (digits.ec == std::errc() && number >= frames)
          std::filesystem::remove(entry.path());
      }
  }

  void
  FrameSeries::write_file(const std::string &extension,
                          const std::function<void(const std::string &)> &write)
  {
    const std::string file =
      settings.directory + "/" + next_name({"." + extension}) + "." + extension;
    on_all_ranks(communicator, [&]() { write(file); });
  }

  template void
  FrameSeries::write_vtu(const double, const FieldPatches<0, 2> &);
  template void
  FrameSeries::write_vtu(const double, const FieldPatches<0, 3> &);
  template void
  FrameSeries::write_vtu(const double, const FieldPatches<1, 2> &);
  template void
  FrameSeries::write_vtu(const double, const FieldPatches<2, 3> &);
  template void
  FrameSeries::write_vtu(const double, const FieldPatches<2, 2> &);
  template void
  FrameSeries::write_vtu(const double, const FieldPatches<3, 3> &);
} // namespace seiche
