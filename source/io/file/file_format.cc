// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/io/file/file_format.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    void require_number(const FileFormat &format,
                        const std::string &found,
                        const std::string &file)
    {
      if (std::atof(found.c_str()) > format.number)
        throw InputError("\"" + file + "\" has format " + found +
                         ", this program reads up to " +
                         std::to_string(format.number));
    }
  } // namespace


  std::string format_text(const FileFormat &format)
  {
    return std::string("contrecoup ") + format.name + " " +
           std::to_string(format.number);
  }


  void require_format(const FileFormat &format,
                      const std::string &found,
                      const std::string &file)
  {
    const std::string kind = std::string("contrecoup ") + format.name + " ";
    const std::string number =
      found.find(kind) == 0 ? found.substr(kind.size()) : "";
    if (number.find_first_not_of("0123456789") != std::string::npos ||
        number.empty())
      throw InputError("\"" + file + "\" has the format " + quotation(found) +
                       ", not \"" + format_text(format) + "\"");
    require_number(format, number, file);
  }


  nlohmann::ordered_json read_json(const std::string &file,
                                   const FileFormat &format)
  {
    std::ifstream input(file);
    if (!input)
      return {};
    const auto json = nlohmann::ordered_json::parse(input, nullptr, false);
    if (json.is_object() && json.contains("format") &&
        json["format"].is_number())
      require_number(format, json["format"].dump(), file);
    return json;
  }
} // namespace io
} // namespace contrecoup
