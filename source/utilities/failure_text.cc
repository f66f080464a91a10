// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/failure_text.h>

#include <deal.II/base/exceptions.h>

#include <new>

namespace seiche
{
  bool
  is_exhausted_memory(const std::exception &error)
  {
    return dynamic_cast<const std::bad_alloc *>(&error) != nullptr ||
           dynamic_cast<const dealii::StandardExceptions::ExcOutOfMemory *>(
             &error) != nullptr;
  }

  std::string
  failure_text(const std::exception &error)
  {
    if (!is_exhausted_memory(error))
      return error.what();
    return "memory is exhausted, or its limit (ulimit -v) is reached; use "
           "larger cells, fewer points a cell or ranks on more machines: "
           "--validate foretells what a scene needs. If there is a "
           "checkpoint, --restart goes on from it.";
  }
} // namespace seiche
