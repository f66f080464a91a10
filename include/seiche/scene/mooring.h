// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_mooring_h
#define seiche_scene_mooring_h

#include <seiche/scene/catenary.h>
#include <seiche/scene/rigid_motion.h>

#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief A line between a body and the ground, quasi-static: its form is that
   * of equilibrium at each time (doc/theory.md (8.14)). The last coordinate
   * points upwards.
   */
  template <int dim>
  struct Mooring
  {
    std::string        name;
    dealii::Point<dim> fairlead; ///< on the body, as it lies at t = 0 [m]
    dealii::Point<dim> anchor;   ///< [m]
    bool               on_ground = true; ///< there is level ground at it
    Catenary           line;

    /// On a body at this place.
    Catenary::Ends
    ends(const Placement<dim> &body) const;

    /// What it does to the body, at the fairlead [N; 2D: N/m].
    dealii::Tensor<1, dim>
    force(const Placement<dim> &body) const;

    /// Columns of results: tension at the fairlead and at the anchor, length
    /// on the ground.
    static std::vector<std::string>
    columns(const std::string &name);
    std::vector<double>
    values(const Placement<dim> &body) const;
  };

  /// prm entries of "Mooring NAME".
  template <int dim>
  struct MooringParameters
  {
    static constexpr const char *kind = "Mooring";

    explicit MooringParameters(const std::string &mooring_name)
      : name(mooring_name)
    {}

    std::string name;
    std::string solid, fairlead, anchor;
    std::string ground    = "level";
    double      length    = 0.; ///< [m]
    double      weight    = 0.; ///< [N/m]
    double      stiffness = 0.; ///< [N]

    std::string
    path(const std::string &entry) const
    {
      return std::string(kind) + " " + name + "/" + entry;
    }

    /// Enters the subsection.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// InputError for what is no line.
    Mooring<dim>
    make(const InputFile &input) const;
  };
} // namespace seiche

#endif
