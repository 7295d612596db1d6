// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace contrecoup
{
/// Form in which a file states where its voxels are in space.
enum class Form
{
  matrix,
  quaternion,
  none
};

/// A NIfTI-1 file of 16-bit numbers, in mm, with voxels of these sizes, the
/// first axis to the left (-x of NIfTI), the second to the front, the third up;
/// without a form the first is to the right.
struct Header
{
  std::array<short, 3> size;
  std::array<float, 3> spacing{{1.F, 1.F, 1.F}};
  float oblique = 0.F;
  short frames = 1;
  Form form = Form::matrix;
  std::array<float, 3> place{{0.F, 0.F, 0.F}}; ///< of the first voxel
  char unit = 2;                               ///< 1: m, 2: mm, 3: micrometre
  short type = 4, bits = 16;                   ///< 4: 16-bit integers
  float slope = 0.F, intercept = 0.F;
};

template <typename Number>
std::string make_nifti(const Header &h,
                       const std::vector<Number> &values,
                       const bool is_pair = false)
{
  std::string bytes(is_pair ? 348 : 352, '\0');
  const auto put = [&](const std::size_t offset, const auto number) {
    std::copy_n(
      reinterpret_cast<const char *>(&number), sizeof(number), &bytes[offset]);
  };
  put(0, 348);
  const short dimensions = h.frames > 1 ? 4 : 3;
  const std::array<short, 5> dim{
    {dimensions, h.size[0], h.size[1], h.size[2], h.frames}};
  for (unsigned int d = 0; d < 5; ++d)
    put(40 + 2 * d, dim[d]);
  put(70, h.type);
  put(72, h.bits);
  for (unsigned int d = 0; d < 3; ++d)
    put(80 + 4 * d, h.spacing[d]);
  put(108, is_pair ? 0.F : 352.F);
  put(112, h.slope);
  put(116, h.intercept);
  bytes[123] = h.unit;
  put(252, short(h.form == Form::quaternion));
  put(254, short(h.form == Form::matrix));
  // Half a turn around the second axis, and the third one reversed.
  put(76, -1.F);
  put(260, 1.F);
  put(280, -h.spacing[0]);
  put(284, h.oblique);
  put(300, h.spacing[1]);
  put(320, h.spacing[2]);
  for (unsigned int d = 0; d < 3; ++d)
  {
    put(268 + 4 * d, h.place[d]);
    put(292 + 16 * d, h.place[d]);
  }
  bytes.replace(344, 3, is_pair ? "ni1" : "n+1");
  const std::string data(reinterpret_cast<const char *>(values.data()),
                         sizeof(Number) * values.size());
  return is_pair ? bytes : bytes + data;
}
} // namespace contrecoup
