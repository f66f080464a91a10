// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_ordered_points_h
#define seiche_postprocess_ordered_points_h

#include <seiche/points/point_cloud.h>
#include <seiche/postprocess/hdf5_image.h>

#include <functional>
#include <vector>

namespace seiche
{
  /**
   * @brief The points of all ranks in the order of their ids, for files that do
   * not depend on the number of ranks.
   *
   * Each rank gets the points of a range of ids, about as many as the others;
   * rank 0, which writes, asks for rows when their turn comes, so that no rank
   * ever holds more than its range.
   */
  template <int dim>
  class OrderedPoints
  {
  public:
    /// @p points must outlive this and not change. Collective.
    explicit OrderedPoints(const PointCloud<dim> &points);

    OrderedPoints(const OrderedPoints &) = delete; // arrays are its own
    OrderedPoints &
    operator=(const OrderedPoints &) = delete;

    /// Call @p write on rank 0, where the arrays may be written meanwhile; the
    /// others hand out their rows until it returns or throws. Collective.
    void
    while_rows_are_handed_out(const std::function<void()> &write) const;

    /// Arrays `id`, and every column under its name in the table of columns,
    /// [n] or [n][components], with attribute `unit`. Rank 0.
    void
    add_to(Hdf5Image &image) const;

  private:
    using Sink = Hdf5Image::Sink;

    /// A column of the points, or their ids.
    struct Array
    {
      const PointColumnInfo      *info; ///< nullptr: the ids
      std::vector<const double *> components;

      std::size_t
      bytes_of_row() const
      {
        return 8 * (info != nullptr ? components.size() : 1);
      }
    };

    /// What rank 0 asks another rank for; no array: for nothing any more.
    struct Request
    {
      std::uint64_t array, begin, end; // rows of that rank
    };

    /// Send each rank its range of ids.
    void
    exchange();

    /// What rank 0 asks for, until it has enough; throws then if there was no
    /// memory for it.
    void
    hand_out() const;

    /// Rows of this rank, as they stand in the file.
    std::vector<char>
    rows(const Array      &array,
         const std::size_t begin,
         const std::size_t end) const;

    /// All rows, rank after rank. Rank 0.
    void
    for_all_rows(const std::size_t array, const Sink &sink) const;

    const PointCloud<dim>           &points;
    std::vector<std::uint64_t>       ids;      // in any order
    std::vector<std::vector<double>> received; // a component each
    std::vector<Array>               arrays;
    std::vector<std::size_t>         order; // of ids
    std::vector<std::uint64_t>       rows_of_rank;
  };
} // namespace seiche

#endif
