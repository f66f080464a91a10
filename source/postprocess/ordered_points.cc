// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/gathered_points.h>
#include <seiche/utilities/exceptions.h>

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
      if (total >= (std::size_t(1) << 31))
        throw NumericalError("more than 2^31 - 1 points cannot be gathered "
                             "for a checkpoint or an HDF5 series; set "
                             "Checkpoint/Every wall time = 0 and no "
                             "Output/Point series.");
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

    ids.reserve(all.size());
    for (const std::size_t i : order)
      ids.push_back(all[i]);
    // a component at a time: the counts of a message are 32-bit
    for (const PointColumnInfo &info : point_column_table)
      if (points.has(info.column))
        {
          const unsigned int  n = n_components(info.column, dim);
          std::vector<double> values(n * order.size());
          for (unsigned int c = 0; c < n; ++c)
            {
              const double *own = points.data(info.column, c);
              const auto    component =
                gathered(std::vector<double>(own, own + points.size()),
                         points.communicator);
              for (std::size_t i = 0; i < order.size(); ++i)
                values[n * i + c] = component[order[i]];
            }
          columns.emplace_back(info, std::move(values));
        }
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
