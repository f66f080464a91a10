// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/tracked_points.h>
#include <seiche/utilities/axis_names.h>
#include <seiche/utilities/over_ranks.h>

#include <deal.II/base/parameter_handler.h>

#include <limits>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  TrackedPointParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Position",
                      position,
                      "The material point nearest to this place at the start "
                      "is followed. [m]",
                      *Patterns::Tools::Convert<Point<dim>>::to_pattern(),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Centre",
                      centre,
                      "The distance from here, over that at the start, is the "
                      "radius ratio. [m]");
  }

  template <int dim>
  void
  TrackedPointParameters<dim>::check(const InputFile           &input,
                                     const GridParameters<dim> &grid) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      input.require(position[d] >= grid.lower_corner[d] &&
                      position[d] <= grid.upper_corner[d],
                    std::string(kind) + " " + name + "/Position",
                    "the place lies outside the domain; choose one in the "
                    "fluid.");
  }

  template <int dim>
  std::vector<std::string>
  TrackedPointParameters<dim>::columns() const
  {
    std::vector<std::string> names;
    for (unsigned int d = 0; d < dim; ++d)
      names.push_back("point " + name + " " + axis_names[d] + " [m]");
    names.push_back("point " + name + " radius ratio [-]");
    return names;
  }

  template <int dim>
  TrackedPoints<dim>::TrackedPoints(const std::vector<Parameters> &parameters,
                                    const PostprocessorContext<dim> &)
    : tracks(parameters)
  {}

  template <int dim>
  void
  TrackedPoints<dim>::choose(const StepView<dim> &view)
  {
    const MPI_Comm communicator = view.points.communicator;
    for (const auto &track : tracks)
      {
        double        nearest = std::numeric_limits<double>::max();
        std::uint64_t id      = std::numeric_limits<std::uint64_t>::max();
        for (std::size_t i = 0; i < view.points.size(); ++i)
          {
            const double distance =
              view.points.locator.periods
                .shortest(view.points.position(i) - track.position)
                .norm_square();
            if (distance < nearest ||
                (distance == nearest && view.points.ids()[i] < id))
              {
                nearest = distance;
                id      = view.points.ids()[i];
              }
          }
        if (nearest > Utilities::MPI::min(nearest, communicator))
          id = std::numeric_limits<std::uint64_t>::max();
        // not MPI::min(): Open MPI 4.1 compares unsigned 64-bit numbers as if
        // they were signed
        const std::vector<std::uint64_t> candidates =
          Utilities::MPI::all_gather(communicator, id);
        ids.push_back(*std::min_element(candidates.begin(), candidates.end()));
      }
    last_index.assign(tracks.size(), 0);
    start_radius.assign(tracks.size(), 0.);
  }

  template <int dim>
  void
  TrackedPoints<dim>::execute(const StepView<dim> &view,
                              StatisticsTable     &statistics)
  {
    const bool first = ids.empty();
    if (first)
      choose(view);

    // position and one for "found", of each track
    const std::vector<std::uint64_t> &all = view.points.ids();
    std::vector<double>               found(tracks.size() * (dim + 1), 0.);
    for (unsigned int t = 0; t < tracks.size(); ++t)
      {
        std::size_t &i = last_index[t];
        if (i >= all.size() || all[i] != ids[t])
          i = std::find(all.begin(), all.end(), ids[t]) - all.begin();
        if (i == all.size())
          continue;
        for (unsigned int d = 0; d < dim; ++d)
          found[t * (dim + 1) + d] = view.points.position(i)[d];
        found[t * (dim + 1) + dim] = 1.;
      }
    sum_over_ranks(found, view.points.communicator);

    for (unsigned int t = 0; t < tracks.size(); ++t)
      {
        const bool exists = found[t * (dim + 1) + dim] > 0.5;
        Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = found[t * (dim + 1) + d];
        const double radius =
          view.points.locator.periods.shortest(x - tracks[t].centre).norm();
        if (first)
          start_radius[t] = radius;
        const auto columns = tracks[t].columns();
        for (unsigned int d = 0; d < dim; ++d)
          statistics.set(columns[d], exists ? x[d] : StatisticsTable::missing);
        statistics.set(columns[dim],
                       exists && start_radius[t] > 0. ?
                         radius / start_radius[t] :
                         StatisticsTable::missing);
      }
  }

  template <int dim>
  void
  TrackedPoints<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("tracked points", [&]() {
      archive("ids", ids);
      archive("start radius", start_radius);
    });
    last_index.resize(ids.size(), 0);
  }

  template struct TrackedPointParameters<2>;
  template struct TrackedPointParameters<3>;
  template class TrackedPoints<2>;
  template class TrackedPoints<3>;
} // namespace seiche
