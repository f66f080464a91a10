// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/earlier_results.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/folder_name.h>
#include <seiche/utilities/result_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

namespace seiche
{
  namespace
  {
    namespace fs = std::filesystem;

    /// In folders that were made here.
    constexpr const char *mark = "moved-here.txt";

    /// Rows of statistics.csv before that of the first step: names, start.
    constexpr unsigned int rows_without_step = 2;

    /// What a name says of the results that it belongs to.
    enum class Evidence
    {
      foreign, // no run writes this
      none,
      checkpoint,
      statistics
    };

    Evidence
    evidence(const std::string &name)
    {
      if (name == result_names::statistics)
        return Evidence::statistics;
      if (result_names::is_checkpoint(name))
        return Evidence::checkpoint;
      return result_names::is_result(name) ? Evidence::none : Evidence::foreign;
    }

    /// Names of what a run has written into a folder, what shows its worth
    /// last. Links, say, are the user's own.
    std::vector<std::string>
    files_of_run(const std::string &folder)
    {
      std::vector<std::string> names;
      std::error_code          error;
      for (const auto &entry : fs::directory_iterator(folder, error))
        {
          const std::string name  = entry.path().filename().string();
          const auto        type  = entry.symlink_status().type();
          const auto        right = name == result_names::failure ?
                                      fs::file_type::directory :
                                      fs::file_type::regular;
          if (evidence(name) != Evidence::foreign && type == right)
            names.push_back(name);
        }
      std::sort(names.begin(), names.end(), [](const auto &a, const auto &b) {
        return std::make_pair(evidence(a), a) < std::make_pair(evidence(b), b);
      });
      return names;
    }

    /// A statistics.csv that no run has written counts as one with steps. @p
    /// names: files_of_run().
    bool
    has_step(const std::string &folder, const std::vector<std::string> &names)
    {
      unsigned int rows = 0;
      for (const std::string &name : names)
        {
          if (evidence(name) == Evidence::checkpoint)
            return true;
          if (evidence(name) != Evidence::statistics)
            continue;
          std::ifstream statistics(folder + "/" + name);
          std::string   line;
          while (rows <= rows_without_step && std::getline(statistics, line))
            {
              if (rows == 0 && line.rfind("step,", 0) != 0)
                return true;
              ++rows;
            }
        }
      return rows > rows_without_step;
    }

    [[noreturn]] void
    fail(const std::string &folder, const std::string &problem)
    {
      throw FileError(
        fmt::format("{}: {}. The results of an earlier run cannot be moved "
                    "there and stay where they are; rename or remove that "
                    "folder or these results, or choose another folder with "
                    "--output.",
                    folder,
                    problem));
    }

    bool
    is_there(const std::string &name)
    {
      std::error_code error;
      return fs::symlink_status(name, error).type() != fs::file_type::not_found;
    }

    bool
    is_marked(const std::string &folder)
    {
      std::error_code error;
      return fs::is_regular_file(folder + "/" + mark, error);
    }

    /// FileError if the folder is there, but was not made here.
    void
    require_own(const std::string &folder)
    {
      std::error_code error;
      if (is_there(folder) && !is_marked(folder) &&
          !(fs::is_directory(folder, error) && fs::is_empty(folder, error)))
        fail(folder, "this is not a folder that a run has moved results to");
    }

    void
    rename(const std::string &from, const std::string &to)
    {
      if (is_there(to))
        fail(to, "this exists already");
      std::error_code error;
      fs::rename(from, to, error);
      if (error)
        fail(to, "cannot be made (" + error.message() + ")");
    }

    /// What cannot be removed stays: it is written over, or an error then.
    void
    remove_files_of_run(const std::string &folder)
    {
      std::error_code error;
      for (const std::string &name : files_of_run(folder))
        fs::remove_all(folder + "/" + name, error);
    }

    /// The results in a folder that was made here, and the folder if nothing
    /// else is there.
    void
    remove_own(const std::string &folder)
    {
      if (is_marked(folder))
        remove_files_of_run(folder);
      std::error_code error;
      fs::remove(folder + "/" + mark, error);
      fs::remove(folder, error); // if it is empty
    }
  } // namespace



  EarlierResults::EarlierResults(const std::string &output_directory)
    : directory(folder_name(output_directory))
    , moving(directory + ".moving")
    , old(directory + ".old")
    , older(directory + ".older")
  {}



  void
  EarlierResults::settle() const
  {
    std::error_code error;
    // results made here are a run's own, not those that were moved here
    fs::remove(directory + "/" + mark, error);
    if (is_marked(moving))
      for (const std::string &name : files_of_run(moving))
        rename(moving + "/" + name, directory + "/" + name);
    if (is_there(moving))
      remove_own(moving);
    if (!is_there(old) && is_marked(older))
      rename(older, old);
  }



  bool
  EarlierResults::move_aside() const
  {
    const std::vector<std::string> names = files_of_run(directory);
    if (!has_step(directory, names))
      {
        if (std::find(names.begin(), names.end(), result_names::statistics) !=
            names.end()) // else nobody knows whose they are
          remove_files_of_run(directory);
        return false;
      }

    for (const std::string &folder : {moving, old, older})
      require_own(folder);
    try
      {
        checked_file::make_directory(moving);
        std::ofstream(moving + "/" + mark)
          << "Results of an earlier run, which a later one has moved here. The "
             "run after that\nremoves them: rename this folder if they shall "
             "be kept.\n";
        if (!is_marked(moving))
          fail(moving, "it cannot be written into");
        for (const std::string &name : names)
          rename(directory + "/" + name, moving + "/" + name);
      }
    catch (const FileError &)
      {
        settle();
        throw;
      }
    if (is_there(old))
      {
        remove_own(older);
        rename(old, older);
      }
    rename(moving, old);
    return true;
  }



  std::string
  EarlierResults::hint() const
  {
    if (!is_marked(old) || has_step(directory, files_of_run(directory)))
      return "";
    return fmt::format(
      "the results of an earlier run are in {0} (to go on with "
      "it: --output {0} --restart)",
      old);
  }



  void
  EarlierResults::remove_older() const
  {
    remove_own(older);
  }
} // namespace seiche
