// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/csv_file.h>
#include <seiche/scene/height_map_file.h>
#include <seiche/scene/wall_slack.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <map>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Coordinates of a map's places, which are the same if they differ by
    /// round-off of what was typed.
    std::vector<double>
    distinct(std::vector<double> values)
    {
      std::sort(values.begin(), values.end());
      const double same = 1e-9 * (values.back() - values.front());
      values.erase(std::unique(values.begin(),
                               values.end(),
                               [same](const double a, const double b) {
                                 return b - a <= same;
                               }),
                   values.end());
      return values;
    }

    std::size_t
    nearest(const std::vector<double> &places, const double x)
    {
      const auto next = std::lower_bound(places.begin(), places.end(), x);
      if (next == places.begin())
        return 0;
      const std::size_t n = next - places.begin();
      return n == places.size() || x - places[n - 1] < places[n] - x ? n - 1 :
                                                                       n;
    }

    template <int dim>
    HeightMap<dim>
    read_csv(const InputFile   &input,
             const std::string &path,
             const std::string &name)
    {
      const CsvFile                        file(input, path, name);
      std::array<std::vector<double>, dim> columns;
      file.for_each_row([&](const CsvFile::Row &row) {
        if (row.fields.size() < dim)
          file.fail(fmt::format("{}{} columns; {} are needed: {}.",
                                row.place,
                                row.fields.size(),
                                dim,
                                dim == 2 ? "x, height" : "x, y, height"));
        for (unsigned int c = 0; c < dim; ++c)
          columns[c].push_back(row.number(c));
      });
      const std::size_t n = columns[0].size();
      HeightMap<dim>    map;
      std::size_t       n_places = 1;
      for (unsigned int d = 0; d + 1 < dim; ++d)
        {
          if (n > 0)
            map.places[d] = distinct(columns[d]);
          if (map.places[d].size() < 2)
            file.fail(fmt::format("{}: at least two places in {} are needed.",
                                  file.filename,
                                  "xy"[d]));
          n_places *= map.places[d].size();
        }
      map.heights.assign(n_places, std::numeric_limits<double>::quiet_NaN());
      for (std::size_t i = 0; i < n; ++i)
        {
          std::size_t place = 0, stride = 1;
          for (unsigned int d = 0; d + 1 < dim; ++d)
            {
              place += nearest(map.places[d], columns[d][i]) * stride;
              stride *= map.places[d].size();
            }
          if (!std::isnan(map.heights[place]))
            file.fail(fmt::format("{}: there are two heights at one place, "
                                  "x = {:g} m.",
                                  file.filename,
                                  columns[0][i]));
          map.heights[place] = columns[dim - 1][i];
        }
      if (n < n_places)
        file.fail(fmt::format("{}: {} rows are no rectangular lattice of {} x "
                              "{} places.",
                              file.filename,
                              n,
                              map.places[0].size(),
                              map.places[dim - 2].size()));
      return map;
    }

    /// The text of an ESRI ASCII grid: six lines of a name and a number, then
    /// heights from the north to the south.
    class EsriGrid
    {
    public:
      EsriGrid(const InputFile   &input_file,
               const std::string &path_of_entry,
               const std::string &name)
        : input(input_file)
        , path(path_of_entry)
        , filename(readable_file(input, path, name))
        , stream(filename)
      {
        stream.imbue(std::locale::classic());
      }

      HeightMap<3>
      read()
      {
        read_header();
        const std::size_t nx = count("ncols"), ny = count("nrows");
        const double      size = number("cellsize");
        input.require(size > 0.,
                      path,
                      filename + ": cellsize must be greater than zero.");
        HeightMap<3> map;
        map.places = {{line("xll", nx, size), line("yll", ny, size)}};
        map.heights.resize(nx * ny);
        const auto missing = header.find("nodata_value");
        for (std::size_t j = ny; j-- > 0;)
          for (std::size_t i = 0; i < nx; ++i)
            {
              double height;
              input.require(bool(stream >> height) && std::isfinite(height) &&
                              (missing == header.end() ||
                               height != missing->second),
                            path,
                            fmt::format("{}: there is no height at column {}, "
                                        "row {}, counted from 1; cut the grid "
                                        "to where it has all.",
                                        filename,
                                        i + 1,
                                        ny - j));
              map.heights[j * nx + i] = height;
            }
        return map;
      }

    private:
      void
      read_header()
      {
        while ((stream >> std::ws) && std::isalpha(stream.peek()) != 0)
          {
            std::string name;
            double      value;
            input.require(bool(stream >> name >> value),
                          path,
                          filename + ": a line of the header is no name and "
                                     "number.");
            for (char &letter : name)
              letter = std::tolower(letter);
            header[name] = value;
          }
      }

      double
      number(const std::string &name) const
      {
        const auto found = header.find(name);
        input.require(found != header.end(),
                      path,
                      fmt::format("{}: the header of an ESRI grid has a line "
                                  "\"{}\".",
                                  filename,
                                  name));
        return found->second;
      }

      std::size_t
      count(const std::string &name) const
      {
        const double value = number(name);
        input.require(value >= 2. && value == std::floor(value) && value < 1e5,
                      path,
                      fmt::format("{}: {} must be an integer from 2 to 99999.",
                                  filename,
                                  name));
        return static_cast<std::size_t>(value);
      }

      /// Heights belong to the centres of the grid's cells.
      std::vector<double>
      line(const std::string &lowest,
           const std::size_t  n,
           const double       size) const
      {
        const bool          by_centre = header.count(lowest + "center") > 0;
        const double        first     = by_centre ? number(lowest + "center") :
                                                    number(lowest + "corner") + 0.5 * size;
        std::vector<double> result(n);
        for (std::size_t i = 0; i < n; ++i)
          result[i] = first + i * size;
        return result;
      }

      const InputFile              &input;
      const std::string             path, filename;
      std::ifstream                 stream;
      std::map<std::string, double> header;
    };

    template <int dim>
    HeightMap<dim>
    read(const InputFile   &input,
         const std::string &path,
         const std::string &file)
    {
      const std::string esri = ".asc";
      if (file.size() > esri.size() &&
          file.compare(file.size() - esri.size(), esri.size(), esri) == 0)
        {
          if constexpr (dim == 3)
            return EsriGrid(input, path, file).read();
          input.fail(path,
                     "an ESRI grid has heights above an area; in 2D a CSV file "
                     "with x and height is needed.");
        }
      return read_csv<dim>(input, path, file);
    }
  } // namespace

  template <int dim>
  HeightMap<dim>
  read_height_map(const InputFile        &input,
                  const std::string      &path,
                  const std::string      &file,
                  const BoundingBox<dim> &domain)
  {
    input.require(!file.empty(), path, "the name of a file is needed.");
    HeightMap<dim> map = read<dim>(input, path, file);
    for (unsigned int d = 0; d + 1 < dim; ++d)
      {
        const double lower = map.places[d].front(),
                     upper = map.places[d].back();
        const double slack = wall_slack(domain.side_length(d));
        input.require(lower <= domain.lower_bound(d) + slack &&
                        upper >= domain.upper_bound(d) - slack,
                      path,
                      fmt::format("the map reaches from {:g} to {:g} m in {}, "
                                  "the domain from {:g} to {:g} m: extend the "
                                  "map, move it (Shift) or cut the domain.",
                                  lower,
                                  upper,
                                  "xy"[d],
                                  domain.lower_bound(d),
                                  domain.upper_bound(d)));
      }
    return map;
  }

  template HeightMap<2>
  read_height_map(const InputFile &,
                  const std::string &,
                  const std::string &,
                  const BoundingBox<2> &);
  template HeightMap<3>
  read_height_map(const InputFile &,
                  const std::string &,
                  const std::string &,
                  const BoundingBox<3> &);
} // namespace seiche
