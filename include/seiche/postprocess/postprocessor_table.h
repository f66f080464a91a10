// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_postprocessor_table_h
#define seiche_postprocess_postprocessor_table_h

#include <seiche/postprocess/error_norms.h>
#include <seiche/postprocess/front_position.h>
#include <seiche/postprocess/mean_level.h>
#include <seiche/postprocess/postprocessor_row.h>
#include <seiche/postprocess/probes.h>
#include <seiche/postprocess/run_up.h>
#include <seiche/postprocess/tracked_points.h>
#include <seiche/postprocess/wall_forces.h>
#include <seiche/postprocess/water_level.h>

#include <tuple>

namespace seiche
{
  /// THE table of the postprocessors that a scene chooses: one row a kind, in
  /// the order of their columns.
  template <int dim>
  using PostprocessorTable =
    std::tuple<BySubsections<dim, FrontPosition<dim>>,
               BySubsections<dim, WaterLevel<dim>>,
               BySubsections<dim, RunUp<dim>>,
               ByEntry<dim, MeanLevel<dim>, &OutputParameters::mean_level>,
               BySubsections<dim, Probes<dim>>,
               BySubsections<dim, TrackedPoints<dim>>,
               BySubsections<dim, WallForces<dim>>,
               BySubsections<dim, ErrorNorm<dim>>>;
} // namespace seiche

#endif
