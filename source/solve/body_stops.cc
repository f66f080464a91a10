// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/body_stops.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int most_sweeps = 1000;
    constexpr double       converged   = 1e-12; // of the largest force
  }                                             // namespace

  void
  BodyStops::begin(std::vector<BodyStop> list,
                   const double          step,
                   const unsigned int    n_directions)
  {
    stops  = std::move(list);
    dt     = step;
    solved = false;
    sums.reinit(n_directions);
  }

  double
  BodyStops::slack(const BodyStop            &stop,
                   const std::vector<double> &accelerations) const
  {
    double result = stop.rate - stop.least;
    for (unsigned int i = 0; i < accelerations.size(); ++i)
      result += dt * stop.way[i] * accelerations[i];
    return result;
  }

  bool
  BodyStops::are_missing(const std::vector<double> &accelerations) const
  {
    return !solved &&
           std::any_of(stops.begin(), stops.end(), [&](const BodyStop &stop) {
             return slack(stop, accelerations) < 0.;
           });
  }

  void
  BodyStops::solve(const FullMatrix<double>  &inverse,
                   const Vector<double>      &load,
                   const std::vector<double> &accelerations)
  {
    solved               = true;
    const unsigned int n = accelerations.size();
    sums                 = 0.;
    Vector<double> change(n);
    inverse.vmult(change, load);
    // of each stop: what a unit of its force does, and to its own gap
    std::vector<Vector<double>> answers(stops.size(), Vector<double>(n));
    std::vector<double>         own(stops.size()), force(stops.size(), 0.);
    for (unsigned int c = 0; c < stops.size(); ++c)
      {
        const Vector<double> way(stops[c].way.begin(), stops[c].way.end());
        inverse.vmult(answers[c], way);
        own[c] = dt * (way * answers[c]);
      }
    double largest = 0., moved = 1.;
    for (unsigned int sweep = 0;
         sweep < most_sweeps && moved > converged * largest;
         ++sweep)
      {
        moved = 0.;
        for (unsigned int c = 0; c < stops.size(); ++c)
          if (own[c] > 0.)
            {
              double gap = slack(stops[c], accelerations);
              for (unsigned int i = 0; i < n; ++i)
                gap += dt * stops[c].way[i] * change(i);
              const double before = force[c];
              force[c]            = std::max(0., before - gap / own[c]);
              change.add(force[c] - before, answers[c]);
              moved   = std::max(moved, std::abs(force[c] - before));
              largest = std::max(largest, force[c]);
            }
      }
    for (unsigned int c = 0; c < stops.size(); ++c)
      for (unsigned int i = 0; i < n; ++i)
        sums(i) += force[c] * stops[c].way[i];
  }
} // namespace seiche
