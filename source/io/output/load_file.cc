// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/hdf5_handle.h>
#include <contrecoup/io/output/load_file.h>

#include <algorithm>
#include <map>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Description of a dataset in the file.
    struct Label
    {
      std::vector<const char *> axes;
      const char *units;
      const char *description;
    };

    const std::map<std::string, Label> labels = {
      {"centroid",
       {{"facet", "direction"},
        "m",
        "place on the surface that is nearest to the middle of the cut cell"}},
      {"normal", {{"facet", "direction"}, "-", "unit normal, out of the body"}},
      {"area", {{"facet"}, "m^2", "area"}},
      {"vertex", {{"vertex", "direction"}, "m", "corners of facets"}},
      {"connectivity",
       {{"number"},
        "-",
        "of each facet its type (3: polygon, 2: line), the number of its "
        "corners, and their vertices: mixed topology of XDMF"}},
      {"time", {{"time"}, "s", "end of each sample"}},
      {"overpressure",
       {{"facet", "time"},
        "Pa",
        "mean overpressure since the time before, of the first sample since "
        "time 0"}},
      {"peak",
       {{"facet"},
        "Pa",
        "largest overpressure of any time step; nan where no blast has come"}},
      {"impulse",
       {{"facet"}, "Pa s", "integral of overpressure, positive phase"}},
      {"arrival", {{"facet"}, "s", "time at which the blast arrives"}},
      {"duration", {{"facet"}, "s", "duration of the positive phase"}}};

    /// An HDF5 object that must exist.
    class Handle : public Hdf5Handle
    {
    public:
      /// @throws SystemError if it does not exist
      Handle(const hid_t id, herr_t (*close)(hid_t), const std::string &path)
        : Hdf5Handle(id, close)
      {
        if (id < 0)
          throw SystemError(path + " cannot be written or read");
      }
    };


    void check(const herr_t status, const std::string &path)
    {
      if (status < 0)
        throw SystemError(path + " cannot be written");
    }


    /// Writes an attribute of a file or dataset.
    void write_attribute(const hid_t file,
                         const std::string &name,
                         const hid_t type,
                         const void *value,
                         const std::string &path)
    {
      if (H5Aexists(file, name.c_str()) > 0)
        check(H5Adelete(file, name.c_str()), path);
      const Handle space(H5Screate(H5S_SCALAR), H5Sclose, path);
      const Handle attribute(
        H5Acreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose,
        path);
      check(H5Awrite(attribute, type, value), path);
    }


    /// Adds the name of an attribute that is a number to a list.
    herr_t add_number(const hid_t file,
                      const char *const name,
                      const H5A_info_t *,
                      void *const names)
    {
      const Hdf5Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
      const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
      if (H5Tget_class(type) == H5T_FLOAT)
        static_cast<std::vector<std::string> *>(names)->emplace_back(name);
      return 0;
    }


    void write_text(const hid_t file,
                    const std::string &name,
                    const std::string &text,
                    const std::string &path)
    {
      const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, path);
      check(H5Tset_size(type, text.size() + 1), path);
      write_attribute(file, name, type, text.c_str(), path);
    }


    /// Writes HDF5's labels of a dataset's dimensions.
    void label_dimensions(const hid_t data,
                          const std::vector<const char *> &axes,
                          const std::string &path)
    {
      const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, path);
      check(H5Tset_size(type, H5T_VARIABLE), path);
      const hsize_t size[] = {axes.size()};
      const Handle space(H5Screate_simple(1, size, nullptr), H5Sclose, path);
      const Handle attribute(
        H5Acreate2(
          data, "DIMENSION_LABELS", type, space, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose,
        path);
      check(H5Awrite(attribute, type, axes.data()), path);
    }


    /// Writes the attributes of a dataset that has a label.
    void
    describe(const hid_t file, const std::string &name, const std::string &path)
    {
      const auto found = labels.find(name);
      if (found == labels.end())
        return;
      const Label &label = found->second;
      const Handle data(
        H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, path);
      write_text(data, "units", label.units, path);
      write_text(data, "description", label.description, path);
      std::string axes;
      for (const char *const axis : label.axes)
        axes += (axes.empty() ? "" : " x ") + std::string(axis);
      write_text(data, "axes", axes, path);
      label_dimensions(data, label.axes, path);
    }


    /// Writes a table with @p n_columns columns.
    void write_table(const hid_t file,
                     const std::string &name,
                     const std::vector<double> &values,
                     const unsigned int n_columns,
                     const std::string &path)
    {
      if (H5Lexists(file, name.c_str(), H5P_DEFAULT) > 0)
      {
        const Handle data(
          H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, path);
        check(H5Dwrite(data,
                       H5T_NATIVE_DOUBLE,
                       H5S_ALL,
                       H5S_ALL,
                       H5P_DEFAULT,
                       values.data()),
              path);
        return;
      }
      const hsize_t size[] = {values.size() / n_columns, n_columns};
      const Handle space(
        H5Screate_simple(n_columns == 1 ? 1 : 2, size, nullptr),
        H5Sclose,
        path);
      const Handle data(H5Dcreate2(file,
                                   name.c_str(),
                                   H5T_NATIVE_DOUBLE,
                                   space,
                                   H5P_DEFAULT,
                                   H5P_DEFAULT,
                                   H5P_DEFAULT),
                        H5Dclose,
                        path);
      check(H5Dwrite(data,
                     H5T_NATIVE_DOUBLE,
                     H5S_ALL,
                     H5S_ALL,
                     H5P_DEFAULT,
                     values.data()),
            path);
      describe(file, name, path);
    }


    /// Creates a compressed dataset.
    Handle create(const hid_t file,
                  const std::string &name,
                  const hid_t type,
                  const hid_t space,
                  const std::vector<hsize_t> &chunk,
                  const std::string &path)
    {
      const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
      check(H5Pset_chunk(properties, chunk.size(), chunk.data()), path);
      check(H5Pset_shuffle(properties), path);
      check(H5Pset_deflate(properties, 4), path);
      const hid_t data = H5Dcreate2(
        file, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
      return Handle(data, H5Dclose, path);
    }


    /// Writes an array once, compressed.
    void write_array(const hid_t file,
                     const std::string &name,
                     const hid_t type,
                     const void *values,
                     const std::vector<hsize_t> &size,
                     const std::string &path)
    {
      std::vector<hsize_t> chunk = size;
      chunk[0] = std::min<hsize_t>(chunk[0], 1 << 16);
      const Handle space(
        H5Screate_simple(size.size(), size.data(), nullptr), H5Sclose, path);
      const Handle data = create(file, name, type, space, chunk, path);
      check(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path);
      describe(file, name, path);
    }


    void write_corners(const hid_t file,
                       const SkinMesh &corners,
                       const std::string &path)
    {
      if (corners.corners.empty())
        return;
      constexpr std::int32_t line = 2, polygon = 3; // XDMF's numbers
      std::vector<std::int32_t> connectivity;
      std::int64_t begin = 0;
      for (const std::int64_t end : corners.ends)
      {
        connectivity.push_back(corners.are_lines ? line : polygon);
        connectivity.push_back(static_cast<std::int32_t>(end - begin));
        connectivity.insert(connectivity.end(),
                            corners.corners.begin() + begin,
                            corners.corners.begin() + end);
        begin = end;
      }
      write_array(file,
                  "vertex",
                  H5T_NATIVE_FLOAT,
                  corners.vertices.data(),
                  {corners.vertices.size() / 3, 3},
                  path);
      write_array(file,
                  "connectivity",
                  H5T_NATIVE_INT32,
                  connectivity.data(),
                  {connectivity.size()},
                  path);
      if (corners.are_lines)
      {
        const Handle area(H5Dopen2(file, "area", H5P_DEFAULT), H5Dclose, path);
        write_text(area, "units", "m", path);
        write_text(area, "description", "length, per depth", path);
      }
    }


    /// Creates an empty dataset with an extendible last dimension.
    void create_growing(const hid_t file,
                        const std::string &name,
                        const hid_t type,
                        const std::vector<hsize_t> &chunk,
                        std::vector<hsize_t> size,
                        const std::string &path)
    {
      std::vector<hsize_t> largest = size;
      largest.back() = H5S_UNLIMITED;
      const Handle space(
        H5Screate_simple(size.size(), size.data(), largest.data()),
        H5Sclose,
        path);
      create(file, name, type, space, chunk, path);
      describe(file, name, path);
    }


    std::vector<hsize_t> size_of(const hid_t data, const std::string &path)
    {
      const Handle space(H5Dget_space(data), H5Sclose, path);
      std::vector<hsize_t> size(H5Sget_simple_extent_ndims(space));
      H5Sget_simple_extent_dims(space, size.data(), nullptr);
      return size;
    }


    /// Appends values along the last dimension.
    void append_to(const hid_t file,
                   const std::string &name,
                   const hid_t type,
                   const void *values,
                   const hsize_t n_times,
                   const std::string &path)
    {
      const Handle data(
        H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, path);
      std::vector<hsize_t> size = size_of(data, path);
      std::vector<hsize_t> begin(size.size(), 0), count = size;
      begin.back() = size.back();
      count.back() = n_times;
      size.back() += n_times;
      check(H5Dset_extent(data, size.data()), path);
      const Handle space(H5Dget_space(data), H5Sclose, path);
      check(
        H5Sselect_hyperslab(
          space, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr),
        path);
      const Handle memory(
        H5Screate_simple(count.size(), count.data(), nullptr), H5Sclose, path);
      check(H5Dwrite(data, type, memory, space, H5P_DEFAULT, values), path);
    }


    Handle open_file(const std::string &path)
    {
      H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
      return Handle(
        H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, path);
    }
  } // namespace


  LoadFile::LoadFile(const std::string &path)
    : path_(path)
  {}


  void LoadFile::create(const Facets &facets, const Words &words)
  {
    H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
    const Handle file(
      H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
      H5Fclose,
      path_);
    write_text(file, "format", format_text(formats::loads), path_);
    for (const auto &[name, value] : words)
      write_text(file, name, value, path_);
    write_table(file, "centroid", facets.centroids, 3, path_);
    write_table(file, "normal", facets.normals, 3, path_);
    write_table(file, "area", facets.areas, 1, path_);
    write_corners(file, facets.corners, path_);
    const hsize_t n = facets.areas.size();
    create_growing(file, "time", H5T_NATIVE_DOUBLE, {1024}, {0}, path_);
    create_growing(
      file,
      "overpressure",
      H5T_NATIVE_FLOAT,
      {std::min<hsize_t>(std::max<hsize_t>(n, 1), 1024), chunk_times},
      {n, 0},
      path_);
  }


  void LoadFile::append(const std::vector<double> &times,
                        const std::vector<float> &overpressures)
  {
    const std::size_t n_times = times.size();
    if (n_times == 0)
      return;
    const std::size_t n_facets = overpressures.size() / n_times;
    std::vector<float> turned(overpressures.size());
    for (std::size_t t = 0; t < n_times; ++t)
      for (std::size_t f = 0; f < n_facets; ++f)
        turned[f * n_times + t] = overpressures[t * n_facets + f];
    const Handle file = open_file(path_);
    append_to(file, "time", H5T_NATIVE_DOUBLE, times.data(), n_times, path_);
    append_to(
      file, "overpressure", H5T_NATIVE_FLOAT, turned.data(), n_times, path_);
  }


  void LoadFile::write(const std::string &name,
                       const std::vector<double> &values)
  {
    const Handle file = open_file(path_);
    write_table(file, name, values, 1, path_);
  }


  void LoadFile::write(const Numbers &numbers)
  {
    const Handle file = open_file(path_);
    // A checkpoint has others, as of phases that have ended since.
    std::vector<std::string> old;
    check(H5Aiterate2(
            file, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add_number, &old),
          path_);
    for (const std::string &name : old)
      check(H5Adelete(file, name.c_str()), path_);
    for (const auto &[name, value] : numbers)
      write_attribute(file, name, H5T_NATIVE_DOUBLE, &value, path_);
  }
} // namespace io
} // namespace contrecoup
