// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <hdf5.h>

namespace contrecoup
{
namespace io
{
  /// RAII handle of an HDF5 object; negative if opening failed.
  class Hdf5Handle
  {
  public:
    Hdf5Handle(const hid_t id, herr_t (*close)(hid_t))
      : id_(id)
      , close_(close)
    {}

    ~Hdf5Handle()
    {
      if (id_ >= 0)
        close_(id_);
    }

    Hdf5Handle(const Hdf5Handle &) = delete;
    Hdf5Handle &operator=(const Hdf5Handle &) = delete;

    operator hid_t() const
    {
      return id_;
    }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
  };
} // namespace io
} // namespace contrecoup
