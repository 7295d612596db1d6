// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/geometry/image/voxel_image.h>

#include <nifti/nifti1_io.h>
#include <zlib.h>

#include <memory>

namespace contrecoup
{
namespace
{
  using NiftiPointer = std::unique_ptr<nifti_image, void (*)(nifti_image *)>;

  /// Whether the file has all values that the header promises; the library
  /// reads missing values as 0.
  bool is_complete(const nifti_image &source)
  {
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(
      gzopen(source.iname, "rb"), gzclose);
    if (file == nullptr)
      return false;
    std::size_t missing = source.iname_offset +
                          source.nvox * static_cast<std::size_t>(source.nbyper);
    std::vector<char> buffer(1 << 20);
    while (missing > 0)
    {
      const int count =
        gzread(file.get(), buffer.data(), std::min(missing, buffer.size()));
      if (count <= 0)
        return false;
      missing -= count;
    }
    return true;
  }

  template <typename Number>
  void copy(const void *data,
            const double slope,
            const double shift,
            std::vector<float> &values)
  {
    const Number *numbers = static_cast<const Number *>(data);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<float>(slope * numbers[i] + shift);
  }

  void copy_values(const nifti_image &source, VoxelImage &image)
  {
    const double slope = source.scl_slope == 0. ? 1. : source.scl_slope;
    const double shift = source.scl_slope == 0. ? 0. : source.scl_inter;
    std::vector<float> &values = image.values;
    switch (source.datatype)
    {
      case DT_UINT8:
        return copy<unsigned char>(source.data, slope, shift, values);
      case DT_INT8:
        return copy<signed char>(source.data, slope, shift, values);
      case DT_INT16:
        return copy<short>(source.data, slope, shift, values);
      case DT_UINT16:
        return copy<unsigned short>(source.data, slope, shift, values);
      case DT_INT32:
        return copy<int>(source.data, slope, shift, values);
      case DT_UINT32:
        return copy<unsigned int>(source.data, slope, shift, values);
      case DT_FLOAT32:
        return copy<float>(source.data, slope, shift, values);
      case DT_FLOAT64:
        return copy<double>(source.data, slope, shift, values);
      default:
        throw InputError("image \"" + image.file + "\": its values are " +
                         nifti_datatype_string(source.datatype) +
                         ", not real numbers");
    }
  }

  double length_of_unit(const int units)
  {
    if (units == NIFTI_UNITS_METER)
      return 1.;
    return units == NIFTI_UNITS_MICRON ? 1e-6 : 1e-3;
  }

  /// NIfTI axes point right, forward and up.
  void copy_place(const nifti_image &source, VoxelImage &image)
  {
    dealii::Tensor<2, 3> to_right_front_up;
    dealii::Tensor<1, 3> shift;
    const bool has_form = source.sform_code > 0 || source.qform_code > 0;
    const auto &form =
      (source.sform_code > 0 ? source.sto_xyz : source.qto_xyz).m;
    const std::array<double, 3> sizes{{source.dx, source.dy, source.dz}};
    for (unsigned int row = 0; row < 3; ++row)
    {
      for (unsigned int column = 0; column < 3; ++column)
        to_right_front_up[row][column] =
          has_form ? form[row][column] : (row == column ? sizes[row] : 0.);
      shift[row] = has_form ? form[row][3] : 0.;
    }
    const double unit = length_of_unit(source.xyz_units);
    for (unsigned int column = 0; column < 3; ++column)
    {
      image.axes[0][column] = unit * to_right_front_up[1][column];
      image.axes[1][column] = -unit * to_right_front_up[0][column];
      image.axes[2][column] = unit * to_right_front_up[2][column];
    }
    image.origin = unit * dealii::Point<3>(shift[1], -shift[0], shift[2]);
  }

  void check(const VoxelImage &image)
  {
    for (const float value : image.values)
      if (!std::isfinite(value))
        throw InputError("image \"" + image.file +
                         "\": it has values that are not finite numbers");
    const auto spacing = image.spacing();
    const double volume = std::abs(determinant(image.axes));
    if (!(volume > 1e-6 * spacing[0] * spacing[1] * spacing[2]))
      throw InputError("image \"" + image.file +
                       "\": the axes of its voxels span no space");
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
  nifti_set_debug_level(0);
  const NiftiPointer source(nifti_image_read(file.c_str(), 1),
                            nifti_image_free);
  if (source == nullptr || source->data == nullptr || !is_complete(*source))
    throw InputError("image \"" + file +
                     "\" cannot be read: it must be NIfTI-1 (.nii, .nii.gz, "
                     "or .hdr with .img) and complete");
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
  image.values.resize(source->nvox);
  copy_values(*source, image);
  copy_place(*source, image);
  check(image);
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
