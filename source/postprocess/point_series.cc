// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/ordered_points.h>
#include <seiche/postprocess/point_series.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/result_names.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  PointSeries<dim>::PointSeries(const FrameSettings &settings,
                                const MPI_Comm       communicator)
    : series(result_names::points, settings, communicator)
  {}

  template <int dim>
  void
  PointSeries<dim>::execute(const StepView<dim> &view,
                            StatisticsTable & /*statistics*/)
  {
    if (!series.due(view.time))
      return;
    const OrderedPoints<dim> points(view.points);
    std::string              file;
    const auto               fill = [&](std::ostream &out) {
      Hdf5Image image(file,
                      "\"Output/Point series = false\" does without them");
      image.write_attribute("time", view.time);
      image.write_attribute("pressure_time", view.pressure_time);
      image.write_attribute("step", view.step);
      image.write_attribute("dim", dim);
      points.add_to(image);
      image.write([&out](const char *data, const std::size_t size) {
        out.write(data, size);
      });
    };
    series.write_file("h5", [&](const std::string &path) {
      file = path;
      points.while_rows_are_handed_out(
        [&]() { checked_file::write(file, fill); });
    });
  }

  template <int dim>
  void
  PointSeries<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("point series",
                    [&]() { series.save_or_load(archive, {".h5"}); });
  }

  template class PointSeries<2>;
  template class PointSeries<3>;
} // namespace seiche
