// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/mass_and_energy.h>
#include <seiche/postprocess/tank_record.h>
#include <seiche/utilities/axis_names.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// sum m x [kg m] and sum m [kg] of all ranks. Collective.
    template <int dim>
    std::pair<Tensor<1, dim>, double>
    mass_moment_of(const PointCloud<dim> &points)
    {
      const double  *m = points.data(PointColumn::mass);
      Tensor<1, dim> moment;
      double         mass = 0.;
      for (std::size_t p = 0; p < points.size(); ++p)
        {
          mass += m[p];
          moment += m[p] * (points.position(p) - Point<dim>());
        }
      return {Utilities::MPI::sum(moment, points.communicator),
              Utilities::MPI::sum(mass, points.communicator)};
    }
  } // namespace

  template <int dim>
  std::vector<std::string>
  TankRecord<dim>::columns()
  {
    std::vector<std::string> names;
    if (dim == 2)
      names = {"tank angle [rad]"};
    else
      names = {"tank roll [rad]", "tank pitch [rad]", "tank yaw [rad]"};
    for (unsigned int d = 0; d < dim; ++d)
      names.push_back(std::string("tank displacement ") + axis_names[d] +
                      " [m]");
    names.emplace_back("tank work [J]");
    return names;
  }

  template <int dim>
  std::vector<std::string>
  TankRecord<dim>::summary_numbers()
  {
    return {"ledger/tank_work", "ledger/momentum_imbalance_max"};
  }

  template <int dim>
  void
  TankRecord<dim>::execute(const StepView<dim> &view,
                           StatisticsTable     &statistics)
  {
    const auto [moment_now, mass_now] = mass_moment_of(view.points);
    if (view.step > 0)
      {
        // gravity changed from one direction to the other while the fluid
        // went from one place to the other
        const Tensor<1, dim> mean = 0.5 * (gravity + view.gravity);
        const Tensor<1, dim> arm =
          0.5 * (mass_moment + moment_now) -
          0.5 * (mass + mass_now) * MassAndEnergy<dim>::zero_of_potential(view);
        const StepBalance<dim> &step = view.balance;
        total_work += step.body_work - mean * step.mass_moment -
                      arm * (view.gravity - gravity);
        const double scale = std::max(step.body.norm(), step.inertia.norm());
        if (scale > 0.)
          largest_imbalance =
            std::max(largest_imbalance, step.imbalance().norm() / scale);
      }
    gravity     = view.gravity;
    mass_moment = moment_now;
    mass        = mass_now;

    const TankPose<dim> &pose   = *view.tank;
    std::vector<double>  values = {pose.angles.begin(), pose.angles.end()};
    values.insert(values.end(),
                  pose.displacement.begin_raw(),
                  pose.displacement.end_raw());
    values.push_back(total_work);
    static const std::vector<std::string> names = columns();
    for (unsigned int c = 0; c < names.size(); ++c)
      statistics.set(names[c], values[c]);
  }

  template <int dim>
  void
  TankRecord<dim>::finish(const StatisticsTable & /*statistics*/,
                          nlohmann::ordered_json &summary)
  {
    summary["ledger"]["tank_work"]              = total_work;
    summary["ledger"]["momentum_imbalance_max"] = largest_imbalance;
  }

  template <int dim>
  void
  TankRecord<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("tank", [&]() {
      archive("work", total_work);
      archive("largest imbalance", largest_imbalance);
      archive("mass", mass);
      for (unsigned int d = 0; d < dim; ++d)
        {
          archive("gravity " + std::string(axis_names[d]), gravity[d]);
          archive("mass moment " + std::string(axis_names[d]), mass_moment[d]);
        }
    });
  }

  template class TankRecord<2>;
  template class TankRecord<3>;
} // namespace seiche
