// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/numpy.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace contrecoup
{
namespace io
{
  void write_npy(const std::string &file,
                 const std::vector<std::size_t> &shape,
                 const std::vector<double> &data)
  {
    const std::size_t size = std::accumulate(
      shape.begin(), shape.end(), std::size_t(1), std::multiplies<>());
    if (size != data.size())
      throw std::invalid_argument("write_npy: shape and data differ");

    // Padding aligns the data to a multiple of 64 bytes.
    constexpr std::size_t alignment = 64, preamble = 10;
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (";
    for (const std::size_t n : shape)
      header += std::to_string(n) + ",";
    header += "), }";
    const std::size_t used = preamble + header.size() + 1;
    header.append((alignment - used % alignment) % alignment, ' ');
    header += '\n';
    const auto length = static_cast<std::uint16_t>(header.size());
    write_file(file, [&](std::ostream &out) {
      out << std::string("\x93NUMPY\x01\x00", 8)
          << static_cast<char>(length & 0xff) << static_cast<char>(length >> 8)
          << header;
      out.write(reinterpret_cast<const char *>(data.data()),
                static_cast<std::streamsize>(size * sizeof(double)));
    });
  }

  NumpyArray read_npy(const std::string &file)
  {
    require_readable("the array", file);
    const std::string content = read_file(file);
    const std::string mark = "'shape': (";
    const std::size_t end = content.find('\n');
    const std::size_t shape = content.find(mark);
    const bool is_known = content.compare(0, 6, "\x93NUMPY") == 0 &&
                          content.find("'<f8', 'fortran_order': False") < end &&
                          shape < end && end != std::string::npos;
    NumpyArray array;
    if (is_known)
      for (const char *at = content.c_str() + shape + mark.size(); *at != ')';)
      {
        char *after = nullptr;
        array.shape.push_back(std::strtoull(at, &after, 10));
        if (after == at)
          break;
        at = after + (*after == ',' ? 1 : 0);
      }
    const std::size_t size = std::accumulate(array.shape.begin(),
                                             array.shape.end(),
                                             std::size_t(1),
                                             std::multiplies<>());
    // Sizes in a damaged file may have any product.
    const std::size_t bytes = is_known ? content.size() - end - 1 : 0;
    if (!is_known || bytes % sizeof(double) != 0 ||
        bytes / sizeof(double) != size)
      throw InputError("\"" + file +
                       "\" is not an array of doubles as runs write it");
    array.data.resize(size);
    std::memcpy(
      array.data.data(), content.data() + end + 1, size * sizeof(double));
    return array;
  }

  void write_plane(const std::string &stem, const PlaneSamples &plane)
  {
    write_npy(
      stem + ".npy", {plane.n_points[1], plane.n_points[0]}, plane.values);
    const nlohmann::ordered_json description = {
      {"quantity", plane.quantity},
      {"unit", plane.unit},
      {"time", plane.time},
      {"axes", {plane.axes[0], plane.axes[1]}},
      {"lower", {plane.lower[0], plane.lower[1]}},
      {"upper", {plane.upper[0], plane.upper[1]}}};
    write_file(stem + ".json",
               [&](std::ostream &out) { out << description.dump(2) << '\n'; });
  }
} // namespace io
} // namespace contrecoup
