// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/image/voxel_image.h>

#include <nifti/nifti1_io.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

namespace contrecoup
{
namespace
{
  using NiftiPointer = std::unique_ptr<nifti_image, void (*)(nifti_image *)>;
  using GzipPointer = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

  [[noreturn]] void refuse(const std::string &file, const std::string &why)
  {
    throw InputError("image \"" + file + "\" cannot be read: " + why);
  }

  /// Opens a file that may be compressed, whatever its name.
  GzipPointer open(const std::string &file)
  {
    GzipPointer stream(gzopen(file.c_str(), "rb"), gzclose);
    if (stream == nullptr)
      refuse(file, "it cannot be opened");
    return stream;
  }

  /// At most @p count bytes; fewer where the file ends.
  /// @throws InputError for damaged compressed content
  std::string read_bytes(const std::string &file,
                         const gzFile stream,
                         const std::size_t count)
  {
    std::string bytes;
    // Memory grows with what the file has, not with what it claims.
    constexpr std::size_t most = 1 << 20;
    while (bytes.size() < count)
    {
      const std::size_t before = bytes.size();
      bytes.resize(std::min(count, before + most));
      const int n_read = gzread(stream, &bytes[before], bytes.size() - before);
      int error = Z_OK;
      gzerror(stream, &error);
      if (error != Z_OK && error != Z_BUF_ERROR)
        refuse(file, "its compressed content is damaged");
      bytes.resize(before + std::max(n_read, 0));
      if (n_read <= 0)
        break;
    }
    return bytes;
  }

  NiftiPointer read_header(const std::string &file)
  {
    const std::string bytes =
      read_bytes(file, open(file).get(), sizeof(nifti_1_header));
    nifti_1_header header;
    constexpr int size_of_nifti_2 = 540;
    int size = 0;
    std::memcpy(&size, bytes.data(), std::min(bytes.size(), sizeof(size)));
    if (size == size_of_nifti_2)
      refuse(file, "it is NIfTI-2; save it as NIfTI-1");
    nifti_set_debug_level(0);
    NiftiPointer source(nullptr, nifti_image_free);
    if (bytes.size() == sizeof(header))
    {
      std::memcpy(&header, bytes.data(), sizeof(header));
      source.reset(nifti_convert_nhdr2nim(header, file.c_str()));
    }
    if (source == nullptr)
      refuse(file,
             "its header is none of NIfTI-1 (.nii, .nii.gz, or .hdr with "
             ".img)");
    return source;
  }

  /// The file with the values, which may be the header's own.
  std::string file_of_values(const std::string &file, const nifti_image &source)
  {
    if (source.nifti_type == NIFTI_FTYPE_NIFTI1_1)
      return file;
    const std::unique_ptr<char, void (*)(void *)> name(
      nifti_findimgname(file.c_str(), source.nifti_type), std::free);
    if (name == nullptr)
      refuse(file, "the .img of its header is missing");
    return name.get();
  }

  /// The values in the byte order of this machine.
  std::string read_values(const std::string &file, const nifti_image &source)
  {
    const std::string name = file_of_values(file, source);
    const GzipPointer stream = open(name);
    if (source.iname_offset < 0)
      refuse(file, "its values begin before the file");
    const std::size_t begin = source.iname_offset;
    const std::size_t wanted =
      source.nvox * static_cast<std::size_t>(source.nbyper);
    std::string values;
    if (read_bytes(name, stream.get(), begin).size() == begin)
      values = read_bytes(name, stream.get(), wanted);
    if (values.size() < wanted)
      refuse(name,
             "it is cut: it has " + std::to_string(values.size()) + " of the " +
               std::to_string(wanted) +
               " bytes of voxels that its header "
               "states");
    if (source.swapsize > 1 && source.byteorder != nifti_short_order())
      nifti_swap_Nbytes(
        wanted / source.swapsize, source.swapsize, values.data());
    return values;
  }

  template <typename Number>
  void copy(const std::string &bytes,
            const double slope,
            const double shift,
            std::vector<float> &values)
  {
    Number number;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      std::memcpy(&number, &bytes[i * sizeof(Number)], sizeof(Number));
      values[i] =
        static_cast<float>(slope * static_cast<double>(number) + shift);
    }
  }

