// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/vtk_file.h>

#include <deal.II/base/utilities.h>

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

    void append_number(std::vector<unsigned char> &bytes,
                       const std::uint64_t number)
    {
      const auto *begin = reinterpret_cast<const unsigned char *>(&number);
      bytes.insert(bytes.end(), begin, begin + sizeof(number));
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

    /// Compresses data in blocks, as text: VTK's header (number of blocks,
    /// block size, size of a smaller last block, compressed sizes), then the
    /// blocks.
    std::string compressed_text(const unsigned char *data,
                                const std::size_t n_bytes)
    {
      constexpr std::size_t block_size = 1 << 20;
      constexpr int fastest = 1;
      std::vector<unsigned char> header, content;
      append_number(header, (n_bytes + block_size - 1) / block_size);
      append_number(header, block_size);
      append_number(header, n_bytes % block_size);
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
        content.insert(content.end(), buffer.data(), buffer.data() + size);
      }
      return dealii::Utilities::encode_base64(header) +
             dealii::Utilities::encode_base64(content);
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
        content_.push_back("</" + section_ + ">\n");
      content_.push_back("<" + section + ">\n");
      section_ = section;
    }
    content_.push_back("<DataArray " + attributes + " format=\"binary\">");
    content_.push_back(compressed_text(data, n_bytes));
    if (!unit.empty())
      content_.push_back("<InformationKey name=\"UNITS_LABEL\" "
                         "location=\"vtkDataArray\">" +
                         unit + "</InformationKey>");
    content_.push_back("</DataArray>\n");
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
      out << "<Piece " << piece_attributes_ << ">\n";
      for (const std::string &part : content_)
        out << part;
      out << "</" << section_ << ">\n</Piece>\n</" << type_
          << ">\n</VTKFile>\n";
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
