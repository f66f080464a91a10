// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/hdf5_image.h>
#include <seiche/postprocess/point_series.h>

#include <numeric>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// The parts of all ranks one after the other; empty but on rank 0.
    template <typename Number>
    std::vector<Number>
    gathered(const std::vector<Number> &part, const MPI_Comm communicator)
    {
      std::vector<Number> all;
      for (const auto &other : Utilities::MPI::gather(communicator, part))
        all.insert(all.end(), other.begin(), other.end());
      return all;
    }

    /// A column [n][components], row-major.
    template <int dim>
    std::vector<double>
    interleaved(const PointCloud<dim> &points, const PointColumn column)
    {
      const unsigned int  n = n_components(column, dim);
      std::vector<double> values(n * points.size());
      for (unsigned int c = 0; c < n; ++c)
        {
          const double *component = points.data(column, c);
          for (std::size_t i = 0; i < points.size(); ++i)
            values[n * i + c] = component[i];
        }
      return values;
    }
  } // namespace

  template <int dim>
  PointSeries<dim>::PointSeries(const FrameSettings &settings,
                                const MPI_Comm       communicator)
    : series("points", settings, communicator)
  {}

  template <int dim>
  void
  PointSeries<dim>::execute(const StepView<dim> &view,
                            StatisticsTable & /*statistics*/)
  {
    if (!series.due(view.time))
      return;
    const MPI_Comm communicator = view.points.communicator;

    std::vector<std::uint64_t> ids = gathered(view.points.ids(), communicator);
    std::vector<std::size_t>   order(ids.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(),
              order.end(),
              [&](const std::size_t a, const std::size_t b) {
                return ids[a] < ids[b];
              });

    std::vector<std::pair<PointColumnInfo, std::vector<double>>> columns;
    for (const PointColumnInfo &info : point_column_table)
      if (view.points.has(info.column))
        columns.emplace_back(info,
                             gathered(interleaved(view.points, info.column),
                                      communicator));

    series.write_from_first_rank("h5", [&](std::ostream &out) {
      Hdf5Image image("points.h5");
      image.write_attribute("time", view.time);
      image.write_attribute("pressure_time", view.pressure_time);
      image.write_attribute("step", view.step);
      image.write_attribute("dim", dim);
      std::vector<std::uint64_t> sorted_ids;
      for (const std::size_t i : order)
        sorted_ids.push_back(ids[i]);
      image.write_array("id", sorted_ids);
      for (const auto &[info, values] : columns)
        {
          const unsigned int  n = n_components(info.column, dim);
          std::vector<double> sorted;
          sorted.reserve(values.size());
          for (const std::size_t i : order)
            sorted.insert(sorted.end(),
                          values.begin() + n * i,
                          values.begin() + n * (i + 1));
          image.write_array(info.name, sorted, n, info.unit);
        }
      const std::vector<char> bytes = image.bytes();
      out.write(bytes.data(), bytes.size());
    });
  }

  template class PointSeries<2>;
  template class PointSeries<3>;
} // namespace seiche
