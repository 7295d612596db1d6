// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace contrecoup
{
namespace
{
  /// Whether a byte never occurs in UTF-8 text.
  bool is_binary(const char letter)
  {
    const auto byte = static_cast<unsigned char>(letter);
    return (byte < 32 && std::strchr("\t\n\v\f\r\033", letter) == nullptr) ||
           byte == 0 || byte == 127;
  }

  /// Reason why the content is not text; empty if it is.
  std::string why_no_text(const std::string &content)
  {
    if (begins_with(content, "\xFF\xFE") || begins_with(content, "\xFE\xFF"))
      return "it is encoded as UTF-16; UTF-8 is wanted";
    if (begins_with(content, "\x89HDF"))
      return "it is an HDF5 file";
    const auto found = std::find_if(content.begin(), content.end(), is_binary);
    if (found == content.end())
      return "";
    const auto value = static_cast<unsigned int>(*found);
    return "its byte " + std::to_string(found - content.begin() + 1) + " is " +
           std::to_string(value) + ", as in UTF-16 or a binary file";
  }

  /// Converts Windows and old Mac line ends to "\n".
  std::string with_line_ends(const std::string &content)
  {
    std::string text;
    text.reserve(content.size());
    for (std::size_t i = 0; i < content.size(); ++i)
      if (content[i] != '\r')
        text += content[i];
      else if (i + 1 == content.size() || content[i + 1] != '\n')
        text += '\n';
    return text;
  }
} // namespace


std::string why_unreadable(const std::string &file)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    return file.empty() ? "its name is empty" : "there is no such file";
  if (error)
    return error.message();
  if (std::filesystem::is_directory(status))
    return "it is a folder";
  return access(file.c_str(), R_OK) == 0 ? "" : std::strerror(errno);
}


void require_readable(const std::string &what, const std::string &file)
{
  const std::string why = why_unreadable(file);
  if (!why.empty())
    throw InputError("cannot read " + what + " " + quotation(file) + ": " +
                     why);
}


std::string read_text(const std::string &what,
                      const std::string &file,
                      const std::size_t most_bytes)
{
  require_readable(what, file);
  const std::string problem =
    "cannot read " + what + " " + quotation(file) + ": ";
  std::ifstream input(file, std::ios::binary);
  std::string content, why;
  // A pipe has no known size, and a device may have no end.
  std::vector<char> block(1U << 16);
  while (why.empty() && content.size() <= most_bytes && input)
  {
    input.read(block.data(), static_cast<std::streamsize>(block.size()));
    content.append(block.data(), static_cast<std::size_t>(input.gcount()));
    if (content.size() <= block.size())
      why = why_no_text(content);
  }
  if (input.bad())
    throw InputError(problem + "reading stops with \"" + std::strerror(errno) +
                     "\"");
  if (why.empty() && content.size() > most_bytes)
    throw InputError(problem + "it has more than " + bytes(double(most_bytes)));
  if (why.empty())
    why = why_no_text(content);
  if (!why.empty())
    throw InputError(problem + "it is not a text file: " + why);
  if (begins_with(content, "\xEF\xBB\xBF"))
    content.erase(0, 3);
  return with_line_ends(content);
}


std::string quotation(const std::string &text)
{
  constexpr std::size_t most = 60;
  std::size_t end = std::min(text.size(), most);
  // Do not split a UTF-8 character: continuation bytes are 10xxxxxx.
  while (end < text.size() && end > 0 &&
         (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    --end;
  std::string shown = text.substr(0, end);
  for (char &letter : shown)
    if (static_cast<unsigned char>(letter) < 32 || letter == 127)
      letter = '?';
  return "\"" + shown + (end < text.size() ? "..." : "") + "\"";
}
} // namespace contrecoup
