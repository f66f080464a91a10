// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/muelu_multigrid.h>

#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>

namespace seiche
{
  namespace
  {
    using Matrix      = Tpetra::CrsMatrix<>;
    using Operator    = Tpetra::Operator<>;
    using MultiVector = Tpetra::MultiVector<>;
    using Map         = Matrix::map_type;
    using Row         = Map::global_ordinal_type;

    Teuchos::RCP<const Map>
    make_map(const int n_rows, const MPI_Comm communicator)
    {
      return Teuchos::rcp(
        new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                n_rows,
                0,
                Teuchos::rcp(new Teuchos::MpiComm<int>(communicator))));
    }
  } // namespace

  struct MueLuMultigrid::Objects
  {
    explicit Objects(const Teuchos::RCP<const Map> &map)
      : source(map, 1)
      , destination(map, 1)
    {}

    Teuchos::RCP<Operator> hierarchy;
    MultiVector            source, destination;
  };

  MueLuMultigrid::MueLuMultigrid(const DistributedRows &rows,
                                 const MPI_Comm         communicator)
    : objects(
        std::make_unique<Objects>(make_map(rows.length.size(), communicator)))
  {
    const std::vector<std::size_t> lengths(rows.length.begin(),
                                           rows.length.end());
    const std::vector<Row> columns(rows.column.begin(), rows.column.end());
    const auto             matrix =
      Teuchos::rcp(new Matrix(objects->source.getMap(),
                              Teuchos::ArrayView<const std::size_t>(lengths)));
    std::size_t begin = 0;
    for (std::size_t row = 0; row < lengths.size(); ++row)
      {
        matrix->insertGlobalValues(rows.first + row,
                                   rows.length[row],
                                   &rows.value[begin],
                                   &columns[begin]);
        begin += lengths[row];
      }
    matrix->fillComplete();

    // measured: doc/journal/multigrid.md
    Teuchos::ParameterList settings;
    settings.set("verbosity", "none");
    settings.set("coarse: type", "RELAXATION");
    settings.set("coarse: max size", 10);
    objects->hierarchy =
      MueLu::CreateTpetraPreconditioner(Teuchos::RCP<Operator>(matrix),
                                        settings);
  }

  MueLuMultigrid::~MueLuMultigrid() = default;

  void
  MueLuMultigrid::vmult(Vector &dst, const Vector &src) const
  {
    std::copy_n(src.begin(),
                src.locally_owned_size(),
                objects->source.getDataNonConst(0).begin());
    objects->hierarchy->apply(objects->source, objects->destination);
    std::copy_n(objects->destination.getData(0).begin(),
                dst.locally_owned_size(),
                dst.begin());
  }
} // namespace seiche
