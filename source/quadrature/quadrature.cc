// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/quadrature/quadrature.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/quadrature_lib.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class MaterialPoints : public Quadrature<dim>
    {
    public:
      explicit MaterialPoints(const PointCloud<dim> &points)
        : points(points)
      {}

      void
      get(const unsigned int   cell,
          CellQuadrature<dim> &quadrature) const override
      {
        quadrature.clear();
        append(cell, 1., quadrature);
      }

      /// The cell's points with a common weight.
      void
      append(const unsigned int   cell,
             const double         weight,
             CellQuadrature<dim> &quadrature) const
      {
        const double *mass   = points.data(PointColumn::mass);
        const double *volume = points.data(PointColumn::initial_volume);
        const double *ratio  = points.data(PointColumn::volume_ratio);
        for (std::size_t p = points.first_point(cell);
             p < points.first_point(cell + 1);
             ++p)
          quadrature.push_back(points.locator.to_unit(cell, points.position(p)),
                               weight * mass[p],
                               weight * volume[p],
                               ratio[p]);
      }

    private:
      const PointCloud<dim> &points;
    };

    template <int dim>
    class Hybrid : public Quadrature<dim>
    {
    public:
      Hybrid(const PointCloud<dim> &points,
             const Fill<dim>       &fill,
             const double           density,
             const bool             incompressible)
        : points(points)
        , fill(fill)
        , density(density)
        , incompressible(incompressible)
        , material_points(points)
        , gauss(fill.occupancy.fe.degree + 1)
      {}

      void
      get(const unsigned int   cell,
          CellQuadrature<dim> &quadrature) const override
      {
        const double weight = fill.gauss_weight(cell);
        quadrature.clear();
        if (weight < 1.)
          material_points.append(cell, 1. - weight, quadrature);
        if (weight > 0.)
          {
            const double measure = points.locator.measure(cell);
            const double ratio   = incompressible ? 1. : mean_ratio(cell);
            for (unsigned int q = 0; q < gauss.size(); ++q)
              {
                // the cell is the volume at t_n: V0 = V_n/J_n
                const double volume =
                  weight * measure * gauss.weight(q) / ratio;
                quadrature.push_back(gauss.point(q),
                                     density * volume,
                                     volume,
                                     ratio);
              }
          }
      }

    private:
      double
      mean_ratio(const unsigned int cell) const
      {
        const double *volume = points.data(PointColumn::initial_volume);
        const double *ratio  = points.data(PointColumn::volume_ratio);
        double        sum = 0., total = 0.;
        for (std::size_t p = points.first_point(cell);
             p < points.first_point(cell + 1);
             ++p)
          {
            sum += ratio[p] * volume[p];
            total += volume[p];
          }
        return sum / total;
      }

      const PointCloud<dim>    &points;
      const Fill<dim>          &fill;
      const double              density;
      const bool                incompressible;
      const MaterialPoints<dim> material_points;
      const QGauss<dim>         gauss;
    };
  } // namespace

  template <int dim>
  void
  CellQuadrature<dim>::grow()
  {
    const std::size_t capacity = 2 * mass.size() + 32;
    for (auto &coordinate : unit)
      coordinate.resize(capacity);
    for (auto *values : {&mass, &volume, &volume_ratio})
      values->resize(capacity);
  }

  void
  QuadratureParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Quadrature");
    prm.add_parameter("Rule",
                      rule,
                      "Quadrature of the weak forms. material points: the "
                      "points everywhere; hybrid: Gauss points in full cells, "
                      "points in the cells near the free surface",
                      Patterns::Selection("material points|hybrid"));
    prm.leave_subsection();
  }

  template <int dim>
  std::unique_ptr<Quadrature<dim>>
  make_quadrature(const QuadratureParameters &parameters,
                  const PointCloud<dim>      &points,
                  const Fill<dim>            &fill,
                  const double                density,
                  const bool                  incompressible)
  {
    if (parameters.gauss_in_full_cells())
      return std::make_unique<Hybrid<dim>>(points,
                                           fill,
                                           density,
                                           incompressible);
    return std::make_unique<MaterialPoints<dim>>(points);
  }

#define INSTANTIATE(dim)                                          \
  template struct CellQuadrature<dim>;                            \
  template std::unique_ptr<Quadrature<dim>> make_quadrature<dim>( \
    const QuadratureParameters &,                                 \
    const PointCloud<dim> &,                                      \
    const Fill<dim> &,                                            \
    const double,                                                 \
    const bool);
  INSTANTIATE(2)
  INSTANTIATE(3)
} // namespace seiche
