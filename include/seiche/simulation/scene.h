// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_scene_h
#define seiche_simulation_scene_h

#include <seiche/formulation/formulation.h>
#include <seiche/formulation/free_surface_parameters.h>
#include <seiche/grid/point_control.h>
#include <seiche/grid/time_scheme.h>
#include <seiche/materials/fluid_parameters.h>
#include <seiche/parameters/input_file.h>
#include <seiche/points/seeding.h>
#include <seiche/postprocess/postprocessor_list.h>
#include <seiche/quadrature/quadrature.h>
#include <seiche/scene/background_grid.h>
#include <seiche/scene/body_force.h>
#include <seiche/scene/fluid_body.h>
#include <seiche/scene/time_table.h>
#include <seiche/simulation/checkpoint_schedule.h>
#include <seiche/solve/linear_solver.h>
#include <seiche/solve/newton.h>
#include <seiche/solve/time_stepper.h>
#include <seiche/transfer/transfer.h>

#include <vector>

namespace seiche
{
  /**
   * @brief All parameters of a run: one struct a topic, each declared where it
   * is used. Constant after check().
   */
  template <int dim>
  struct Scene
  {
    /// Finds the instances (bodies, obstacles, probes). @p input must outlive
    /// the scene.
    explicit Scene(const InputFile &input);

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// After parsing. Throws InputError for what does not fit together.
    void
    check(const InputFile &input);

    /// The scene must outlive it. Throws InputError.
    TankMotion<dim>
    make_tank_motion() const;

    VolumeUpdate
    volume_update() const;

    FilledVolume
    filled_volume() const;

    /// Names of the further materials, of numbers 1 on.
    std::vector<std::string>
    material_names() const;

    /// Columns that the points need beyond the always present ones.
    std::set<PointColumn>
    point_columns() const;

    /// Columns of statistics.csv that Simulation sets itself, in their order.
    std::vector<std::string>
    simulation_columns() const;

    /// Paths of the numbers of summary.json that Simulation sets itself.
    std::vector<std::string>
    summary_numbers() const;

    const InputFile &input;

    GridParameters<dim>                   grid;
    std::vector<TableParameters>          tables;
    BodyForceParameters<dim>              body_force;
    TankMotionParameters<dim>             tank_motion;
    FluidParameters                       fluid;
    std::vector<MaterialParameters>       further_materials;
    std::vector<Material>                 materials; ///< of all, by number
    std::vector<ShapeParameters<dim>>     shapes;    ///< parts of others
    std::vector<SolidParameters<dim>>     solids;
    std::vector<MooringParameters<dim>>   moorings;
    std::vector<FluidBodyParameters<dim>> bodies;
    SeedingParameters                     seeding;
    PointControlParameters                point_control;
    FormulationParameters                 formulation;
    QuadratureParameters                  quadrature;
    FreeSurfaceParameters                 free_surface;
    VolumeParameters                      volume;
    TimeStepParameters                    time;
    TimeSchemeParameters                  time_scheme;
    TransferParameters                    transfer;
    NewtonParameters                      newton;
    LinearSolverParameters                linear_solver;
    CheckpointParameters                  checkpoint;
    PostprocessorList<dim>                postprocessors;
    bool                                  test_log = false;

  private:
    /// Is there a pressure to which volumes of the end of a step belong?
    bool
    has_pressure_of_end() const;

    /// Of choices that need others, which are fine.
    void
    check_choices(const InputFile &input);

    /// Fill materials; bodies and materials find each other.
    void
    check_materials(const InputFile &input);
  };
} // namespace seiche

#endif
