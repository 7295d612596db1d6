// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/vtk_file.h>

#include <zlib.h>

namespace contrecoup
{
namespace io
{
  namespace
  {
    template <typename Number>
    const char *type_name();
    template <>
    const char *type_name<double>()
    {
      return "Float64";
    }
    template <>
    const char *type_name<float>()
    {
      return "Float32";
    }
    template <>
    const char *type_name<std::uint32_t>()
    {
      return "UInt32";
    }
    template <>
    const char *type_name<std::int64_t>()
    {
      return "Int64";
    }
    template <>
    const char *type_name<unsigned char>()
    {
      return "UInt8";
    }

    void append_number(std::string &text, const std::uint64_t number)
    {
      text.append(reinterpret_cast<const char *>(&number), sizeof(number));
    }

    /// Text of an attribute in XML.
    std::string escaped(const std::string &text)
    {
      std::string result;
      for (const char letter : text)
        if (letter == '&')
          result += "&amp;";
        else if (letter == '<')
          result += "&lt;";
        else if (letter == '"')
          result += "&quot;";
        else
          result += letter;
      return result;
    }

    /// Compresses data in blocks, with VTK's header: number of blocks, block
    /// size, size of a smaller last block, and compressed sizes.
    std::string compress_blocks(const unsigned char *data,
                                const std::size_t n_bytes)
    {
      constexpr std::size_t block_size = 1 << 20;
      constexpr int fastest = 1;
      const std::size_t n_blocks = (n_bytes + block_size - 1) / block_size;
      std::string header;
      append_number(header, n_blocks);
      append_number(header, block_size);
      append_number(header, n_bytes % block_size);
      std::string content;
      std::vector<unsigned char> buffer(compressBound(block_size));
      for (std::size_t begin = 0; begin < n_bytes; begin += block_size)
      {
        uLongf size = buffer.size();
        const int status = compress2(buffer.data(),
                                     &size,
                                     data + begin,
                                     std::min(block_size, n_bytes - begin),
                                     fastest);
        if (status != Z_OK)
          throw SystemError("zlib cannot compress a field: error " +
                            std::to_string(status));
        append_number(header, size);
        content.append(reinterpret_cast<const char *>(buffer.data()), size);
      }
      return header + content;
    }
  } // namespace

  VtkFile::VtkFile(const std::string &type,
                   const std::string &grid_attributes,
                   const std::string &piece_attributes)
    : type_(type)
    , grid_attributes_(grid_attributes)
    , piece_attributes_(piece_attributes)
  {}

  void VtkFile::add_bytes(const std::string &section,
                          const std::string &attributes,
                          const std::string &unit,
                          const unsigned char *data,
                          const std::size_t n_bytes)
  {
    if (section != section_)
    {
      if (!section_.empty())
        description_ += "</" + section_ + ">\n";
      description_ += "<" + section + ">\n";
      section_ = section;
    }
    const std::string key = "<InformationKey name=\"UNITS_LABEL\" "
                            "location=\"vtkDataArray\">" +
                            unit + "</InformationKey></DataArray>\n";
    description_ += "<DataArray " + attributes +
                    " format=\"appended\" offset=\"" + std::to_string(offset_) +
                    (unit.empty() ? "\"/>\n" : "\">" + key);
    blocks_.push_back(compress_blocks(data, n_bytes));
    offset_ += blocks_.back().size();
  }

  template <typename Number>
  void VtkFile::add(const std::string &section,
                    const std::string &name,
                    const std::vector<Number> &values,
                    const unsigned int n_components,
                    const std::string &unit)
  {
    add_bytes(section,
              "type=\"" + std::string(type_name<Number>()) + "\" Name=\"" +
                name + "\" NumberOfComponents=\"" +
                std::to_string(n_components) + "\"",
              unit,
              reinterpret_cast<const unsigned char *>(values.data()),
              values.size() * sizeof(Number));
  }

  void VtkFile::set_time(const double time)
  {
    field_data_ += "<DataArray type=\"Float64\" Name=\"TimeValue\" "
                   "NumberOfTuples=\"1\" format=\"ascii\">" +
                   exact(time) + "</DataArray>\n";
  }

  void VtkFile::add_names(const std::string &array,
                          const std::vector<std::string> &names)
  {
    for (std::size_t number = 0; number < names.size(); ++number)
      field_data_ += "<DataArray type=\"Int64\" Name=\"" + array + " " +
                     std::to_string(number) + ": " + escaped(names[number]) +
                     "\" NumberOfTuples=\"1\" format=\"ascii\">" +
                     std::to_string(number) + "</DataArray>\n";
  }

  void VtkFile::write(const std::string &file) const
  {
    write_file(file, [&](std::ostream &out) {
      out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type_
          << "\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<"
          << type_ << " " << grid_attributes_ << ">\n";
      if (!field_data_.empty())
        out << "<FieldData>\n" << field_data_ << "</FieldData>\n";
      out << "<Piece " << piece_attributes_ << ">\n"
          << description_ << "</" << section_ << ">\n</Piece>\n</" << type_
          << ">\n<AppendedData encoding=\"raw\">\n_";
      for (const std::string &block : blocks_)
        out.write(block.data(), block.size());
      out << "\n</AppendedData>\n</VTKFile>\n";
    });
  }

#define CONTRECOUP_INSTANTIATE(Number)                            \
  template void VtkFile::add<Number>(const std::string &,         \
                                     const std::string &,         \
                                     const std::vector<Number> &, \
                                     unsigned int,                \
                                     const std::string &);
  CONTRECOUP_INSTANTIATE(double)
  CONTRECOUP_INSTANTIATE(float)
  CONTRECOUP_INSTANTIATE(std::uint32_t)
  CONTRECOUP_INSTANTIATE(std::int64_t)
  CONTRECOUP_INSTANTIATE(unsigned char)
#undef CONTRECOUP_INSTANTIATE
} // namespace io
} // namespace contrecoup