  void copy_values(const nifti_image &source, VoxelImage &image)
  {
    const std::string bytes = read_values(image.file, source);
    const double slope = source.scl_slope == 0. ? 1. : source.scl_slope;
    const double shift = source.scl_slope == 0. ? 0. : source.scl_inter;
    std::vector<float> &values = image.values;
    values.resize(source.nvox);
    switch (source.datatype)
    {
      case DT_UINT8:
        return copy<std::uint8_t>(bytes, slope, shift, values);
      case DT_INT8:
        return copy<std::int8_t>(bytes, slope, shift, values);
      case DT_INT16:
        return copy<std::int16_t>(bytes, slope, shift, values);
      case DT_UINT16:
        return copy<std::uint16_t>(bytes, slope, shift, values);
      case DT_INT32:
        return copy<std::int32_t>(bytes, slope, shift, values);
      case DT_UINT32:
        return copy<std::uint32_t>(bytes, slope, shift, values);
      case DT_INT64:
        return copy<std::int64_t>(bytes, slope, shift, values);
      case DT_UINT64:
        return copy<std::uint64_t>(bytes, slope, shift, values);
      case DT_FLOAT32:
        return copy<float>(bytes, slope, shift, values);
      case DT_FLOAT64:
        return copy<double>(bytes, slope, shift, values);
      default:
        throw InputError("image \"" + image.file + "\": its values are " +
                         nifti_datatype_string(source.datatype) +
                         "; accepted are integers of up to 64 bits, FLOAT32 "
                         "and FLOAT64");
    }
  }

  /// Values that are no numbers count as 0, as programs for medical images
  /// take them.
  void replace_unknown(VoxelImage &image)
  {
    std::size_t n_unknown = 0;
    for (float &value : image.values)
      if (!std::isfinite(value))
      {
        value = 0.F;
        ++n_unknown;
      }
    if (n_unknown > 0)
      image.remarks.push_back("WARNING: image \"" + image.file +
                              "\": " + std::to_string(n_unknown) +
                              " of its values are not finite numbers; they "
                              "count as 0");
  }

  double length_of_unit(const int units)
  {
    if (units == NIFTI_UNITS_METER)
      return 1.;
    return units == NIFTI_UNITS_MICRON ? 1e-6 : 1e-3;
  }

  /// Whether the axes of a form, its first three columns, span a space.
  bool spans_space(const mat44 &form)
  {
    dealii::Tensor<2, 3> axes;
    double lengths = 1.;
    for (unsigned int column = 0; column < 3; ++column)
    {
      dealii::Tensor<1, 3> axis;
      for (unsigned int row = 0; row < 3; ++row)
        axis[row] = axes[row][column] = form.m[row][column];
      lengths *= axis.norm();
    }
    return std::isfinite(lengths) &&
           std::abs(determinant(axes)) > 1e-6 * lengths;
  }

  /// From voxel numbers to positions, in the header's unit.
  mat44 choose_form(const nifti_image &source, VoxelImage &image)
  {
    const std::string where = "image \"" + image.file + "\": ";
    if (source.sform_code > 0 && spans_space(source.sto_xyz))
      return source.sto_xyz;
    if (source.qform_code > 0 && spans_space(source.qto_xyz))
    {
      if (source.sform_code > 0)
        image.remarks.push_back(where +
                                "the axes of its sform span no space; its "
                                "qform places the voxels");
      return source.qto_xyz;
    }
    mat44 sizes{};
    for (unsigned int d = 0; d < 3; ++d)
      sizes.m[d][d] = source.pixdim[d + 1];
    if (source.sform_code > 0 || source.qform_code > 0 || !spans_space(sizes))
      throw InputError(where + "the axes of its voxels span no space");
    image.remarks.push_back(
      "WARNING: " + where +
      "its orientation codes (qform_code, sform_code) are 0, so left and right "
      "are unknown; the first axis of its voxels counts as pointing right, the "
      "second forward, the third up");
    return sizes;
  }

