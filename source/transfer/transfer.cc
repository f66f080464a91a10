// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/transfer.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <array>

namespace seiche
{
  namespace
  {
    /// THE table of transfers.
    constexpr std::array<TransferMethod, 6> transfer_table = {
      {{"PIC", false, VelocityUpdate::pic, "points adopt the grid's velocity"},
       {"FLIP",
        false,
        VelocityUpdate::flip_increment,
        "points add the increment of the grid's velocity"},
       {"FLIP acceleration",
        false,
        VelocityUpdate::flip_acceleration,
        "points add dt times the mean of old and new acceleration"},
       {"PIC/FLIP blend",
        false,
        VelocityUpdate::blend,
        "\"FLIP fraction\" of FLIP and the rest of PIC"},
       {"APIC",
        true,
        VelocityUpdate::pic,
        "PIC with a velocity gradient at the points"},
       {"affine FLIP",
        true,
        VelocityUpdate::flip_increment,
        "FLIP with a velocity gradient at the points, used from points to "
        "grid"}}};
  } // namespace



  const TransferMethod &
  transfer_method(const std::string &name)
  {
    for (const TransferMethod &method : transfer_table)
      if (name == method.name)
        return method;
    Assert(false, dealii::ExcMessage("Unknown transfer: " + name));
    return transfer_table.back();
  }



  void
  TransferParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    std::string names, text = "How velocities pass between points and grid.";
    for (const TransferMethod &entry : transfer_table)
      {
        names += (names.empty() ? "" : "|") + std::string(entry.name);
        text += std::string(" ") + entry.name + ": " + entry.description + ".";
      }
    prm.enter_subsection("Transfer");
    prm.add_parameter("Method",
                      method,
                      text,
                      dealii::Patterns::Selection(names));
    prm.add_parameter("FLIP fraction",
                      flip_fraction,
                      "Share of FLIP in the method \"PIC/FLIP blend\". [-]",
                      dealii::Patterns::Double(0., 1.));
    prm.leave_subsection();
  }



  void
  TransferParameters::check(const InputFile &) const
  {
    transfer_method(method);
  }



  std::string
  StepCheck::problem(const double limit) const
  {
    // below this a cell folds over soon; numerics in doc/theory.md
    constexpr double least_det_F = 0.2;
    if (!finite)
      return "a point's new position or velocity is not finite";
    if (min_det_F < least_det_F)
      return fmt::format("a point's volume changes by the factor {:.3g}",
                         min_det_F);
    if (max_displacement > limit)
      return fmt::format("a point moves by {:.3g} cells", max_displacement);
    return "";
  }



  template <int dim>
  Transfer<dim>::Transfer(const TransferParameters &transfer_parameters,
                          const Occupancy<dim>     &grid_occupancy)
    : parameters(transfer_parameters)
    , method(transfer_method(transfer_parameters.method))
    , occupancy(grid_occupancy)
  {
    AssertThrow(grid_occupancy.fe.degree == 1,
                dealii::ExcMessage("Transfers exist for FE_Q(1) only."));
  }



  template <int dim>
  std::set<PointColumn>
  Transfer<dim>::columns(const TransferParameters &parameters)
  {
    const TransferMethod &method = transfer_method(parameters.method);
    std::set<PointColumn> result;
    if (method.affine)
      result.insert(PointColumn::velocity_gradient);
    if (method.update == VelocityUpdate::flip_acceleration)
      result.insert(PointColumn::acceleration);
    return result;
  }



  template class Transfer<2>;
  template class Transfer<3>;
} // namespace seiche
