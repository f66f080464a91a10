// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_level_nearby_h
#define seiche_grid_level_nearby_h

#include <deal.II/base/tensor.h>

#include <functional>
#include <vector>

namespace seiche
{
  /// The level set at a node about another one.
  template <int dim>
  struct LevelNearby
  {
    dealii::Tensor<1, dim> way; ///< to it [cells]
    double                 level;
    bool                   counts = true;
  };

  /**
   * @brief Level set of a node, a distance in cells, by the plane of slope one
   * through those about it, at least one (doc/theory.md, section 8).
   *
   * One near the end of the level set says that it is there or beyond, for
   * there (5.0b) has an infinite slope. If all lie on one side of the node and
   * are dry, they tell nothing of a film between: @p of_own_fluid does, the
   * level by the fluid at the node below a plane of this gradient, or the most
   * that it may be.
   */
  template <int dim>
  double
  level_from(std::vector<LevelNearby<dim>>                  &nearby,
             const std::function<double(const dealii::Tensor<1, dim> &gradient,
                                        const double most)> &of_own_fluid);
} // namespace seiche

#endif
