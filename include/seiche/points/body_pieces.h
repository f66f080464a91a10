// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_points_body_pieces_h
#define seiche_points_body_pieces_h

#include <seiche/mesh/cell_locator.h>
#include <seiche/scene/box_part.h>
#include <seiche/shapes/shape.h>

#include <unordered_map>
#include <vector>

namespace seiche
{
  /**
   * @brief What a fluid body has of the lattice of places for its points: one
   * piece per place, without what belongs to earlier bodies or to solids, as
   * the grid has them (doc/theory.md (5.2)).
   *
   * A light piece is joined to the one across the face towards which its
   * centre lies, so that hardly any point is light. Volumes add up to that of
   * the body outside obstacles; the same pieces on every rank.
   */
  template <int dim>
  class BodyPieces
  {
  public:
    /// Share of its place below which a piece is joined to another one. A plane
    /// that cuts less than 1/6 off a place cuts more off one beside it.
    static constexpr double light = 0.15;

    /// Of a body whose pieces are all light.
    static constexpr const char *message_if_empty =
      "the body holds no material point: it is smaller than the spacing of the "
      "points, or it lies inside an obstacle, a solid or an earlier body.";

    /// A cell of the finest lattice in an own or ghost cell.
    struct LatticeCell
    {
      unsigned int                  cell;
      std::array<unsigned int, dim> offset;
    };

    /// The places in a cell of the finest lattice.
    struct Lattice
    {
      dealii::Point<dim>            origin;  // [m]
      dealii::Tensor<1, dim>        spacing; // [m]
      std::array<unsigned int, dim> n;
      unsigned int                  n_all = 1; // 0: body and cell do not meet

      Lattice(const dealii::BoundingBox<dim> &part,
              const dealii::BoundingBox<dim> &cell,
              const unsigned int              per_direction);

      /// Of a place, along the axes.
      std::array<unsigned int, dim>
      position(const unsigned int place) const;

      dealii::BoundingBox<dim>
      box(const unsigned int place) const;

      /// Of a place [m^dim].
      double
      measure() const;
    };

    struct Piece
    {
      double             volume; ///< [m^dim], 0: no point
      dealii::Point<dim> centre;
      bool               is_whole; ///< its place and nothing else
    };

    /// @p shapes: of all bodies. All arguments but the last must outlive the
    /// object.
    BodyPieces(const CellLocator<dim>                &cell_locator,
               const std::vector<const Shape<dim> *> &shapes,
               const unsigned int                     body,
               const unsigned int                     points_per_direction);

    /// True if the body does not come near a cell.
    bool
    is_apart_from(const unsigned int cell) const;

    /// Valid until the next call.
    const Lattice &
    lattice(const LatticeCell &lattice_cell);

    /// The piece at a place in an own cell.
    Piece
    piece(const LatticeCell &lattice_cell, const unsigned int place);

  private:
    struct Content
    {
      Lattice                   lattice;
      std::vector<BoxPart<dim>> parts; ///< empty: all places are full
    };

    struct Place
    {
      LatticeCell  lattice_cell;
      unsigned int index;
    };

    /// Kept until lattice() makes room.
    const Content &
    content(const LatticeCell &lattice_cell);

    BoxPart<dim>
    part(const Place &place);

    /// The place across a face of deal.II's number; false if there is none.
    bool
    cross(Place &place, const BoxFace face);

    /// Faces across which a light part may go, the nearest to its centre
    /// first.
    std::array<unsigned int, dim>
    ways_out(const Place &place);

    /// True if the part of @p from goes to that of @p to, across a face.
    bool
    joins(const Place &from, const Place &to, const BoxFace face);

    const CellLocator<dim>                    &locator;
    const Shape<dim>                          &shape;
    std::vector<const Shape<dim> *>            earlier;
    const unsigned int                         per_direction;
    std::unordered_map<std::uint64_t, Content> contents;
  };
} // namespace seiche

#endif
