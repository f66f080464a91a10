// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/quadrature/quadrature.h>
#include <seiche/quadrature/volume_ratio.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <map>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class MaterialPoints : public Quadrature<dim>
    {
    public:
      MaterialPoints(const PointCloud<dim>    &points,
                     const CellMaterials<dim> &materials,
                     const VolumeRatio         ratio)
        : points(points)
        , materials(materials)
        , ratio(ratio)
      {}

      void
      get(const unsigned int   cell,
          CellQuadrature<dim> &quadrature) const override
      {
        quadrature.clear();
        append(
          cell, [](const std::size_t) { return 1.; }, quadrature);
        quadrature.pad();
      }

      /// The cell's points, material by material; @p share of a point, which
      /// may be zero, by its number in the cell.
      template <typename Share>
      void
      append(const unsigned int   cell,
             const Share         &share,
             CellQuadrature<dim> &quadrature) const
      {
        if (!materials.is_mixed(cell))
          {
            append_part(cell, materials.of_cell(cell), share, quadrature);
            return;
          }
        for (const Material &material : materials.all())
          append_part(cell, material, share, quadrature);
      }

    private:
      template <typename Share>
      void
      append_part(const unsigned int   cell,
                  const Material      &material,
                  const Share         &share,
                  CellQuadrature<dim> &quadrature) const
      {
        const double *mass   = points.data(PointColumn::mass);
        const double *volume = points.data(PointColumn::initial_volume);
        const double *J_p    = points.data(PointColumn::volume_ratio);
        const bool    is_all = !materials.is_mixed(cell);
        const auto    first  = points.first_point(cell);
        bool          begun  = false;
        for (const std::size_t p : points.points_in(cell))
          if (const double weight = share(p - first);
              weight > 0. &&
              (is_all || &materials.of_point(points, p) == &material))
            {
              if (!begun)
                quadrature.begin_part(material);
              begun = true;
              quadrature.push_back(points.locator.cells.geometry(cell).to_unit(
                                     points.position(p)),
                                   weight * mass[p],
                                   weight * volume[p],
                                   ratio == VolumeRatio::one ? 1. : J_p[p]);
            }
      }

      const PointCloud<dim>    &points;
      const CellMaterials<dim> &materials;
      const VolumeRatio         ratio;
    };

    /// The inside of the free surface: Gauss points in full cells, as many in
    /// cut ones; and the loose points.
    template <int dim>
    class CutCells : public Quadrature<dim>
    {
    public:
      CutCells(const PointCloud<dim>    &points,
               const Fill<dim>          &fill,
               const CellMaterials<dim> &materials,
               const VolumeRatio         ratio)
        : points(points)
        , fill(fill)
        , materials(materials)
        , ratio(ratio)
        , material_points(points, materials, ratio)
        , gauss(fill.occupancy.fe.degree + 1)
      {}

      void
      get(const unsigned int   cell,
          CellQuadrature<dim> &quadrature) const override
      {
        if (fill.is_full(cell) && !materials.is_mixed(cell))
          get_full(cell, quadrature);
        else
          get_parts(cell, quadrature);
        quadrature.pad();
      }

    private:
      void
      get_full(const unsigned int cell, CellQuadrature<dim> &quadrature) const
      {
        const Material  &material = materials.of_cell(cell);
        const double     measure  = points.locator.cells.geometry(cell).measure;
        const bool       is_equal = ratio == VolumeRatio::one;
        constexpr double same     = 1e-12; // equal cells, in the last digits
        if (is_equal &&
            std::abs(quadrature.full_measure - measure) < same * measure &&
            quadrature.parts[0].material == &material)
          return;
        quadrature.clear();
        quadrature.begin_part(material);
        add_inside(cell, measure, ratio_of(points, cell, ratio), quadrature);
        quadrature.full_measure = is_equal ? measure : 0.;
      }

      /// Where materials meet each has its share of the inside, everywhere in
      /// the cell, and all have the mean density: a pressure without a kink in
      /// the cell balances the weight then, at every node.
      void
      get_parts(const unsigned int cell, CellQuadrature<dim> &quadrature) const
      {
        quadrature.clear();
        if (const double *loose = fill.loose_shares(points, cell))
          material_points.append(
            cell,
            [loose](const std::size_t p) { return loose[p]; },
            quadrature);
        const double inside = fill.surface().inside_share(cell) *
                              points.locator.cells.geometry(cell).measure;
        if (inside == 0.)
          return;
        const LinearRatio<dim> J = ratio_of(points, cell, ratio);
        if (!materials.is_mixed(cell))
          {
            if (quadrature.parts.empty())
              quadrature.begin_part(materials.of_cell(cell));
            add_inside(cell, inside, J, quadrature);
            return;
          }
        for (unsigned int m = 0; m < materials.all().size(); ++m)
          if (const double share = materials.share(m, cell); share > 0.)
            {
              quadrature.begin_part(materials.all()[m]);
              add_inside(cell, share * inside, J, quadrature);
            }
      }

      /// The points of a cell's inside, with this volume in all.
      void
      add_inside(const unsigned int      cell,
                 const double            volume,
                 const LinearRatio<dim> &J,
                 CellQuadrature<dim>    &quadrature) const
      {
        const FluidProperties fluid = materials.mean(cell);
        if (fill.is_full(cell))
          for (unsigned int q = 0; q < gauss.size(); ++q)
            add(fluid, gauss.point(q), volume * gauss.weight(q), J, quadrature);
        else
          {
            const double whole = volume / fill.inside_share(cell);
            fill.surface().for_each_point(
              cell, [&](const Point<dim> &x, const double weight) {
                add(fluid, x, weight * whole, J, quadrature);
              });
          }
      }

      /// A point that is no material one, of a volume at t_n: V0 = V_n/J_n.
      void
      add(const FluidProperties  &fluid,
          const Point<dim>       &x,
          const double            volume_n,
          const LinearRatio<dim> &J,
          CellQuadrature<dim>    &quadrature) const
      {
        const double J_q    = J.value(x);
        const double volume = volume_n / J_q;
        quadrature.push_back(x, fluid.mass(volume), volume, J_q);
      }

      const PointCloud<dim>    &points;
      const Fill<dim>          &fill;
      const CellMaterials<dim> &materials;
      const VolumeRatio         ratio;
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

  template <int dim>
  void
  CellQuadrature<dim>::pad()
  {
    constexpr double   negligible = 1e-150; // its square is a number, too
    const unsigned int n_points   = size;
    if (n_points == 0)
      return;
    const unsigned int last = n_points - 1;
    while (size % n_lanes_of_register != 0)
      push_back(point(last),
                negligible * mass[last],
                negligible * volume[last],
                volume_ratio[last]);
    size = parts.back().end = n_points;
  }

  void
  QuadratureParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Quadrature");
    prm.add_parameter(
      "Rule",
      rule,
      "Quadrature of the weak forms. cut cells: the inside of a "
      "free surface that follows from the fill of the points, "
      "as sharp as a small part of their spacing, and points "
      "in drops and thin sheets; material points: the points "
      "everywhere",
      Patterns::Selection("cut cells|material points"));
    prm.leave_subsection();
  }

  QuadratureRule
  QuadratureParameters::value() const
  {
    static const std::map<std::string, QuadratureRule> rules = {
      {"material points", QuadratureRule::material_points},
      {"cut cells", QuadratureRule::cut_cells}};
    return rules.at(rule);
  }

  template <int dim>
  std::unique_ptr<Quadrature<dim>>
  make_quadrature(const PointCloud<dim>    &points,
                  const Fill<dim>          &fill,
                  const CellMaterials<dim> &materials,
                  const VolumeRatio         ratio)
  {
    if (fill.has_surface())
      return std::make_unique<CutCells<dim>>(points, fill, materials, ratio);
    return std::make_unique<MaterialPoints<dim>>(points, materials, ratio);
  }

#define INSTANTIATE(dim)                                          \
  template struct CellQuadrature<dim>;                            \
  template std::unique_ptr<Quadrature<dim>> make_quadrature<dim>( \
    const PointCloud<dim> &,                                      \
    const Fill<dim> &,                                            \
    const CellMaterials<dim> &,                                   \
    const VolumeRatio);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
