// SPDX-License-Identifier: LGPL-2.1-or-later
// Points crowded by a map: shifting evens out the fill, splitting and merging
// keep their bounds; a linear velocity stays exact, and what must be conserved
// is.
#include <seiche/grid/point_control.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "point_fields.h"
#include "scene_from_text.h"
#include "table_row.h"

namespace
{
  constexpr unsigned int name_width = 14;

  template <int dim>
  std::string
  scene_text()
  {
    const std::string z  = dim == 3 ? ", 0" : "";
    const std::string z1 = dim == 3 ? ", 1" : "";
    return "subsection Grid\n set Lower corner = 0, 0" + z +
           "\n set Upper corner = 1, 1" + z1 +
           "\n set Cell size = " + (dim == 2 ? "0.125" : "0.25") +
           "\nend\n"
           "subsection Obstacle block\n set Lower corner = 0.5, 0" +
           z + "\n set Upper corner = 0.75, 0.25" + z1 +
           "\nend\n"
           "subsection Fluid body all\n set Lower corner = 0, 0" +
           z + "\n set Upper corner = 1, 1" + z1 +
           "\nend\n"
           "subsection Points\n set Per cell and direction = 3\nend\n";
  }



  template <int dim>
  Tensor<2, dim>
  gradient()
  {
    Tensor<2, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        result[c][d] = 0.5 * c - 0.3 * d + 0.1 * c * d + 0.2;
    return result;
  }



