// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
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
    constexpr std::array<TransferMethod, 10> transfer_table = {
      {{"PIC",
        GradientUse::none,
        false,
        VelocityUpdate::pic,
        "harlow1964",
        "points adopt the grid's velocity"},
       {"FLIP",
        GradientUse::none,
        false,
        VelocityUpdate::flip_increment,
        "brackbill1986",
        "points add the increment of the grid's velocity"},
       {"FLIP acceleration",
        GradientUse::none,
        false,
        VelocityUpdate::flip_acceleration,
        "brackbill1986",
        "points add dt times the mean of old and new acceleration, and what "
        "walls and projection do to the grid's velocity at the start"},
       {"PIC/FLIP blend",
        GradientUse::none,
        false,
        VelocityUpdate::blend,
        "brackbill1986",
        "\"FLIP fraction\" of FLIP and the rest of PIC"},
       {"APIC",
        GradientUse::carried,
        false,
        VelocityUpdate::pic,
        "jiang2017",
        "PIC with a velocity gradient at the points (in the configuration at "
        "the end of the step)"},
       {"TPIC",
        GradientUse::carried,
        true,
        VelocityUpdate::pic,
        "nakamura2023",
        "the same with the gradient in the configuration at its start, as "
        "published"},
       {"affine FLIP",
        GradientUse::carried,
        false,
        VelocityUpdate::flip_increment,
        "brackbill1986 jiang2017",
        "FLIP with a velocity gradient at the points, used from points to "
        "grid"},
       {"Taylor least squares",
        GradientUse::fitted,
        false,
        VelocityUpdate::flip_increment,
        "wobbes2019",
        "FLIP; from points to grid the points of a cell pass on the linear "
        "field closest to their velocities"},
       {"XPIC",
        GradientUse::none,
        false,
        VelocityUpdate::xpic,
        "hammerquist2017",
        "FLIP without the part of the points' velocities that \"Order\" "
        "passes to the grid and back do not see"},
       {"FMPM",
        GradientUse::none,
        false,
        VelocityUpdate::fmpm,
        "nairn2021",
        "PIC with \"Order\" terms of a series for the inverse of the full "
        "mass matrix"}}};
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



  std::vector<std::string>
  transfer_names()
  {
    std::vector<std::string> names;
    for (const TransferMethod &method : transfer_table)
      names.emplace_back(method.name);
    return names;
  }



  void
  TransferParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    std::string text = "How velocities pass between points and grid.";
    for (const TransferMethod &entry : transfer_table)
      text += std::string(" ") + entry.name + ": " + entry.description + ".";
    prm.enter_subsection("Transfer");
    prm.add_parameter("Method",
                      method,
                      text,
                      dealii::Patterns::Selection(
                        fmt::format("{}", fmt::join(transfer_names(), "|"))));
    prm.add_parameter("FLIP fraction",
                      flip_fraction,
                      "Share of FLIP in the method \"PIC/FLIP blend\". [-]",
                      dealii::Patterns::Double(0., 1.));
    prm.add_parameter("Order",
                      order,
                      "Order of XPIC and FMPM: 1 is PIC, large ones come close "
                      "to FLIP without its noise. [-]",
                      dealii::Patterns::Integer(1, 1000));
    prm.add_parameter("Mass",
                      mass,
                      "Mass matrix from points to grid. lumped; consistent: "
                      "nodal velocities are those closest to the points', one "
                      "solve a step, without the affine parts of Method; "
                      "automatic: lumped in cells of degree 1, which with "
                      "Element degree 2 are those at the surface, consistent "
                      "in cells of degree 2.",
                      dealii::Patterns::Selection(
                        "automatic|lumped|consistent"));
    prm.leave_subsection();
  }



  void
  TransferParameters::check(const InputFile   &input,
                            const unsigned int degree,
                            const unsigned int points_per_direction) const
  {
    const VelocityUpdate update = transfer_method(method).update;
    input.cites(transfer_method(method).papers);
    const bool is_series =
      update == VelocityUpdate::xpic || update == VelocityUpdate::fmpm;
    input.read_only_if(update == VelocityUpdate::blend,
                       "Transfer/FLIP fraction",
                       "Transfer/Method = PIC/FLIP blend");
    input.read_only_if(is_series,
                       "Transfer/Order",
                       "Transfer/Method = XPIC or FMPM");
    input.require(degree == 1 || !is_series,
                  "Transfer/Method",
                  "the series of XPIC and FMPM need Formulation/Element degree "
                  "= 1; with degree 2 choose another Method, such as FLIP");
    input.require(!is_consistent(degree) || !is_series,
                  "Transfer/Mass",
                  "the series of XPIC and FMPM come near to the consistent "
                  "mass, with which Transfer/Order is without effect: set it "
                  "to lumped, or another Method");
    input.require(!is_consistent(degree) || points_per_direction > degree,
                  "Points/Per cell and direction",
                  fmt::format("the consistent mass of elements of degree {} "
                              "needs {} at least",
                              degree,
                              degree + 1));
  }



  template <int dim>
  Transfer<dim>::Transfer(const TransferParameters &transfer_parameters,
                          const Fill<dim>          &grid_fill,
                          const CellMaterials<dim> &cell_materials,
                          const VolumeUpdate        volume_update)
    : parameters(transfer_parameters)
    , method(transfer_method(transfer_parameters.method))
    , fill(grid_fill)
    , occupancy(grid_fill.occupancy)
    , materials(cell_materials)
    , mean_volume(volume_update == VolumeUpdate::nodal_mean)
  {}



  template <int dim>
  std::set<PointColumn>
  Transfer<dim>::columns(const TransferParameters &parameters)
  {
    const TransferMethod &method = transfer_method(parameters.method);
    std::set<PointColumn> result;
    if (method.gradient == GradientUse::carried)
      result.insert(PointColumn::velocity_gradient);
    if (method.update == VelocityUpdate::flip_acceleration)
      result.insert(PointColumn::acceleration);
    return result;
  }



  template class Transfer<2>;
  template class Transfer<3>;
} // namespace seiche
