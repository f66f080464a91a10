// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_wall_shape_h
#define seiche_scene_wall_shape_h

#include <seiche/utilities/box_face.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace seiche
{
  /**
   * @brief The surface of a wall, as a signed distance.
   */
  template <int dim>
  class WallShape
  {
  public:
    virtual ~WallShape() = default;

    /// [m], positive in the fluid and negative behind the wall.
    virtual double
    distance(const dealii::Point<dim> &x) const = 0;

    /// Unit vector into the fluid at the place of the wall nearest to @p x: the
    /// gradient of the distance.
    virtual dealii::Tensor<1, dim>
    normal(const dealii::Point<dim> &x) const = 0;
  };

  /**
   * @brief A side of the domain's box: the plane x_d = place [m].
   */
  template <int dim>
  class PlaneShape : public WallShape<dim>
  {
  public:
    PlaneShape(const BoxFace side, const double place);

    double
    distance(const dealii::Point<dim> &x) const override;

    dealii::Tensor<1, dim>
    normal(const dealii::Point<dim> &x) const override;

  private:
    const BoxFace side;
    const double  place;
  };

  /**
   * @brief An axis-parallel box. Inside, and on it, the nearest face counts.
   */
  template <int dim>
  class BoxShape : public WallShape<dim>
  {
  public:
    explicit BoxShape(const dealii::BoundingBox<dim> &box);

    double
    distance(const dealii::Point<dim> &x) const override;

    dealii::Tensor<1, dim>
    normal(const dealii::Point<dim> &x) const override;

  private:
    /// From the nearest place of the box, for one outside; zero inside.
    dealii::Tensor<1, dim>
    from_box(const dealii::Point<dim> &x) const;

    /// The face that a place inside is nearest to, and its signed distance [m].
    std::pair<double, BoxFace>
    nearest_face(const dealii::Point<dim> &x) const;

    const dealii::BoundingBox<dim> box;
  };
} // namespace seiche

#endif