  /// Crowd the points and give them the velocity G x + 1, kinds of volumes.
  template <int dim>
  void
  disturb(seiche::PointCloud<dim> &points)
  {
    const Tensor<2, dim> G = gradient<dim>();
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        Point<dim> x = points.position(p);
        if (x[1] > 0.3)
          x[1] = 0.3 + 0.7 * std::pow((x[1] - 0.3) / 0.7, 1.25);
        const Tensor<1, dim> v = G * x;
        for (unsigned int c = 0; c < dim; ++c)
          {
            points.data(PointColumn::position, c)[p] = x[c];
            points.data(PointColumn::velocity, c)[p] = v[c] + 1.;
            for (unsigned int d = 0; d < dim; ++d)
              points.data(PointColumn::velocity_gradient, c * dim + d)[p] =
                G[c][d];
          }
        points.data(PointColumn::volume_ratio)[p] = 1. + 0.1 * x[0];
        points.data(PointColumn::pressure)[p]     = 3.;
      }
    points.locate();
  }



  /// What is to be kept, and how evenly the points lie.
  template <int dim>
  struct Snapshot
  {
    Snapshot(const seiche::PointCloud<dim> &points,
             const seiche::Fill<dim>       &fill)
      : ledger(of_points(points, column(points, PointColumn::velocity)))
    {
      for (std::size_t p = 0; p < points.size(); ++p)
        volume += points.data(PointColumn::initial_volume)[p] *
                  points.data(PointColumn::volume_ratio)[p];
      volume = global_sum(volume);
      for (const auto &own :
           Utilities::MPI::all_gather(communicator, points.ids()))
        ids.insert(ids.end(), own.begin(), own.end());
      std::sort(ids.begin(), ids.end());

      const seiche::Occupancy<dim> &occupancy = fill.occupancy;
      for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
        {
          const double f = fill.nodal_fill().local_element(i);
          uneven += occupancy.nodes.volume(i) * (f - 1.) * (f - 1.);
          fullest = std::max(fullest, f);
        }
      uneven  = std::sqrt(global_sum(uneven));
      fullest = global_max(fullest);
      for (const unsigned int cell : occupancy.cells.occupied())
        {
          const double n = points.n_points_in(cell);
          fewest         = std::min(fewest, n);
          most           = std::max(most, n);
        }
      fewest = -global_max(-fewest);
      most   = global_max(most);
    }

    Ledger<dim>                ledger;
    double                     volume = 0.;
    std::vector<std::uint64_t> ids;          // of all ranks
    double                     uneven  = 0.; // rms deviation of nodal fill
    double                     fullest = 0.; // nodal fill
    double                     fewest = 1e9, most = 0.; // points in a cell
  };



  /// The linear fields and the constant pressure of disturb().
  template <int dim>
  bool
  are_fields_exact(const seiche::PointCloud<dim> &points)
  {
    const Tensor<2, dim> G        = gradient<dim>();
    const auto           velocity = column(points, PointColumn::velocity);
    return for_all(points.size(), [&](const std::size_t p) {
      auto difference = velocity[p] - G * points.position(p);
      for (unsigned int d = 0; d < dim; ++d)
        difference[d] -= 1.;
      double error =
        std::max(difference.norm(),
                 std::abs(points.data(PointColumn::pressure)[p] - 3.));
      for (unsigned int c = 0; c < dim * dim; ++c)
        error =
          std::max(error,
                   std::abs(points.data(PointColumn::velocity_gradient, c)[p] -
                            G[c / dim][c % dim]));
      return error < 1e-12;
    });
  }



  /// New points have the next ids, none has that of another.
  template <int dim>
  bool
  are_ids_right(const Snapshot<dim> &before,
                const Snapshot<dim> &after,
                const unsigned int   n_split)
  {
    bool right =
      std::adjacent_find(after.ids.begin(), after.ids.end()) == after.ids.end();
    unsigned int n_new = 0;
    for (const std::uint64_t id : after.ids)
      if (id > before.ids.back())
        right &= id == before.ids.back() + ++n_new;
      else
        right &= std::binary_search(before.ids.begin(), before.ids.end(), id);
    return right && n_new == n_split;
  }



  /// Whether the account of what was done gives the changes, and those to the
  /// right deed if there is one only.
  template <int dim>
  bool
  is_account_right(std::map<std::string, double> account,
                   const std::string            &deed,
                   const Snapshot<dim>          &before,
                   const Snapshot<dim>          &after)
  {
    const auto is_change = [&](const std::string &what, const double change) {
      double sum = 0.;
      for (const char *by : {"shifting", "splitting", "merging"})
        if (deed == "both" || deed == by)
          sum += account[by + (" " + what)];
        else if (std::abs(account[by + (" " + what)]) > 1e-9)
          return false;
      return std::abs(sum - change) < 1e-9;
    };
    const auto &a = before.ledger, &b = after.ledger;
    bool        right = is_change("energy [J]", b.energy - a.energy);
    for (unsigned int d = 0; d < dim; ++d)
      right &= is_change(std::string("momentum ") + "xyz"[d] + " [kg m/s]",
                         b.momentum[d] - a.momentum[d]);
    for (unsigned int d = dim == 2 ? 2 : 0; d < 3; ++d)
      {
        const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
        right &=
          is_change(std::string("angular momentum ") + "xyz"[d] + " [kg m^2/s]",
                    b.spin[e][f] - a.spin[e][f]);
      }
    const double n_new =
      account["points split [-]"] - account["points merged [-]"];
    return right && before.ids.size() + n_new == after.ids.size();
  }



  template <int dim>
  void
  test(const std::string                    &name,
       const seiche::PointControlParameters &parameters)
  {
    SeededScene<dim> seeded(scene_text<dim>(),
                            100.,
                            {PointColumn::velocity_gradient});
    auto            &points = seeded.points;
    disturb(points);
    seiche::Occupancy<dim> occupancy(seeded.locator, /*degree=*/1);
    occupancy.update(points);
    seiche::Fill<dim> fill(occupancy, seiche::QuadratureRule::cut_cells);
    fill.update(points);
    seiche::PointControl<dim> control(parameters, points, occupancy, fill);
    const Snapshot<dim>       before(points, fill);
    for (unsigned int step = 0; step < 4; ++step)
      control.update();
    const Snapshot<dim> after(points, fill);

    const auto                    change = control.account();
    std::map<std::string, double> account(change.begin(), change.end());
    const auto                   &a = before.ledger, &b = after.ledger;
    constexpr double              ppm = 1e6;
    TableRow row(std::to_string(dim) + "D " + name, name_width);
    for (const Snapshot<dim> *state : {&before, &after})
      {
        row.score(state->ids.size());
        row.add(std::to_string(static_cast<int>(state->fewest)) + "-" +
                std::to_string(static_cast<int>(state->most)));
        row.score(state->uneven);
        row.score(state->fullest);
      }
    row.verdict(std::abs(b.mass - 93.75) < 1e-10);
    row.verdict(std::abs(after.volume - before.volume) < 1e-12);
    row.verdict(are_fields_exact(points));
    row.digits(ppm * (b.momentum - a.momentum).norm() / a.momentum.norm());
    row.digits(ppm * (b.spin - a.spin).norm() / a.spin.norm());
    row.digits(ppm * (b.energy / a.energy - 1.));
    row.verdict(is_account_right(account, name, before, after));
    row.verdict(are_ids_right(before, after, account["points split [-]"]));
    print(row.text.str());
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  print("Before and after: points, how many in a cell, rms deviation of the "
        "nodal fill from 1 and its largest value. Kept: mass, volume,\n"
        "linear velocity and constant pressure of the points. Change of "
        "momentum, spin, energy [millionths]; its account; ids.");
  TableRow head("", name_width);
  for (const char *name : {"points",
                           "in cell",
                           "uneven",
                           "fullest",
                           "points",
                           "in cell",
                           "uneven",
                           "fullest",
                           "mass",
                           "volume",
                           "fields",
                           "mv",
                           "spin",
                           "energy",
                           "account",
                           "ids"})
    head.add(name);
  print(head.text.str());
  seiche::PointControlParameters shifting, reseeding;
  shifting.sweeps     = 3;
  reseeding.reseeding = true;
  reseeding.fewest    = 8;
  reseeding.most      = 16;
  test<2>("shifting", shifting);
  test<2>("splitting", reseeding);
  reseeding.fewest = 4;
  reseeding.most   = 9;
  test<2>("merging", reseeding);
  shifting.reseeding = true;
  shifting.fewest    = 9;
  shifting.most      = 18;
  test<2>("both", shifting);
  reseeding.fewest = 24;
  reseeding.most   = 48;
  test<3>("splitting", reseeding);
  reseeding.fewest = 14;
  reseeding.most   = 28;
  test<3>("merging", reseeding);
  shifting.reseeding = false;
  test<3>("shifting", shifting);
}
