// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/io/hdf5_handle.h>
#include <contrecoup/io/load_reader.h>

namespace contrecoup
{
namespace io
{
  namespace
  {
    using Handle = Hdf5Handle;

    /// A whole dataset of numbers. @throws InputError
    std::vector<double>
    read_all(const hid_t file, const std::string &name, const std::string &path)
    {
      const Handle data(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
      if (data < 0)
        throw InputError("\"" + path + "\" has no dataset \"" + name +
                         "\": it is no file of loads");
      const Handle space(H5Dget_space(data), H5Sclose);
      std::vector<double> values(
        static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
      if (H5Dread(data,
                  H5T_NATIVE_DOUBLE,
                  H5S_ALL,
                  H5S_ALL,
                  H5P_DEFAULT,
                  values.data()) < 0)
        throw SystemError("\"" + path + "\" cannot be read");
      return values;
    }
  } // namespace


  LoadReader::LoadReader(const std::string &path)
    : path_(path)
  {
    H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                      H5Fclose);
    if (file < 0)
      throw InputError("\"" + path + "\" cannot be read as a file of loads");
    facets_.centroids = read_all(file, "centroid", path);
    facets_.normals = read_all(file, "normal", path);
    facets_.areas = read_all(file, "area", path);
    times_ = read_all(file, "time", path);
    const std::size_t n = 3 * facets_.areas.size();
    if (facets_.centroids.size() != n || facets_.normals.size() != n)
      throw InputError("\"" + path +
                       "\" is no file of loads: its centroids "
                       "and areas differ in number");
  }


  std::vector<float> LoadReader::read(const std::size_t first,
                                      const std::size_t count) const
  {
    std::vector<float> values(n_facets() * count);
    const Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                      H5Fclose);
    const Handle data(H5Dopen2(file, "overpressure", H5P_DEFAULT), H5Dclose);
    const Handle space(H5Dget_space(data), H5Sclose);
    const hsize_t begin[] = {0, first}, size[] = {n_facets(), count};
    const Handle memory(H5Screate_simple(2, size, nullptr), H5Sclose);
    if (H5Sselect_hyperslab(
          space, H5S_SELECT_SET, begin, nullptr, size, nullptr) < 0 ||
        H5Dread(
          data, H5T_NATIVE_FLOAT, memory, space, H5P_DEFAULT, values.data()) <
          0)
      throw SystemError("\"" + path_ + "\" cannot be read");
    return values;
  }
} // namespace io
} // namespace contrecoup
