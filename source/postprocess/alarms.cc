// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/alarms.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// A quantity that has to stay in a band around zero.
    struct Quantity
    {
      const char *name;
      double      limit; // [-]
      const char *text, *advice;
    };

    // in the order of the values in Alarms::execute()
    constexpr Quantity quantities[] = {
      {"mean level",
       0.01,
       "the water between surface and walls is not that of the points by more "
       "than 1 %: levels may be wrong by as much of the depth",
       "smaller cells, more Points/Per cell and direction or a larger "
       "Points/Density rate"},
      {"overfull",
       0.02,
       "more than 2 % of the water is where cells are full already",
       "a larger Points/Density rate, a smaller Time/Step, or more Points/Per "
       "cell and direction"}};

    /// Water that the weak forms see over that of the points, less 1.
    template <int dim>
    double
    level_error(const StepView<dim> &view)
    {
      if (!view.fill.has_surface())
        return 0.;
      std::array<double, 2> sums{}; // of the points, seen
      for (const unsigned int cell : view.occupancy.occupied_cells())
        {
          const double measure = view.occupancy.locator.measure(cell);
          sums[0] += view.fill.cell_fill(cell) * measure;
          sums[1] += (view.fill.inside_share(cell) +
                      view.fill.loose_volume(cell, view.points)) *
                     measure;
        }
      Utilities::MPI::sum(ArrayView<const double>(sums.data(), sums.size()),
                          view.points.communicator,
                          ArrayView<double>(sums.data(), sums.size()));
      return sums[0] > 0. ? sums[1] / sums[0] - 1. : 0.;
    }
  } // namespace

  template <int dim>
  void
  Alarms<dim>::execute(const StepView<dim> &view,
                       StatisticsTable & /*statistics*/)
  {
    static_assert(std::size(quantities) == n_quantities);
    const std::array<double, n_quantities> values = {
      {level_error(view), view.fill.overfull_fraction()}};
    new_alarms.clear();
    for (unsigned int i = 0; i < n_quantities; ++i)
      {
        const Quantity &quantity = quantities[i];
        if (std::abs(values[i]) > quantity.limit &&
            std::abs(largest[i]) <= quantity.limit)
          new_alarms.push_back({quantity.text, quantity.advice, values[i]});
        if (std::abs(values[i]) > std::abs(largest[i]))
          largest[i] = values[i];
      }
  }

  template <int dim>
  void
  Alarms<dim>::finish(const StatisticsTable & /*statistics*/,
                      nlohmann::ordered_json &summary)
  {
    for (unsigned int i = 0; i < n_quantities; ++i)
      if (std::abs(largest[i]) > quantities[i].limit)
        summary["alarms"][quantities[i].name] = largest[i];
  }

  template <int dim>
  void
  Alarms<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("alarms", [&]() { archive("largest", largest); });
  }

  template class Alarms<2>;
  template class Alarms<3>;
} // namespace seiche
