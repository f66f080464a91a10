// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_quadrature_quadrature_h
#define seiche_quadrature_quadrature_h

#include <seiche/grid/cell_materials.h>
#include <seiche/grid/fill.h>
#include <seiche/points/point_cloud.h>
#include <seiche/quadrature/volume_ratio.h>
#include <seiche/utilities/lanes.h>

#include <deal.II/base/aligned_vector.h>

#include <memory>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /**
   * @brief Quadrature points of one cell (doc/theory.md (5.0f)); the weak forms
   * do not know whether they are material or Gauss points.
   */
  template <int dim>
  struct CellQuadrature
  {
    /// Points of one material: from begin up to end.
    struct Part
    {
      const Material *material = nullptr;
      unsigned int    begin = 0, end = 0;
    };

    /// Of all points; those between two parts have a negligible weight.
    unsigned int                                   size = 0;
    std::array<dealii::AlignedVector<double>, dim> unit; ///< [size] in [0,1]
    dealii::AlignedVector<double> mass;         ///< [kg], with the weight
    dealii::AlignedVector<double> volume;       ///< [m^dim] V0, with the weight
    dealii::AlignedVector<double> volume_ratio; ///< [-] J at t_n
    std::vector<Part>             parts;
    /// Measure of the full cell [m^dim] if these are its Gauss points, which
    /// serve the next such cell; else 0.
    double full_measure = 0.;

    /// The point q, or as many from q on as a Number has (Lanes).
    template <typename Number = double>
    dealii::Point<dim, Number>
    point(const unsigned int q) const
    {
      dealii::Point<dim, Number> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = load<Number>(&unit[d][q]);
      return x;
    }

    void
    clear()
    {
      size         = 0;
      full_measure = 0.;
      parts.clear();
    }

    /// The next points are of this material.
    void
    begin_part(const Material &material)
    {
      pad();
      size = (size + n_lanes_of_register - 1) / n_lanes_of_register *
             n_lanes_of_register;
      parts.push_back({&material, size, size});
    }

    /// Fill the last Lanes of the last part with a point of it, of negligible
    /// weight.
    void
    pad();

    void
    push_back(const dealii::Point<dim> &x,
              const double              point_mass,
              const double              point_volume,
              const double              ratio)
    {
      if (size == mass.size())
        grow();
      for (unsigned int d = 0; d < dim; ++d)
        unit[d][size] = x[d];
      mass[size]         = point_mass;
      volume[size]       = point_volume;
      volume_ratio[size] = ratio;
      ++size;
      parts.back().end = size;
    }

    /// action(first point, number of points, material) on each batch of Lanes.
    template <typename Action>
    void
    for_each_batch(const Action &action) const
    {
      for (const Part &part : parts)
        for (unsigned int q = part.begin; q < part.end;
             q += n_lanes_of_register)
          action(q,
                 std::min(n_lanes_of_register, part.end - q),
                 *part.material);
    }

  private:
    void
    grow();
  };

  /// prm entries of subsection "Quadrature".
  struct QuadratureParameters
  {
    std::string rule = "cut cells";

    void
    add_parameters(dealii::ParameterHandler &prm);

    QuadratureRule
    value() const;

    /// Is the inside of a free surface integrated, which may reach into cells
    /// without points?
    bool
    has_surface() const
    {
      return value() == QuadratureRule::cut_cells;
    }
  };

  /**
   * @brief Yields the quadrature of each occupied cell of the current step.
   */
  template <int dim>
  class Quadrature
  {
  public:
    virtual ~Quadrature() = default;

    /// Fill @p quadrature for an own occupied cell, and pad it. Local.
    virtual void
    get(const unsigned int cell, CellQuadrature<dim> &quadrature) const = 0;
  };

  /// Makes fill.rule: cut cells (the inside of Fill::surface(), and its loose
  /// points) or material points (the founding paper's). @p ratio: what points
  /// have as volume_ratio that are no material ones. References must outlive
  /// the object.
  template <int dim>
  std::unique_ptr<Quadrature<dim>>
  make_quadrature(const PointCloud<dim>    &points,
                  const Fill<dim>          &fill,
                  const CellMaterials<dim> &materials,
                  const VolumeRatio         ratio);
} // namespace seiche

#endif
