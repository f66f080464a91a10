// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/gathered_points.h>
#include <seiche/postprocess/point_series.h>
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
    const GatheredPoints<dim> points(view.points);
    series.write_from_first_rank("h5", [&](std::ostream &out) {
      Hdf5Image image("points.h5",
                      "\"Output/Point series = false\" does without them");
      image.write_attribute("time", view.time);
      image.write_attribute("pressure_time", view.pressure_time);
      image.write_attribute("step", view.step);
      image.write_attribute("dim", dim);
      points.write(image);
      const std::vector<char> bytes = image.bytes();
      out.write(bytes.data(), bytes.size());
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
