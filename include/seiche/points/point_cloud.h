// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_points_point_cloud_h
#define seiche_points_point_cloud_h

#include <seiche/mesh/cell_locator.h>
#include <seiche/points/outflow.h>
#include <seiche/points/point_columns.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/std_cxx20/iota_view.h>

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace seiche
{

  /**
   * @brief The material points of this rank: structure of arrays, sorted by
   * (cell, id).
   *
   * One aligned array per component, only the columns that the chosen methods
   * asked for, and a compressed row storage cell -> points. Sums over points
   * run in the order (cell, id), which does not depend on the rank count.
   * Points change owner when they enter a cell of another rank.
   */
  template <int dim>
  class PointCloud
  {
  public:
    /// @p columns beyond the always present ones (position, velocity,
    /// volume_ratio, mass, initial_volume, pressure). @p cell_locator must
    /// outlive the cloud.
    PointCloud(const CellLocator<dim>      &cell_locator,
               const std::set<PointColumn> &columns,
               const MPI_Comm               mpi_communicator);

    /// Number of points of this rank.
    std::size_t
    size() const
    {
      return point_ids.size();
    }

    /// Number on all ranks, as counted by the last locate() or insertion.
    std::uint64_t
    n_global() const
    {
      return global_size;
    }

    bool
    has(const PointColumn column) const;

    /// Array [size()] of a component (row-major for tensors).
    double *
    data(const PointColumn column, const unsigned int component = 0);
    const double *
    data(const PointColumn column, const unsigned int component = 0) const;

    dealii::Point<dim>
    position(const std::size_t point) const;

    /// 64-bit ids from the seeding lattice, unique over ranks.
    const std::vector<std::uint64_t> &
    ids() const
    {
      return point_ids;
    }

    /// Local cell (CellLocator) of each point.
    const std::vector<unsigned int> &
    cells() const
    {
      return point_cells;
    }

    /// Points of an own cell: [first_point(cell), first_point(cell+1)).
    std::size_t
    first_point(const unsigned int cell) const
    {
      return cell_begin[cell];
    }

    unsigned int
    n_points_in(const unsigned int cell) const
    {
      return cell_begin[cell + 1] - cell_begin[cell];
    }

    /// Their numbers, for loops.
    dealii::std_cxx20::ranges::iota_view<std::size_t, std::size_t>
    points_in(const unsigned int cell) const
    {
      return {cell_begin[cell], cell_begin[cell + 1]};
    }

    /// Add a point; call locate() after the last one. Columns not given are
    /// zero; volume_ratio is one. Local.
    void
    insert(const std::uint64_t           id,
           const dealii::Point<dim>     &position,
           const dealii::Tensor<1, dim> &velocity,
           const double                  mass,
           const double                  initial_volume);

    /// Drop points (numbers of this rank, ascending); the others keep their
    /// order. n_global() counts them from the next locate() on. Local.
    void
    remove(const std::vector<std::size_t> &dropped);

    /// Take positions beyond periodic sides to the other side. Local.
    void
    wrap();

    /// wrap(), find the cell of every point, remove those that left through an
    /// open side (counted), set those that have cut the edge of an obstacle
    /// on the nearest place of the cells around (counted), send those in cells
    /// of other ranks, sort by (cell, id). NumericalError with id, position,
    /// speed and advice for a point that is nowhere: behind a closed wall, not
    /// finite, or (on several ranks) further than one cell layer from its last
    /// cell. Collective.
    void
    locate();

    /// The mesh has been refined or coarsened without a change of owners and
    /// the locator is up to date: find the cells of all points. Collective.
    void
    relocate();

    /// The points of an own cell, for the forest to send along with the cell
    /// when the mesh is repartitioned. Local.
    std::vector<char>
    pack_cell(const unsigned int cell) const;

    /// After that: the points are those of @p packed, the cells of this rank
    /// one after the other; the locator is up to date. Collective.
    void
    replace(const std::vector<char> &packed);

    const CellLocator<dim> &locator;
    const MPI_Comm          communicator;
    Outflow                 outflow; ///< all ranks; not for others to change

  private:
    static constexpr unsigned int invalid = static_cast<unsigned int>(-1);

    /// What one locate() found on this rank.
    struct Found
    {
      std::size_t n_before       = 0; ///< points before the search
      std::size_t n_outflow      = 0; ///< left through open sides
      double      outflow_mass   = 0.;
      std::size_t n_set_on_walls = 0; ///< see set_on_wall()
      std::size_t n_lost         = 0;
      std::string lost_report;   ///< of the first lost point
      bool        moved = false; ///< a point is new or changed its cell
    };

    /// Update point_cells; invalid marks points that leave this rank.
    Found
    find_cells(std::vector<std::size_t> &emigrants);
    /// A point within an obstacle along which the fluid slips, or behind a
    /// unilateral side: set it on the nearest place of its
    /// last cell or of those around. At dry convex edges nodes move across a
    /// face, so that the field between them and the next nodes may cut the
    /// edge; what meets a unilateral wall within a step has the wall's velocity
    /// at its end only. The cell, or invalid.
    unsigned int
    set_on_wall(const std::size_t point);

    /// Put a point that is in a solid on its surface, where it keeps the
    /// velocity along it; true if it was.
    bool
    put_out_of_solids(const std::size_t point);
    /// A point that is in no cell: outflow or lost.
    void
    count_outside(const std::size_t point, Found &found) const;
    std::string
    lost_report(const std::size_t point, const std::string &reason) const;
    /// Sums over the ranks; NumericalError if a point is lost.
    void
    account(const Found &found);

    /// Send points to the owners of their cells, receive others. Collective.
    void
    migrate(const std::vector<std::size_t> &emigrants);

    /// Drop points with invalid cell and sort the rest by (cell, id).
    void
    sort();
    void
    build_cell_index();
    void
    order_within_cells();
    void
    apply_permutation();

    // component arrays of all columns present, in the order of the table
    std::vector<dealii::AlignedVector<double>> arrays;
    std::array<unsigned int, n_point_columns>  first_array; // or invalid
    std::vector<std::uint64_t>                 point_ids;
    std::vector<unsigned int>                  point_cells;
    std::vector<std::size_t>                   cell_begin;
    std::uint64_t                              global_size = 0;

    // workspace of sort(), kept so that a step allocates nothing
    std::vector<std::uint32_t>    permutation;
    dealii::AlignedVector<double> scratch_values;
    std::vector<std::uint64_t>    scratch_ids;
    std::vector<unsigned int>     scratch_cells;
  };
} // namespace seiche

#endif
