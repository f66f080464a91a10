// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/point_control.h>
#include <seiche/parameters/input_file.h>
#include <seiche/utilities/over_ranks.h>
#include <seiche/utilities/state_archive.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  void
  PointControlParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Points");
    prm.add_parameter("Shifting sweeps",
                      sweeps,
                      "How often a step moves points down the gradient of the "
                      "nodal fill, away from the free surface; 0: no "
                      "shifting. [-]",
                      Patterns::Integer(0, 100));
    prm.add_parameter("Shifting strength",
                      strength,
                      "Cells that a point moves in a sweep for a difference "
                      "of one in the fill of neighbouring nodes. [-]",
                      Patterns::Double(0., 0.3));
    prm.add_parameter("Density rate",
                      density_rate,
                      "With Quadrature/Rule = cut cells: share of the error of "
                      "the nodal fill inside the fluid that is taken back, by "
                      "moving points, while fluid passes or falls by a cell; "
                      "0: none. [-]",
                      Patterns::Double(0., 1000.));
    prm.add_parameter("Reseeding",
                      reseeding,
                      "Split points in cells that hold few of them, merge "
                      "them in cells that hold many; not in cells at the free "
                      "surface.");
    prm.add_parameter("Fewest per cell",
                      fewest,
                      "Points are split in cells with fewer; 0: half of the "
                      "number in a full cell at the start. [-]",
                      Patterns::Integer(0));
    prm.add_parameter("Most per cell",
                      most,
                      "Points are merged in cells with more; 0: twice the "
                      "number in a full cell at the start. [-]",
                      Patterns::Integer(0));
    prm.leave_subsection();
  }

  void
  PointControlParameters::check(const InputFile   &input,
                                const bool         carries_gradient,
                                const unsigned int per_cell)
  {
    input.read_only_if(sweeps > 0,
                       "Points/Shifting strength",
                       "Points/Shifting sweeps");
    if (sweeps > 0)
      input.cites("lind2012");
    for (const char *entry : {"Points/Fewest per cell", "Points/Most per cell"})
      input.read_only_if(reseeding, entry, "Points/Reseeding = true");
    if (fewest == 0)
      fewest = (per_cell + 1) / 2;
    if (most == 0)
      most = std::max(2 * per_cell, 2 * fewest);
    input.require(std::isfinite(strength),
                  "Points/Shifting strength",
                  "must be a number from 0 to 0.3.");
    input.require(sweeps == 0 || carries_gradient,
                  "Points/Shifting sweeps",
                  "the velocity of a shifted point follows from its gradient: "
                  "choose a Transfer/Method whose points carry one (affine "
                  "FLIP, APIC, TPIC), or 0.");
    input.require(!reseeding || most >= 2 * fewest,
                  "Points/Most per cell",
                  fmt::format("must be at least twice \"Fewest per cell\", "
                              "{} here.",
                              2 * fewest));
  }

  template <int dim>
  PointControl<dim>::PointControl(const PointControlParameters &control,
                                  PointCloud<dim>              &point_cloud,
                                  Occupancy<dim>               &grid_occupancy,
                                  Fill<dim>                    &grid_fill)
    : parameters(control)
    , points(point_cloud)
    , occupancy(grid_occupancy)
    , fill(grid_fill)
    , shifting(fill, parameters.strength)
    , reseeding(fill, parameters.fewest, parameters.most)
  {
    for (const std::uint64_t id : points.ids())
      next_id = std::max(next_id, id + 1);
    // MPI::max would compare 64 bits as signed numbers (Open MPI 4.1)
    for (const std::uint64_t other :
         Utilities::MPI::all_gather(points.communicator, next_id))
      next_id = std::max(next_id, other);
  }

  template <int dim>
  void
  PointControl<dim>::update()
  {
    for (unsigned int sweep = 0; sweep < parameters.sweeps; ++sweep)
      {
        const Moments before = moments();
        shifting.sweep(points);
        add_change(before, by_shifting);
        find_again();
      }
    if (!parameters.reseeding)
      return;
    const Moments       before = moments();
    const std::uint64_t n_gone = reseeding.merge(points);
    add_change(before, by_merging);
    const Moments       between = moments();
    const std::uint64_t n_new   = reseeding.split(points, next_id);
    add_change(between, by_splitting);
    n_merged += Utilities::MPI::sum(n_gone, points.communicator);
    n_split += Utilities::MPI::sum(n_new, points.communicator);
    find_again();
  }

  template <int dim>
  void
  PointControl<dim>::add_change(const Moments &before, Moments &sum) const
  {
    Moments change = moments();
    for (unsigned int i = 0; i < change.size(); ++i)
      change[i] -= before[i];
    sum_over_ranks(change, points.communicator);
    for (unsigned int i = 0; i < sum.size(); ++i)
      sum[i] += change[i];
  }

  template <int dim>
  void
  PointControl<dim>::find_again()
  {
    points.locate();
    occupancy.update(points);
    fill.update(points);
  }

  template <int dim>
  typename PointControl<dim>::Moments
  PointControl<dim>::moments() const
  {
    Moments       result{};
    const double *mass = points.data(PointColumn::mass);
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        double x[3] = {}, momentum[3] = {};
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double v = points.data(PointColumn::velocity, d)[p];
            x[d]           = points.data(PointColumn::position, d)[p];
            momentum[d]    = mass[p] * v;
            result[0] += 0.5 * momentum[d] * v;
            result[1 + d] += momentum[d];
          }
        for (unsigned int d = 0; d < 3; ++d)
          result[4 + d] += x[(d + 1) % 3] * momentum[(d + 2) % 3] -
                           x[(d + 2) % 3] * momentum[(d + 1) % 3];
      }
    return result;
  }

  template <int dim>
  std::vector<std::string>
  PointControl<dim>::account_names(const PointControlParameters &parameters)
  {
    std::vector<std::string> result;
    const auto               add = [&result](const std::string &what) {
      result.push_back(what + " energy [J]");
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back(
          fmt::format("{} momentum {} [kg m/s]", what, "xyz"[d]));
      for (unsigned int d = dim == 2 ? 2 : 0; d < 3; ++d)
        result.push_back(
          fmt::format("{} angular momentum {} [kg m^2/s]", what, "xyz"[d]));
    };
    if (parameters.sweeps > 0)
      add("shifting");
    if (parameters.reseeding)
      {
        result.insert(result.end(), {"points split [-]", "points merged [-]"});
        add("splitting");
        add("merging");
      }
    return result;
  }

  template <int dim>
  std::vector<std::pair<std::string, double>>
  PointControl<dim>::account() const
  {
    std::vector<double> values;
    const auto          add = [&values](const Moments &change) {
      for (unsigned int d = 0; d < 1 + dim; ++d)
        values.push_back(change[d]);
      for (unsigned int d = dim == 2 ? 2 : 0; d < 3; ++d)
        values.push_back(change[4 + d]);
    };
    if (parameters.sweeps > 0)
      add(by_shifting);
    if (parameters.reseeding)
      {
        values.insert(values.end(),
                      {static_cast<double>(n_split),
                       static_cast<double>(n_merged)});
        add(by_splitting);
        add(by_merging);
      }
    const auto names = account_names(parameters);
    AssertDimension(names.size(), values.size());
    std::vector<std::pair<std::string, double>> result;
    for (unsigned int i = 0; i < names.size(); ++i)
      result.emplace_back(names[i], values[i]);
    return result;
  }

  template <int dim>
  void
  PointControl<dim>::save_or_load(StateArchive &archive)
  {
    archive("next id", next_id);
    archive("points split", n_split);
    archive("points merged", n_merged);
    archive("by shifting", by_shifting);
    archive("by splitting", by_splitting);
    archive("by merging", by_merging);
  }

  template class PointControl<2>;
  template class PointControl<3>;
} // namespace seiche
