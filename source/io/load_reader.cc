// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/io/hdf5_input.h>
#include <contrecoup/io/load_reader.h>

namespace contrecoup
{
namespace io
{
  using Handle = Hdf5Handle;


  LoadReader::LoadReader(const std::string &path)
    : path_(path)
  {
    const Hdf5Input file(path);
    facets_.centroids = file.numbers("centroid");
    facets_.normals = file.numbers("normal");
    facets_.areas = file.numbers("area");
    times_ = file.numbers("time");
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
