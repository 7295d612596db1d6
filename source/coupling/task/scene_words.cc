// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/task/scene_words.h>

#include <cctype>

namespace contrecoup::coupling
{
namespace
{
  /// The section of the body belongs to the scene in every task.
  bool is_shared(const std::string &path)
  {
    return path == "Body" || path.compare(0, 5, "Body/") == 0;
  }

  std::string path_of(const Assignment &assignment)
  {
    return join(assignment.sections, "/") + "/" + assignment.entry;
  }

  /// All sections that contain an entry.
  std::vector<std::string> outer_sections(const std::string &path)
  {
    std::vector<std::string> sections;
    for (std::size_t slash = path.find('/'); slash != std::string::npos;
         slash = path.find('/', slash + 1))
      sections.push_back(path.substr(0, slash));
    return sections;
  }

  /// Whether a character may be part of a name or of a file path.
  bool is_of_word(const char letter)
  {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           letter == '/' || letter == '_';
  }
} // namespace


SceneWords::SceneWords(const std::string &section,
                       const std::vector<Assignment> &entries,
                       const std::map<std::string, std::string> &sections,
                       const std::vector<Assignment> &wrote,
                       const dealii::ParameterHandler &stage)
{
  const auto add = [&](const std::string &path,
                       const std::string &name,
                       const std::map<std::string, std::string> &others) {
    rename(path, name.empty() ? section + "/" + path : name);
    const auto whole = others.find(path.substr(0, path.find('/')));
    for (const std::string &outer : outer_sections(path))
      sections_[outer] =
        whole != others.end() ? whole->second : section + "/" + outer;
  };
  for (const auto &value : parameter_values(stage))
    if (!is_shared(value.first))
      add(value.first, "", sections);
  for (const Assignment &entry : entries)
    add(path_of(entry), entry.origin, sections);
  for (const Assignment &assignment : wrote)
    if (assignment.sections.size() > 1 && assignment.sections[0] == section)
      add(path_of(assignment).substr(section.size() + 1), "", {});
}


void SceneWords::rename(const std::string &entry, const std::string &name)
{
  entries_[entry] = name;
}


const std::pair<const std::string, std::string> *
SceneWords::name_at(const std::string &text, const std::size_t place) const
{
  // A longer name sorts after its own prefix.
  auto found = entries_.upper_bound(text.substr(place, 200));
  while (found != entries_.begin())
  {
    --found;
    const std::string &name = found->first;
    const std::size_t end = place + name.size();
    if (text.compare(place, name.size(), name) == 0 &&
        (end == text.size() || !is_of_word(text[end])))
      return &*found;
    if (name[0] != text[place])
      break;
  }
  return nullptr;
}


SceneWords::Head SceneWords::head_of(const std::string &text) const
{
  constexpr std::size_t longest = 200;
  Head head;
  for (std::size_t end = text.find_first_of(" :"); end <= longest;
       end = text.find_first_of(" :", end + 1))
    read_head(text.substr(0, end), head);
  read_head(text.substr(0, longest), head);
  return head;
}


void SceneWords::read_head(const std::string &begin, Head &head) const
{
  if (const auto section = sections_.find(begin); section != sections_.end())
    head = {begin, section->second, begin.size()};
  else if (entries_.count(begin) != 0)
  {
    const std::string outer = begin.substr(0, begin.rfind('/'));
    const auto known = sections_.find(outer);
    head = {outer, known != sections_.end() ? known->second : "", 0};
  }
}


std::string SceneWords::operator()(const std::string &text) const
{
  const Head head = head_of(text);
  const std::string inner = head.section + "/";
  std::string result = head.length > 0 ? head.name : "";
  std::size_t place = head.length;
  while (place < text.size())
  {
    const bool begins = place == 0 || !is_of_word(text[place - 1]);
    const auto *name = begins ? name_at(text, place) : nullptr;
    std::size_t length = name != nullptr ? name->first.size() : 0;
    if (name == nullptr && begins && !head.section.empty())
    {
      // Name of an entry of the section that the message begins with.
      name = name_at(inner + text.substr(place, 200), 0);
      length = name != nullptr ? name->first.size() - inner.size() : 0;
      if (name != nullptr &&
          name->second == head.name + "/" + text.substr(place, length))
        name = nullptr;
    }
    if (name != nullptr)
    {
      result += name->second;
      place += length;
    }
    else
      result += text[place++];
  }
  return result;
}
} // namespace contrecoup::coupling
