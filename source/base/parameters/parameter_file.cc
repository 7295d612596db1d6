// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/unicode.h>

#include <filesystem>
#include <sstream>

namespace contrecoup
{
namespace
{
  constexpr std::size_t most_bytes = std::size_t(1) << 24;

  std::string after_semicolon(const std::string &remark)
  {
    return remark.empty() ? "" : "; " + remark;
  }

  /// Reads a file and, recursively, the files that it includes.
  class FileReader
  {
  public:
    FileReader(std::vector<Assignment> &assignments)
      : assignments_(assignments)
    {}

    void read(const std::string &file);

  private:
    void interpret(const std::string &line, const std::string &where);
    void assign(const std::string &rest, const std::string &where);
    void include(const std::string &rest, const std::string &where);

    std::vector<Assignment> &assignments_;
    std::vector<std::string> sections_;
    std::vector<std::string> opened_at_;
    std::vector<std::string> files_;
  };

  void FileReader::read(const std::string &file)
  {
    std::istringstream input(read_text("the parameter file", file, most_bytes));
    const std::string included = files_.empty() ? "" : ", included";
    const std::size_t depth = sections_.size();
    files_.push_back(file);
    unsigned int number = 0;
    for (std::string line; std::getline(input, line);)
    {
      const std::string where =
        "\"" + file + "\", line " + std::to_string(++number) + included;
      line = trim(line.substr(0, line.find('#')));
      while (!line.empty() && line.back() == '\\')
      {
        std::string next;
        line.pop_back();
        ++number;
        if (!std::getline(input, next))
          break;
        line += trim(next.substr(0, next.find('#')));
      }
      const std::string damage = why_not_utf8(line);
      if (!damage.empty())
        throw InputError(where + ": " + damage);
      if (line == "end" && sections_.size() == depth)
        throw InputError(where + ": \"end\" without a subsection");
      interpret(line, where);
    }
    if (sections_.size() > depth)
      throw InputError(opened_at_.back() + ": subsection \"" +
                       sections_.back() + "\" has no \"end\"");
    files_.pop_back();
  }

  void FileReader::interpret(const std::string &line, const std::string &where)
  {
    if (line.empty())
      return;
    const std::size_t end = line.find_first_of(" \t");
    const std::string keyword = line.substr(0, end);
    const std::string rest =
      end == std::string::npos ? "" : trim(line.substr(end));
    if (keyword == "end" && rest.empty())
    {
      sections_.pop_back();
      opened_at_.pop_back();
    }
    else if (keyword == "subsection" && !rest.empty())
    {
      sections_.push_back(rest);
      opened_at_.push_back(where);
    }
    else if (keyword == "set")
      assign(rest, where);
    else if (keyword == "include" && !rest.empty())
      include(rest, where);
    else
      throw InputError(where + ": cannot understand " + quotation(line) +
                       "; a line is \"subsection NAME\", \"set ENTRY = "
                       "VALUE\", \"end\" or \"include FILE\"" +
                       after_semicolon(find_lookalike(line)));
  }

  void FileReader::assign(const std::string &rest, const std::string &where)
  {
    const std::size_t equals = rest.find('=');
    if (equals == std::string::npos || trim(rest.substr(0, equals)).empty())
      throw InputError(where + ": " + quotation("set " + rest) +
                       " is not of the form \"set ENTRY = VALUE\"" +
                       after_semicolon(find_lookalike(rest)));
    assignments_.push_back(
      {sections_,
       trim(rest.substr(0, equals)),
       trim(rest.substr(equals + 1)),
       where,
       std::filesystem::path(files_.back()).parent_path().string()});
  }

  void FileReader::include(const std::string &rest, const std::string &where)
  {
    constexpr std::size_t deepest = 16;
    if (files_.size() > deepest)
      throw InputError(where + ": files include each other without end");
    const std::filesystem::path here(files_.back());
    const std::string file = (here.parent_path() / rest).string();
    // A limit of depth would not stop files that include themselves twice.
    std::error_code error;
    for (const std::string &open : files_)
      if (std::filesystem::equivalent(open, file, error))
        throw InputError(where + ": files include each other without end");
    const std::string why = why_unreadable(file);
    if (!why.empty())
      throw InputError(where + ": cannot include " + quotation(file) + ": " +
                       why);
    read(file);
  }
} // namespace

std::vector<Assignment> read_assignments(const std::string &file)
{
  std::vector<Assignment> assignments;
  FileReader(assignments).read(file);
  return assignments;
}

Assignment parse_override(const std::string &text)
{
  const std::size_t equals = text.find('=');
  std::vector<std::string> path = split(text.substr(0, equals), '/');
  bool complete = (equals != std::string::npos && !path.empty());
  for (const std::string &part : path)
    complete = complete && !part.empty();
  if (!complete)
    throw InputError("--set " + quotation(text) +
                     " is not of the form \"Section/Entry=value\"");
  const std::string damage = why_not_utf8(text);
  if (!damage.empty())
    throw InputError("--set " + damage);
  if (text.find_first_of("#\n") != std::string::npos)
    throw InputError("--set " + quotation(text) +
                     " holds a \"#\" or a line end, which a parameter file "
                     "could not give back");
  Assignment assignment;
  assignment.entry = path.back();
  path.pop_back();
  assignment.sections = path;
  assignment.value = trim(text.substr(equals + 1));
  assignment.origin = "--set";
  return assignment;
}
} // namespace contrecoup
