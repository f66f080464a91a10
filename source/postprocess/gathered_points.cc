// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/gathered_points.h>

#include <algorithm>
#include <numeric>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// The parts of all ranks one after the other; empty but on rank 0.
    /// (Utilities::MPI::gather() would compress them, which takes longer than
    /// all the rest of a checkpoint.)
    template <typename Number>
    std::vector<Number>
    gathered(const std::vector<Number> &part, const MPI_Comm communicator)
    {
      const auto type = Utilities::MPI::mpi_type_id_for_type<Number>;
      const auto sizes =
        Utilities::MPI::gather(communicator, static_cast<int>(part.size()));
      std::size_t      total = 0;
      std::vector<int> offsets;
      for (const int size : sizes)
        {
          offsets.push_back(static_cast<int>(total));
          total += size;
        }
      AssertThrow(total < (std::size_t(1) << 31),
                  ExcMessage("Too many points for one message of MPI."));
      std::vector<Number> all(total);
      const int           error = MPI_Gatherv(part.data(),
                                    static_cast<int>(part.size()),
                                    type,
                                    all.data(),
                                    sizes.data(),
                                    offsets.data(),
                                    type,
                                    /*root=*/0,
                                    communicator);
      AssertThrowMPI(error);
      return all;
    }

    /// A column [n][components], row-major.
    template <int dim>
    std::vector<double>
    interleaved(const PointCloud<dim> &points, const PointColumn column)
    {
      const unsigned int  n = n_components(column, dim);
      std::vector<double> values(n * points.size());
      for (unsigned int c = 0; c < n; ++c)
        {
          const double *component = points.data(column, c);
          for (std::size_t i = 0; i < points.size(); ++i)
            values[n * i + c] = component[i];
        }
      return values;
    }

    /// Rows of n numbers: row i becomes the row order[i] of @p values.
    template <typename Number>
    std::vector<Number>
    reordered(const std::vector<Number>      &values,
              const unsigned int              n,
              const std::vector<std::size_t> &order)
    {
      std::vector<Number> result;
      result.reserve(values.size());
      for (const std::size_t i : order)
        result.insert(result.end(),
                      values.begin() + n * i,
                      values.begin() + n * (i + 1));
      return result;
    }
  } // namespace

  template <int dim>
  GatheredPoints<dim>::GatheredPoints(const PointCloud<dim> &points)
  {
    const auto               all = gathered(points.ids(), points.communicator);
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(),
              order.end(),
              [&](const std::size_t a, const std::size_t b) {
                return all[a] < all[b];
              });

    ids = reordered(all, 1, order);
    for (const PointColumnInfo &info : point_column_table)
      if (points.has(info.column))
        columns.emplace_back(info,
                             reordered(gathered(interleaved(points,
                                                            info.column),
                                                points.communicator),
                                       n_components(info.column, dim),
                                       order));
  }

  template <int dim>
  void
  GatheredPoints<dim>::write(Hdf5Image &image) const
  {
    image.write_array("id", ids);
    for (const auto &[info, values] : columns)
      image.write_array(info.name,
                        values,
                        n_components(info.column, dim),
                        info.unit);
  }

  template class GatheredPoints<2>;
  template class GatheredPoints<3>;
} // namespace seiche
