// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/ordered_points.h>
#include <seiche/simulation/checkpoint.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/version.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace seiche
{
  namespace
  {
    /// Of the content; raise it when old files cannot be read any more.
    constexpr unsigned int format_version = 6;

    constexpr std::size_t points_per_chunk = std::size_t(1) << 16;

    /// FNV-1a, 64 bits, of bytes that come in pieces: every single altered byte
    /// alters it.
    struct Digest
    {
      std::size_t   size = 0;
      std::uint64_t hash = 14695981039346656037ull;

      void
      add(const char *data, const std::size_t n)
      {
        size += n;
        for (std::size_t i = 0; i < n; ++i)
          hash =
            (hash ^ static_cast<unsigned char>(data[i])) * 1099511628211ull;
      }

      /// Of a file that has these bytes before it.
      std::string
      last_line() const
      {
        return fmt::format("\nseiche checkpoint {:020} {:016x}\n", size, hash);
      }
    };

    /// @p filename if its content is what was written.
    const std::string &
    verified(const std::string &filename)
    {
      const std::size_t length = Digest().last_line().size();
      std::error_code   error; // met again by the reading, which reports it
      const auto        all  = std::filesystem::file_size(filename, error);
      const std::size_t rest = error || all < length ? 0 : all - length;
      Digest            digest;
      std::string       end;
      checked_file::read_in_pieces(
        filename, [&](const char *data, const std::size_t size) {
          const std::size_t n = std::min(size, rest - digest.size);
          digest.add(data, n);
          end.append(data + n, size - n);
        });
      const std::string mark = "\nseiche checkpoint ";
      if (end.compare(0, mark.size(), mark) != 0)
        throw FileError(filename + ": it is cut short, or no checkpoint of "
                                   "this program.");
      if (end != digest.last_line())
        throw FileError(filename + ": it is damaged (its hash does not fit "
                                   "its content).");
      return filename;
    }
  } // namespace



  Checkpoint::Checkpoint(const std::string &name)
    : filename(name)
    , reader(verified(filename))
    , saved(reader.bytes("state"))
  {
    unsigned int version = 0;
    saved("format version", version);
    if (version != format_version)
      throw FileError(fmt::format("{}: its format has version {}; this program "
                                  "reads version {}.",
                                  filename,
                                  version,
                                  format_version));
    saved("parameters", parameters);
  }



  template <int dim>
  void
  Checkpoint::write(const std::string     &filename,
                    const PointCloud<dim> &points,
                    StateArchive          &state,
                    const ParameterValues &parameters)
  {
    std::string     program = program_version;
    unsigned int    version = format_version;
    ParameterValues fixed   = parameters;
    state("format version", version);
    state("program version", program);
    state("parameters", fixed);

    const OrderedPoints<dim> ordered(points);
    const auto               fill = [&](std::ostream &out) {
      Hdf5Image image(filename, "\"Checkpoint/Every steps = 0\" does without");
      image.write_attribute("program_version", program);
      image.write_attribute("format_version", version);
      image.write_attribute("dim", dim);
      image.write_bytes("state", state.bytes());
      ordered.add_to(image);
      Digest digest;
      image.write([&](const char *data, const std::size_t size) {
        digest.add(data, size);
        out.write(data, size);
      });
      out << digest.last_line();
    };
    on_all_ranks(points.communicator, [&]() {
      ordered.while_rows_are_handed_out(
        [&]() { checked_file::write(filename, fill); });
    });
  }



  void
  Checkpoint::require_same_scene(const ParameterValues &now) const
  {
    unsigned int n_other = 0;
    std::string  first;
    const auto   value = [](const ParameterValues &values,
                          const std::string     &path) {
      const auto entry = values.find(path);
      return entry == values.end() ? std::optional<std::string>() :
                                       std::optional<std::string>(entry->second);
    };
    ParameterValues all = parameters;
    all.insert(now.begin(), now.end());
    for (const auto &entry : all)
      {
        const auto there = value(parameters, entry.first);
        const auto here  = value(now, entry.first);
        if (there == here || n_other++ > 0)
          continue;
        first = fmt::format("\"{}\" {} there and {} here",
                            entry.first,
                            there ? "is \"" + *there + "\"" : "is missing",
                            here ? "\"" + *here + "\"" : "missing");
      }
    if (n_other > 0)
      throw FileError(fmt::format("{}: it belongs to another scene: {}{}.",
                                  filename,
                                  first,
                                  n_other > 1 ?
                                    fmt::format(", and {} more", n_other - 1) :
                                    ""));
  }



  template <int dim>
  void
  Checkpoint::insert_own_points(PointCloud<dim> &points) const
  {
    const std::size_t n = n_points();
    for (std::size_t begin = 0; begin < n; begin += points_per_chunk)
      {
        const std::size_t end   = std::min(n, begin + points_per_chunk);
        const auto        ids   = reader.integers("id", begin, end);
        const auto        x     = reader.doubles("position", dim, begin, end);
        const std::size_t first = points.size();
        std::vector<std::size_t> own;
        for (std::size_t i = 0; i < end - begin; ++i)
          {
            dealii::Point<dim> place;
            for (unsigned int d = 0; d < dim; ++d)
              place[d] = x[dim * i + d];
            if (points.locator.find(place) >= points.locator.cells.n_owned())
              continue;
            own.push_back(i);
            points.insert(ids[i], place, {}, 0., 0.);
          }
        for (const PointColumnInfo &info : point_column_table)
          if (points.has(info.column))
            {
              const unsigned int m = n_components(info.column, dim);
              const auto values    = reader.doubles(info.name, m, begin, end);
              for (unsigned int c = 0; c < m; ++c)
                for (std::size_t k = 0; k < own.size(); ++k)
                  points.data(info.column, c)[first + k] =
                    values[m * own[k] + c];
            }
      }
  }



  ParameterValues
  fixed_parameters(const ParameterValues &all)
  {
    static const std::vector<std::string> free_sections = {
      "Output/", "Checkpoint/", "Solver/", "Score ", "Verdict "};
    static const std::vector<std::string> free_entries = {
      "Time/End time",
      "Time/Step",
      "Time/CFL number",
      "Time/Error tolerance",
      "Time/Minimum step",
      "Time/Maximum displacement"};
    static const std::string step_control = "Time/Step control";
    ParameterValues          fixed;
    for (const auto &entry : all)
      {
        const std::string &path = entry.first;
        const bool         in_free_section =
          std::any_of(free_sections.begin(),
                      free_sections.end(),
                      [&](const std::string &section) {
                        return path.compare(0, section.size(), section) == 0;
                      });
        const bool is_free_entry =
          std::find(free_entries.begin(), free_entries.end(), path) !=
          free_entries.end();
        // the mean level is a column of statistics.csv
        if (path == "Output/Mean level" || !(in_free_section || is_free_entry))
          fixed.insert(entry);
      }
    // only with this control do the points carry accelerations
    if (fixed.at(step_control) != "error")
      fixed.erase(step_control);
    return fixed;
  }



  template void
  Checkpoint::write(const std::string &,
                    const PointCloud<2> &,
                    StateArchive &,
                    const ParameterValues &);
  template void
  Checkpoint::write(const std::string &,
                    const PointCloud<3> &,
                    StateArchive &,
                    const ParameterValues &);
  template void
  Checkpoint::insert_own_points(PointCloud<2> &) const;
  template void
  Checkpoint::insert_own_points(PointCloud<3> &) const;
} // namespace seiche
