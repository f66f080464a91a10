// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/postprocess/wall_forces.h>
#include <seiche/postprocess/wall_names.h>
#include <seiche/scene/wall_slack.h>
#include <seiche/utilities/axis_names.h>
#include <seiche/utilities/moment.h>
#include <seiche/utilities/over_ranks.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Names of the sides of a box.
    template <int dim>
    std::string
    side_names(const std::string &separator)
    {
      std::string names;
      for (unsigned int side = 0; side < 2 * dim; ++side)
        names += (side == 0 ? "" : separator) + side_name<dim>(side);
      return names;
    }

    /// Number of the side with that name, which there is.
    template <int dim>
    unsigned int
    side_called(const std::string &name)
    {
      unsigned int side = 0;
      while (name != side_name<dim>(side))
        ++side;
      return side;
    }

    /// Whether a node lies on that face of a box; "all" is any place.
    template <int dim>
    bool
    lies_on(const Point<dim>       &x,
            const std::string      &face,
            const Point<dim>       &lower,
            const Point<dim>       &upper,
            const BoundingBox<dim> &domain,
            const unsigned int      component)
    {
      if (face == "all")
        return true;
      const BoxFace      side  = side_called<dim>(face);
      const unsigned int d     = side.direction();
      const double       place = side.is_upper() ? upper[d] : lower[d];
      return component == d &&
             std::abs(x[d] - place) <= wall_slack(domain.side_length(d));
    }

    /// True if that face of an obstacle lies on a side of the domain.
    template <int dim>
    bool
    touches_side(const Wall<dim>        &box,
                 const std::string      &face,
                 const BoundingBox<dim> &domain)
    {
      const BoxFace      side = side_called<dim>(face);
      const unsigned int d    = side.direction();
      const auto         at   = domain.get_boundary_points();
      return std::abs(side.is_upper() ? box.upper_corner[d] - at.second[d] :
                                        box.lower_corner[d] - at.first[d]) <=
             wall_slack(domain.side_length(d));
    }
  } // namespace

  template <int dim>
  void
  ForceParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Walls",
                      walls,
                      "Sides of the domain (" + side_names<dim>(", ") +
                        ") and names of obstacles and solids whose forces are "
                        "added.",
                      Patterns::List(Patterns::Anything()),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Face",
                      face,
                      "For obstacles only: count the normal force on this "
                      "face alone.",
                      Patterns::Selection("all|" + side_names<dim>("|")));
    prm.add_parameter("Reference point",
                      reference_point,
                      "Point about which the moment is taken. [m]");
  }

  template <int dim>
  void
  ForceParameters<dim>::check(const InputFile           &input,
                              const GridParameters<dim> &grid) const
  {
    const std::vector<std::string> known = wall_names(grid);
    const std::string path = std::string(kind) + " " + name + "/Walls";
    input.require(!walls.empty(),
                  path,
                  "at least one wall is needed. Walls are " +
                    quoted_list(known) + ".");
    for (auto wall = walls.begin(); wall != walls.end(); ++wall)
      {
        const std::string hint = nearest_hint(*wall, known);
        const auto        id   = std::find(known.begin(), known.end(), *wall);
        input.require(id != known.end(),
                      path,
                      "there is no wall \"" + *wall + "\"" +
                        (hint.empty() ? "." : hint) + " Walls are " +
                        quoted_list(known) + ".");
        require_no_seam(input, grid, path, *wall);
        const std::size_t number = id - known.begin();
        input.require(face == "all" || (number < grid.walls.size() &&
                                        !grid.walls[number].is_side()),
                      std::string(kind) + " " + name + "/Face",
                      "only obstacles have faces, and \"" + *wall +
                        "\" is none; set it to \"all\" or name obstacles "
                        "alone.");
        if (face != "all")
          input.require(!touches_side(grid.walls[number], face, grid.domain()),
                        std::string(kind) + " " + name + "/Face",
                        "this face of \"" + *wall +
                          "\" lies on a side of the domain, where no water "
                          "gets to it; choose another face, or all.");
        input.require(std::find(walls.begin(), wall, *wall) == wall,
                      path,
                      "the wall \"" + *wall +
                        "\" is named twice; name it once.");
      }
  }

  template <int dim>
  std::vector<std::string>
  ForceParameters<dim>::columns() const
  {
    std::vector<std::string> names;
    for (unsigned int d = 0; d < dim; ++d)
      names.push_back("force " + name + " " + axis_names[d] + " [N]");
    for (unsigned int d = 3 - n_rotations<dim>; d < 3; ++d)
      names.push_back("moment " + name + " " + axis_names[d] + " [N m]");
    return names;
  }

  template <int dim>
  WallForces<dim>::WallForces(const std::vector<Parameters>   &parameters,
                              const PostprocessorContext<dim> &context)
    : forces(parameters)
    , grid(context.grid)
    , forces_of_wall(wall_names(grid.parameters).size())
  {
    const std::vector<std::string> names = wall_names(grid.parameters);
    for (unsigned int f = 0; f < forces.size(); ++f)
      for (const std::string &wall : forces[f].walls)
        forces_of_wall[std::find(names.begin(), names.end(), wall) -
                       names.begin()]
          .push_back(f);
  }

  template <int dim>
  bool
  WallForces<dim>::counts(const ForceParameters<dim> &force,
                          const unsigned int          wall,
                          const Point<dim>           &x,
                          const unsigned int          component) const
  {
    if (grid.parameters.walls[wall].is_side())
      return force.face == "all";
    const auto &box = grid.parameters.walls[wall];
    return lies_on(x,
                   force.face,
                   box.lower_corner,
                   box.upper_corner,
                   grid.parameters.domain(),
                   component);
  }

  template <int dim>
  void
  WallForces<dim>::collect_shares(const Occupancy<dim> &occupancy)
  {
    shares.clear();
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      {
        // that fix a component: normal to it, and along it
        std::array<unsigned int, dim> n_normal{}, n_along{};
        for (const auto &entry : occupancy.constraints.walls_at(node))
          ++(entry.is_normal ? n_normal : n_along)[entry.component];
        for (const auto &entry : occupancy.constraints.walls_at(node))
          {
            const unsigned int c = entry.component;
            if (!entry.is_normal && n_normal[c] > 0)
              continue; // most of it is pressure
            const unsigned int n = n_normal[c] > 0 ? n_normal[c] : n_along[c];
            for (const unsigned int f : forces_of_wall[entry.wall])
              if (counts(
                    forces[f], entry.wall, occupancy.nodes.position(node), c))
                shares.push_back({f, node, c, 1. / n});
          }
      }
    generation = occupancy.nodes.generation();
  }

  template <int dim>
  void
  WallForces<dim>::execute(const StepView<dim> &view,
                           StatisticsTable     &statistics)
  {
    if (generation != view.occupancy.nodes.generation())
      collect_shares(view.occupancy);

    constexpr unsigned int n = dim + n_rotations<dim>;
    std::vector<double>    sums(n * forces.size(), 0.);
    // what acts on the fluid at a node; its opposite acts on the wall
    const auto subtract_at = [&](const unsigned int    f,
                                 const Point<dim>     &place,
                                 const Tensor<1, dim> &force) {
      double *sum = &sums[n * f];
      for (unsigned int d = 0; d < dim; ++d)
        sum[d] -= force[d];
      const auto turn = moment(place - forces[f].reference_point, force);
      for (unsigned int r = 0; r < turn.size(); ++r)
        sum[dim + r] -= turn[r];
    };
    const auto subtract = [&](const unsigned int    f,
                              const unsigned int    node,
                              const Tensor<1, dim> &force) {
      Point<dim> place = view.occupancy.nodes.position(node);
      for (unsigned int d = 0; d < dim; ++d)
        place[d] +=
          view.theta * view.state.displacement().local_element(dim * node + d);
      subtract_at(f, place, force);
    };
    for (const Share &share : shares)
      {
        Tensor<1, dim>     force;
        const unsigned int i = dim * share.node + share.component;
        force[share.component] =
          share.part * (view.state.reaction.local_element(i) +
                        view.state.start_reaction.local_element(i));
        subtract(share.force, share.node, force);
      }
    for (const auto &drag : view.state.drags)
      for (const unsigned int f : forces_of_wall[drag.wall])
        if (forces[f].face == "all")
          subtract(f, drag.node, drag.force);
    view.state.for_each_solid_reaction([&](const auto &reaction) {
      for (const unsigned int f :
           forces_of_wall[place_of_solid(grid.parameters, reaction.solid)])
        subtract_at(f, reaction.place, reaction.force);
    });
    sum_over_ranks(sums, view.points.communicator);

    if (view.step == 0) // nothing has pushed yet
      std::fill(sums.begin(),
                sums.end(),
                std::numeric_limits<double>::quiet_NaN());
    auto sum = sums.begin();
    for (const auto &force : forces)
      for (const std::string &column : force.columns())
        statistics.set(column, *sum++);
  }

  template struct ForceParameters<2>;
  template struct ForceParameters<3>;
  template class WallForces<2>;
  template class WallForces<3>;
} // namespace seiche
