// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_file_beside_h
#define seiche_parameters_file_beside_h

#include <seiche/parameters/input_file.h>

namespace seiche
{
  /// A file that an entry names: absolute, or relative to the parameter file.
  inline std::string
  file_beside(const InputFile &input, const std::string &name)
  {
    return name.rfind('/', 0) == 0 ? name : input.directory() + "/" + name;
  }
} // namespace seiche

#endif
