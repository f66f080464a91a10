// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_hdf5_handle_h
#define seiche_postprocess_hdf5_handle_h

#include <hdf5.h>

namespace seiche
{
  /// Closes an identifier of HDF5 at the end of its scope.
  class Hdf5Handle
  {
  public:
    Hdf5Handle(const hid_t identifier, herr_t (*closing_function)(hid_t))
      : id(identifier)
      , close(closing_function)
    {}

    ~Hdf5Handle()
    {
      close(id);
    }

    Hdf5Handle(const Hdf5Handle &) = delete;
    Hdf5Handle &
    operator=(const Hdf5Handle &) = delete;

    const hid_t id;

  private:
    herr_t (*close)(hid_t);
  };
} // namespace seiche

#endif
