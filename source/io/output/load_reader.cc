// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/hdf5_input.h>
#include <contrecoup/io/output/load_reader.h>

#include <algorithm>
#include <numeric>

namespace contrecoup
{
namespace io
{

  namespace
  {
    /// Number of recorded samples in memory at once.
    constexpr std::size_t samples_at_once = 64;

    /// By the factors from the recorded impulse to that of the whole body,
    /// such as "2, 0, 2".
    std::optional<std::array<bool, 3>> symmetry_of(const Hdf5Input &file)
    {
      const char *const name = "factors_to_whole_body";
      if (!file.has_attribute(name))
        return {};
      const std::vector<std::string> factors = split(file.text(name), ',');
      if (factors.size() != 3)
        return {};
      return std::array<bool, 3>{
        {factors[0] == "0", factors[1] == "0", factors[2] == "0"}};
    }
  } // namespace


  LoadReader::LoadReader(const std::string &path, const double interval)
    : path_(path)
  {
    const Hdf5Input file(path);
    // Loads of other programs need not have a format.
    if (file.has_attribute("format"))
      require_format(formats::loads, file.text("format"), path);
    facets_.centroids = file.numbers("centroid");
    facets_.normals = file.numbers("normal");
    facets_.areas = file.numbers("area");
    times_ = file.numbers("time");
    symmetry_ = symmetry_of(file);
    const std::size_t n = 3 * facets_.areas.size();
    if (facets_.centroids.size() != n || facets_.normals.size() != n)
      throw InputError("\"" + path +
                       "\" is no file of loads: its centroids "
                       "and areas differ in number");
    if (interval > 0. && times_.size() > 1)
      merge(interval);
  }


  void LoadReader::merge(const double interval)
  {
    const std::vector<double> ends = times_;
    const std::size_t n = ends.size();
    durations_ = {ends[0]};
    for (std::size_t i = 1; i < n; ++i)
      durations_.push_back(ends[i] - ends[i - 1]);
    times_.clear();
    const auto add = [this](const Group &group, const double end) {
      groups_.push_back(group);
      times_.push_back(end);
    };
    if (interval > durations_[1] && ends[0] > interval)
      add({0, 1}, ends[0] - interval);
    add({0, 1}, ends[0]);
    double wanted = ends[0] + interval;
    for (std::size_t i = 1, begin = 1; i < n; ++i)
    {
      // Beyond this midpoint, no later end is nearer to the wanted time.
      const double middle = i + 1 < n ? 0.5 * (ends[i] + ends[i + 1]) : ends[i];
      if (i + 1 < n && middle < wanted)
        continue;
      add({begin, i + 1}, ends[i]);
      begin = i + 1;
      while (wanted <= middle)
        wanted += interval;
    }
  }


  std::vector<float> LoadReader::read(const std::size_t first,
                                      const std::size_t count) const
  {
    if (groups_.empty())
      return read_recorded(first, count);
    std::vector<double> sums(n_facets() * count, 0.);
    const std::size_t end = groups_[first + count - 1].end;
    for (std::size_t begin = groups_[first].begin; begin < end;
         begin += samples_at_once)
    {
      const std::size_t n = std::min(samples_at_once, end - begin);
      const std::vector<float> samples = read_recorded(begin, n);
      for (std::size_t k = 0; k < count; ++k)
        add_part(groups_[first + k], begin, n, samples, &sums[k], count);
    }
    return std::vector<float>(sums.begin(), sums.end());
  }


  void LoadReader::add_part(const Group &group,
                            const std::size_t begin,
                            const std::size_t n,
                            const std::vector<float> &samples,
                            double *means,
                            const std::size_t stride) const
  {
    const auto first = durations_.begin();
    const double whole =
      std::accumulate(first + group.begin, first + group.end, 0.);
    for (std::size_t i = std::max(group.begin, begin);
         i < std::min(group.end, begin + n);
         ++i)
      for (std::size_t facet = 0; facet < n_facets(); ++facet)
        means[facet * stride] +=
          durations_[i] / whole * double(samples[facet * n + i - begin]);
  }


  std::vector<float> LoadReader::read_recorded(const std::size_t first,
                                               const std::size_t count) const
  {
    std::vector<float> values(n_facets() * count);
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                          H5Fclose);
    const Hdf5Handle data(H5Dopen2(file, "overpressure", H5P_DEFAULT),
                          H5Dclose);
    const Hdf5Handle space(H5Dget_space(data), H5Sclose);
    const hsize_t begin[] = {0, first}, size[] = {n_facets(), count};
    const Hdf5Handle memory(H5Screate_simple(2, size, nullptr), H5Sclose);
    if (H5Sselect_hyperslab(
          space, H5S_SELECT_SET, begin, nullptr, size, nullptr) < 0 ||
        H5Dread(
          data, H5T_NATIVE_FLOAT, memory, space, H5P_DEFAULT, values.data()) <
          0)
      throw InputError("\"" + path_ +
                       "\" cannot be read: its dataset "
                       "\"overpressure\" is missing, too short or damaged");
    return values;
  }
} // namespace io
} // namespace contrecoup