  /// Remarks on what the header leaves open, or contradicts itself about.
  void
  add_remarks(const nifti_image &source, const mat44 &form, VoxelImage &image)
  {
    const std::string where = "image \"" + image.file + "\": ";
    if (source.xyz_units == NIFTI_UNITS_UNKNOWN)
      image.remarks.push_back(where +
                              "its header has no unit of length; mm is taken");
    constexpr double tolerance = 0.01;
    std::vector<std::string> sizes, lengths;
    bool agree = true, are_set = false;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double length =
        std::hypot(form.m[0][d], form.m[1][d], form.m[2][d]);
      agree &= std::abs(source.pixdim[d + 1] - length) <= tolerance * length;
      // Some programs set the sform alone.
      are_set |= source.pixdim[d + 1] != 1.F;
      sizes.push_back(brief(source.pixdim[d + 1]));
      lengths.push_back(brief(length));
    }
    if (!agree)
      image.remarks.push_back(
        (are_set ? "WARNING: " : "") + where +
        (are_set ? "its header has voxels of " + join(sizes, " x ") +
                     " (pixdim), but of "
                 : "the sizes of its voxels are not set (pixdim), they are ") +
        join(lengths, " x ") + " by its sform, which counts");
    image.remarks.push_back(
      where + "before Body/Rotation, the front of its header (+y) is +x of the "
              "body, its left (-x) is +y, and up is +z");
  }

  /// NIfTI axes point right, forward and up.
  void copy_place(const nifti_image &source, VoxelImage &image)
  {
    const mat44 placement = choose_form(source, image);
    add_remarks(source, placement, image);
    const auto &form = placement.m;
    const double unit = length_of_unit(source.xyz_units);
    for (unsigned int column = 0; column < 3; ++column)
    {
      image.axes[0][column] = unit * form[1][column];
      image.axes[1][column] = -unit * form[0][column];
      image.axes[2][column] = unit * form[2][column];
    }
    image.origin = unit * dealii::Point<3>(form[1][3], -form[0][3], form[2][3]);
  }

  /// The voxel axis that is nearest to each spatial axis.
  std::array<unsigned int, 3> nearest_axes(const VoxelImage &image)
  {
    const auto spacing = image.spacing();
    std::array<unsigned int, 3> order{{0, 1, 2}}, best = order;
    double largest = -1.;
    do
    {
      double sum = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        sum += std::abs(image.axes[d][order[d]]) / spacing[order[d]];
      if (sum > largest)
      {
        largest = sum;
        best = order;
      }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
  }

  /// Stores voxels in the order of the spatial axes, so that nothing depends
  /// on the order in the file.
  void sort_axes(VoxelImage &image)
  {
    const VoxelImage before = image;
    const std::array<unsigned int, 3> axis = nearest_axes(before);
    std::array<bool, 3> is_reversed{};
    for (unsigned int d = 0; d < 3; ++d)
    {
      image.size[d] = before.size[axis[d]];
      is_reversed[d] = before.axes[d][axis[d]] < 0.;
      for (unsigned int row = 0; row < 3; ++row)
      {
        const double component = before.axes[row][axis[d]];
        image.axes[row][d] = is_reversed[d] ? -component : component;
        if (is_reversed[d])
          image.origin[row] += component * (image.size[d] - 1);
      }
    }
    std::array<unsigned int, 3> to{};
    std::size_t number = 0;
    for (to[2] = 0; to[2] < image.size[2]; ++to[2])
      for (to[1] = 0; to[1] < image.size[1]; ++to[1])
        for (to[0] = 0; to[0] < image.size[0]; ++to[0], ++number)
        {
          std::array<unsigned int, 3> from{};
          for (unsigned int d = 0; d < 3; ++d)
            from[axis[d]] = is_reversed[d] ? image.size[d] - 1 - to[d] : to[d];
          image.values[number] =
            before.values[before.index(from[0], from[1], from[2])];
        }
  }
} // namespace


std::array<double, 3> VoxelImage::spacing() const
{
  std::array<double, 3> lengths;
  for (unsigned int column = 0; column < 3; ++column)
    lengths[column] =
      dealii::Point<3>(axes[0][column], axes[1][column], axes[2][column])
        .norm();
  return lengths;
}

VoxelImage read_image(const std::string &file)
{
  require_readable("the image", file);
  const NiftiPointer source = read_header(file);
  if (source->nx < 1 || source->ny < 1 || source->nz < 1 ||
      source->nvox !=
        static_cast<std::size_t>(source->nx) * source->ny * source->nz)
    throw InputError("image \"" + file +
                     "\": it must have three dimensions "
                     "and one frame");
  VoxelImage image;
  image.file = file;
  image.size = {{static_cast<unsigned int>(source->nx),
                 static_cast<unsigned int>(source->ny),
                 static_cast<unsigned int>(source->nz)}};
  copy_values(*source, image);
  replace_unknown(image);
  copy_place(*source, image);
  sort_axes(image);
  return image;
}

void require_same_grid(const VoxelImage &a, const VoxelImage &b)
{
  const double tolerance = 1e-3 * a.spacing()[0];
  if (a.size != b.size || (a.axes - b.axes).norm() > tolerance ||
      (a.origin - b.origin).norm() > tolerance)
    throw InputError("images \"" + a.file + "\" and \"" + b.file +
                     "\" do not have the same voxels");
}
} // namespace contrecoup
