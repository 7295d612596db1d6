// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/hdf5_input.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Upper bound of the length of text attributes.
    constexpr std::size_t longest_text = 1 << 20;

    /// Why the file cannot be locked as HDF5 does before it reads; empty if it
    /// can.
    std::string why_locked(const std::string &path)
    {
      const std::string remedy =
        "; with HDF5_USE_FILE_LOCKING=FALSE in the environment it is read "
        "without a lock";
      const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
      if (file < 0)
        return "";
      const bool is_free = ::flock(file, LOCK_SH | LOCK_NB) == 0;
      const int error = errno;
      ::close(file);
      if (is_free)
        return "";
      return (error == EWOULDBLOCK
                ? "it is locked by another program, such as a viewer, or a run "
                  "that still writes it: close that program"
                : "its file system locks no files (" +
                    std::string(std::strerror(error)) + ")") +
             remedy;
    }

    hid_t open(const std::string &path)
    {
      const std::string why = why_unreadable(path);
      if (!why.empty())
        throw InputError("\"" + path + "\" cannot be read: " + why);
      H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
      return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    }
  } // namespace


  Hdf5Input::Hdf5Input(const std::string &path)
    : path_(path)
    , file_(open(path), H5Fclose)
  {
    if (file_ >= 0)
      return;
    std::error_code error;
    if (std::filesystem::file_size(path, error) == 0)
      refuse("it is empty");
    const std::string locked = why_locked(path);
    if (!locked.empty())
      refuse(locked);
    refuse(H5Fis_hdf5(path.c_str()) > 0 ? "it is a damaged HDF5 file"
                                        : "it is no HDF5 file");
  }


  void Hdf5Input::refuse(const std::string &why) const
  {
    throw InputError("\"" + path_ + "\" cannot be read: " + why);
  }


  bool Hdf5Input::has_attribute(const std::string &name) const
  {
    return H5Aexists(file_, name.c_str()) > 0;
  }


  bool Hdf5Input::has_dataset(const std::string &name) const
  {
    return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
  }


  std::vector<double> Hdf5Input::numbers(const std::string &name) const
  {
    const Hdf5Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (data < 0)
      refuse("it has no dataset \"" + name + "\"");
    const Hdf5Handle space(H5Dget_space(data), H5Sclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (count < 0 || static_cast<std::uintmax_t>(count) / largest_zlib_ratio >
                       std::filesystem::file_size(path_))
      refuse("its dataset \"" + name + "\" cannot be as large as it says");
    std::vector<double> values(static_cast<std::size_t>(count));
    if (H5Dread(data,
                H5T_NATIVE_DOUBLE,
                H5S_ALL,
                H5S_ALL,
                H5P_DEFAULT,
                values.data()) < 0)
      refuse("its dataset \"" + name + "\" is damaged");
    return values;
  }


  double Hdf5Input::number(const std::string &name) const
  {
    const Hdf5Handle attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT),
                               H5Aclose);
    if (attribute < 0)
      refuse("it has no attribute \"" + name + "\"");
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
    double value = 0.;
    if (H5Sget_simple_extent_npoints(space) != 1 ||
        H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
      refuse("its attribute \"" + name + "\" is no number");
    return value;
  }


  std::string Hdf5Input::text(const std::string &name) const
  {
    const Hdf5Handle attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT),
                               H5Aclose);
    if (attribute < 0)
      refuse("it has no attribute \"" + name + "\"");
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
    if (H5Sget_simple_extent_npoints(space) != 1 ||
        H5Tget_class(type) != H5T_STRING)
      refuse("its attribute \"" + name + "\" is no text");
    // HDF5 1.10 crashes on damaged texts of variable length.
    if (H5Tis_variable_str(type) != 0)
      refuse("its attribute \"" + name + "\" is a text of variable length");
    const std::size_t size = H5Tget_size(type);
    if (size == 0 || size > longest_text)
      refuse("its attribute \"" + name + "\" is damaged");
    std::string text(size, '\0');
    if (H5Aread(attribute, type, &text[0]) < 0)
      refuse("its attribute \"" + name + "\" is damaged");
    return text.substr(0, text.find('\0'));
  }
} // namespace io
} // namespace contrecoup
