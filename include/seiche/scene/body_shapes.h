// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_body_shapes_h
#define seiche_scene_body_shapes_h

#include <seiche/scene/fluid_body.h>

#include <memory>
#include <string>
#include <vector>

namespace seiche
{
  /// One row of the table of shapes.
  template <int dim>
  struct BodyShape
  {
    const char              *name;
    std::vector<std::string> entries; ///< that it reads
    std::unique_ptr<Region<dim>> (*make)(
      const InputFile &,
      const FluidBodyParameters<dim> &,
      const dealii::BoundingBox<dim> &domain);
  };

  /// THE table of shapes.
  template <int dim>
  const std::vector<BodyShape<dim>> &
  body_shapes();
} // namespace seiche

#endif
