// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/folder_name.h>

#include <filesystem>
#include <system_error>

namespace seiche
{
  std::string
  folder_name(const std::string &directory)
  {
    namespace fs  = std::filesystem;
    fs::path path = directory;
    while ((!path.has_filename() || path.filename() == ".") && // "x/", "x/."
           path.has_parent_path() && path != path.root_path())
      path = path.parent_path();
    std::error_code error;
    const bool      is_name =
      path.has_filename() && path.filename() != "." && path.filename() != "..";
    if (!is_name || fs::is_symlink(path, error))
      if (const fs::path real = fs::weakly_canonical(path, error); !error)
        path = real;
    return path.string();
  }
} // namespace seiche
