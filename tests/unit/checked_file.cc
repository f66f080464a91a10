// SPDX-License-Identifier: LGPL-2.1-or-later
// The write protocol: files are whole or absent, also on a full disk (which
// a limit of the file size stands for).
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/directory_lock.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/growing_file.h>

#include <deal.II/base/mpi.h>

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <locale>
#include <stdexcept>

namespace
{
  std::string
  contents(const std::string &filename)
  {
    std::ifstream stream(filename);
    return std::string((std::istreambuf_iterator<char>(stream)),
                       std::istreambuf_iterator<char>());
  }

  void
  limit_file_size(const rlim_t bytes)
  {
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = (bytes == 0 ? limit.rlim_max : bytes);
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  /// The limit holds for the function only: standard output may be a file.
  void
  attempt(const std::string           &title,
          const std::function<void()> &function,
          const rlim_t                 limit = 0)
  {
    std::string result = "done";
    limit_file_size(limit);
    try
      {
        function();
      }
    catch (const seiche::FileError &error)
      {
        result = error.what();
      }
    catch (const std::runtime_error &error)
      {
        result = std::string("other error: ") + error.what();
      }
    limit_file_size(0);
    std::cout << title << ": " << result << std::endl;
  }

  void
  list_folder()
  {
    unsigned int temporary = 0;
    for (const auto &entry : std::filesystem::directory_iterator("folder/a"))
      temporary += (entry.path().extension() == ".writing");
    std::cout << "temporary files left: " << temporary << std::endl;
  }

  /// A number with a decimal comma, as some languages write it.
  struct Comma : std::numpunct<char>
  {
    char
    do_decimal_point() const override
    {
      return ',';
    }
  };

  void
  write_files(const std::string &folder)
  {
    using namespace seiche;
    const std::string file = folder + "/file.txt", big(200000, 'x');

    attempt("write", [&]() {
      checked_file::write(file, [](std::ostream &out) { out << 0.5 << '\n'; });
    });
    std::cout << "contents: " << contents(file);
    attempt("large", [&]() {
      checked_file::write(folder + "/large", [&](std::ostream &out) {
        out << "head " << big;
        for (unsigned int i = 0; i < 100000; ++i)
          out.put('y');
      });
    });
    std::cout << "bytes: " << std::filesystem::file_size(folder + "/large")
              << std::endl;
    attempt("exception while writing", [&]() {
      checked_file::write(file, [](std::ostream &out) {
        out << "half";
        throw std::runtime_error("stopped");
      });
    });
    attempt("no folder",
            [&]() { checked_file::write("none/file", [](std::ostream &) {}); });
    attempt("by name", [&]() {
      checked_file::write_by_name(
        folder + "/named",
        [](const std::string &name) { std::ofstream(name) << "text"; },
        [](const std::string &name) { return contents(name) == "text"; });
    });
    attempt("by name, incomplete", [&]() {
      checked_file::write_by_name(
        folder + "/incomplete",
        [](const std::string &name) { std::ofstream(name) << "te"; },
        [](const std::string &name) { return contents(name) == "text"; });
    });

    attempt(
      "full disk",
      [&]() {
        checked_file::write(file, [&](std::ostream &out) { out << big; });
      },
      100000);
    attempt(
      "full disk at the last byte",
      [&]() {
        checked_file::write(file, [&](std::ostream &out) {
          out << big.substr(0, 50000) << big.substr(0, 50001);
        });
      },
      100000);
    std::cout << "old contents: " << contents(file) << "incomplete exists: "
              << std::filesystem::exists(folder + "/incomplete") << std::endl;
  }

  void
  grow_file(const std::string &name)
  {
    seiche::GrowingFile growing;
    attempt("append", [&]() {
      growing.open(name);
      growing.append("one\n");
      std::cout << "readable while open: " << contents(name);
      growing.append("two\n");
      growing.close();
    });
    std::cout << "open: " << growing.is_open() << ", " << contents(name);
    attempt(
      "append on a full disk",
      [&]() {
        growing.open(name);
        growing.append("three\n");
        growing.append("four and more\n");
      },
      10);
  }

  void
  lock_folder(const std::string &folder)
  {
    {
      seiche::DirectoryLock lock;
      attempt("lock", [&]() { lock.acquire(folder); });
      attempt("second lock", [&]() {
        seiche::DirectoryLock second;
        second.acquire(folder);
      });
    }
    attempt("lock again", [&]() {
      seiche::DirectoryLock third;
      third.acquire(folder);
    });
  }
} // namespace

int
main(int argc, char **argv)
{
  std::signal(SIGXFSZ, SIG_IGN);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::locale::global(std::locale(std::locale(), new Comma));

  const std::string folder = "folder/a";
  std::filesystem::remove_all("folder");
  attempt("make", [&]() { seiche::checked_file::make_directory(folder); });
  attempt("make again",
          [&]() { seiche::checked_file::make_directory(folder); });
  write_files(folder);
  attempt("folder below a file", [&]() {
    seiche::checked_file::make_directory(folder + "/file.txt/sub");
  });
  attempt("folder that is a file", [&]() {
    seiche::checked_file::make_directory(folder + "/file.txt");
  });
  grow_file(folder + "/growing");
  lock_folder(folder);
  list_folder();
}
