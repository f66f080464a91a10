// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_box_face_h
#define seiche_utilities_box_face_h

namespace seiche
{
  /// Face of a box, by deal.II's number.
  class BoxFace
  {
  public:
    constexpr BoxFace(const unsigned int face_number)
      : number(face_number)
    {}
    constexpr BoxFace(const unsigned int normal_direction, const bool upper)
      : number(2 * normal_direction + upper)
    {}

    constexpr operator unsigned int() const
    {
      return number;
    }

    constexpr unsigned int
    direction() const
    {
      return number / 2;
    }

    /// Or the lower one in its direction.
    constexpr bool
    is_upper() const
    {
      return number % 2 == 1;
    }

    /// Component of the outward normal in its direction.
    constexpr int
    outward() const
    {
      return is_upper() ? 1 : -1;
    }

    constexpr BoxFace
    opposite() const
    {
      return number ^ 1u;
    }

    /// @p vertex: deal.II's number.
    constexpr bool
    has_vertex(const unsigned int vertex) const
    {
      return ((vertex >> direction()) & 1u) == is_upper();
    }

  private:
    unsigned int number;
  };
} // namespace seiche

#endif
