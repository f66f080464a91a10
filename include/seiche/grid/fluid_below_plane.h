// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_fluid_below_plane_h
#define seiche_grid_fluid_below_plane_h

#include <seiche/space/cell_simplices.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Where a plane surface lies by how much fluid there is in the hat of
   * a node beside a wall of a solid (doc/theory.md, section 8).
   */
  template <int dim>
  class FluidBelowPlane
  {
  public:
    /// @p fluid_in_hat: integral of the hat over the fluid [m^dim].
    explicit FluidBelowPlane(const double fluid_in_hat)
      : fluid(fluid_in_hat)
    {}

    /// A cell that is not all solid, of which the node is this vertex: its
    /// volume [m^dim], the integral of the hat over its wet part over that, the
    /// distance from the wall at its vertices [m].
    void
    add_cell(const unsigned int       vertex,
             const double             measure,
             const double             wet_hat,
             const VertexValues<dim> &wall);

    /// Level set at the node [cells], @p most or less, if the fluid lies below
    /// a plane on which the level set has this gradient [-]; sought from
    /// @p guess on. A cell below @p most, -1 at least, where the hat is full or
    /// tells nothing.
    double
    level(const dealii::Tensor<1, dim> &gradient,
          const double                  most,
          const double                  guess) const;

  private:
    struct Part
    {
      unsigned int      vertex;
      double            measure, wet_hat;
      VertexValues<dim> wall;
    };

    /// Fluid below the plane that is not there [m^dim].
    double
    missing(const dealii::Tensor<1, dim> &gradient, const double level) const;

    double            fluid;
    double            cells = 0., hat = 0.; ///< integrals [m^dim]
    std::vector<Part> parts;
  };
} // namespace seiche

#endif
