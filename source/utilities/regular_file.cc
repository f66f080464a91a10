// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/regular_file.h>

#include <fmt/format.h>

#include <filesystem>

namespace seiche
{
  std::string
  problem_of_file(const std::string &filename, const std::uintmax_t largest)
  {
    std::error_code error;
    const auto      status = std::filesystem::status(filename, error);
    if (!std::filesystem::exists(status))
      return "there is no such file";
    if (std::filesystem::is_directory(status))
      return "this is a folder; give the file in it";
    if (!std::filesystem::is_regular_file(status))
      return "this is not a regular file; copy its text into one";
    if (std::filesystem::file_size(filename, error) > largest)
      return fmt::format("this file is larger than {} MiB", largest >> 20);
    return "";
  }
} // namespace seiche
