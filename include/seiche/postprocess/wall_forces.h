// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_wall_forces_h
#define seiche_postprocess_wall_forces_h

#include <seiche/postprocess/postprocessor.h>
#include <seiche/postprocess/postprocessor_context.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of "Force NAME".
  template <int dim>
  struct ForceParameters
  {
    static constexpr const char *kind = "Force";

    std::string              name;
    std::vector<std::string> walls;           ///< names of sides and obstacles
    std::string              face = "all";    ///< of obstacles
    dealii::Point<dim>       reference_point; ///< of the moment [m]

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const GridParameters<dim> &grid) const;
    std::vector<std::string>
    columns() const;
  };

  /**
   * @brief Force and moment of the fluid on walls and obstacles, from the
   * nodal reactions of the start velocity and of the converged step, and the
   * drag of friction.
   *
   * A component of the reaction at a node belongs to the walls normal to it,
   * in equal parts if there are several; where there are none, to those along
   * it. Drag is known by wall and no part of a face's normal force. Forces act
   * at the nodes in the configuration of the forces, x_n + theta u. 2D: per
   * metre of depth.
   */
  template <int dim>
  class WallForces : public Postprocessor<dim>
  {
  public:
    using Parameters = ForceParameters<dim>;

    WallForces(const std::vector<Parameters>   &parameters,
               const PostprocessorContext<dim> &context);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

  private:
    /// A share of a reaction component that counts for a force.
    struct Share
    {
      unsigned int force;
      unsigned int node; // own
      unsigned int component;
      double       part;
    };

    /// Whether a component of the reaction at a node on that wall counts.
    bool
    counts(const ForceParameters<dim> &force,
           const unsigned int          wall,
           const dealii::Point<dim>   &x,
           const unsigned int          component) const;

    void
    collect_shares(const Occupancy<dim> &occupancy);

    const std::vector<ForceParameters<dim>> forces;
    const BackgroundGrid<dim>              &grid;
    std::vector<std::vector<unsigned int>>  forces_of_wall; // by boundary id

    unsigned int       generation = static_cast<unsigned int>(-1);
    std::vector<Share> shares; // of this generation of the numbering
  };
} // namespace seiche

#endif
