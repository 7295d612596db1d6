// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/mesh/abaqus_deck.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

namespace contrecoup
{
namespace
{
  std::string upper_case(std::string text)
  {
    std::transform(text.begin(), text.end(), text.begin(), [](const char one) {
      return static_cast<char>(std::toupper(static_cast<unsigned char>(one)));
    });
    return text;
  }

  /// A line "*ELEMENT, TYPE=C3D8, ELSET=skull": words in upper case, values as
  /// given.
  struct Keyword
  {
    explicit Keyword(const std::string &line)
    {
      const std::vector<std::string> words = split(line, ',');
      name = upper_case(one_line(words.front()));
      for (std::size_t i = 1; i < words.size(); ++i)
      {
        const std::size_t sign = std::min(words[i].find('='), words[i].size());
        options[upper_case(trim(words[i].substr(0, sign)))] =
          sign < words[i].size() ? trim(words[i].substr(sign + 1)) : "";
      }
    }

    std::string option(const std::string &key) const
    {
      const auto found = options.find(key);
      return found == options.end() ? "" : found->second;
    }

    std::string name;
    std::map<std::string, std::string> options;
  };


  class DeckReader
  {
  public:
    DeckReader(const unsigned int dimension, const std::string &where)
      : dimension_(dimension)
      , where_(where)
    {}

    AbaqusDeck read(std::istream &stream);

  private:
    struct Element
    {
      long number;
      std::string group;
      std::vector<long> nodes;
    };

    [[noreturn]] void refuse(const std::string &why) const
    {
      throw InputError(where_ + "line " + std::to_string(line_) + ": " + why);
    }

    long whole_number(const std::string &word) const;
    bool is_wanted(const std::string &type) const;
    void begin(const Keyword &keyword);
    void read_data(const Keyword &keyword,
                   const std::vector<std::string> &words);
    void add_node(const std::vector<std::string> &words);
    void add_to_element(const Keyword &keyword,
                        const std::vector<std::string> &words);
    void add_to_set(const Keyword &keyword,
                    const std::vector<std::string> &words);
    void group_by_section();
    AbaqusDeck deck() const;

    unsigned int dimension_;
    std::string where_;
    std::size_t line_ = 0;
    bool skips_elements_ = false;
    std::map<long, std::vector<std::string>> nodes_; ///< coordinates as given
    std::vector<Element> elements_;
    std::map<std::string, std::vector<long>> sets_;
    std::vector<std::string> sections_; ///< their sets
  };


  long DeckReader::whole_number(const std::string &word) const
  {
    char *end = nullptr;
    const long number = std::strtol(word.c_str(), &end, 10);
    if (word.empty() || *end != '\0' || number < 0)
      refuse(quotation(word) + " is no number of a node or an element");
    return number;
  }


  /// Whether elements of this type are read; others are left out.
  bool DeckReader::is_wanted(const std::string &type) const
  {
    // Letters after the number of nodes say how the element is integrated.
    const bool is_solid = type.rfind("C3D", 0) == 0;
    const std::size_t first = is_solid ? 3 : type.find_first_of("0123456789");
    if (first == std::string::npos)
      return false;
    const int n_nodes = std::atoi(type.c_str() + first);
    if (dimension_ == 3)
    {
      if (is_solid && n_nodes != 8)
        refuse("elements of the type " + type +
               (n_nodes == 20 || n_nodes == 27
                  ? " are of second order; 8-node bricks (C3D8, C3D8R) are read"
                  : " are no hexahedra; 8-node bricks (C3D8, C3D8R) are read"));
      return is_solid;
    }
    return !is_solid && n_nodes == 4;
  }


  void DeckReader::begin(const Keyword &keyword)
  {
    if (keyword.name == "*ELEMENT")
      skips_elements_ = !is_wanted(upper_case(keyword.option("TYPE")));
    else if (keyword.name == "*SOLID SECTION" &&
             !keyword.option("ELSET").empty())
      sections_.push_back(keyword.option("ELSET"));
    else if (keyword.name == "*INCLUDE")
      refuse("the file includes another one; write all into one file");
  }


  void DeckReader::add_node(const std::vector<std::string> &words)
  {
    if (words.size() < 1 + dimension_)
      refuse("a node has fewer than " + std::to_string(dimension_) +
             " coordinates");
    std::vector<std::string> coordinates(words.begin() + 1,
                                         words.begin() + 1 + dimension_);
    for (const std::string &word : coordinates)
    {
      char *end = nullptr;
      std::strtod(word.c_str(), &end);
      if (word.empty() || *end != '\0')
        refuse(quotation(word) + " is no coordinate");
    }
    coordinates.resize(3, "0");
    const long number = whole_number(words[0]);
    if (!nodes_.emplace(number, coordinates).second)
      refuse("node " + std::to_string(number) +
             " is given twice; the file must hold one part");
  }


  void DeckReader::add_to_element(const Keyword &keyword,
                                  const std::vector<std::string> &words)
  {
    const std::size_t n_nodes = dimension_ == 3 ? 8 : 4;
    std::size_t next = 0;
    // Numbers may continue in the next line.
    if (elements_.empty() || elements_.back().nodes.size() == n_nodes)
      elements_.push_back(
        {whole_number(words[next++]), keyword.option("ELSET"), {}});
    for (; next < words.size() && !words[next].empty(); ++next)
      elements_.back().nodes.push_back(whole_number(words[next]));
    if (elements_.back().nodes.size() > n_nodes)
      refuse("element " + std::to_string(elements_.back().number) +
             " has more than " + std::to_string(n_nodes) + " nodes");
  }


  void DeckReader::add_to_set(const Keyword &keyword,
                              const std::vector<std::string> &words)
  {
    std::vector<long> &set = sets_[upper_case(keyword.option("ELSET"))];
    if (keyword.options.count("GENERATE") > 0)
    {
      const long first = whole_number(words[0]);
      const long last = words.size() > 1 ? whole_number(words[1]) : first;
      const long step = words.size() > 2 ? whole_number(words[2]) : 1;
      if (step < 1 || last - first > 10000000)
        refuse("no range of elements");
      for (long number = first; number <= last; number += step)
        set.push_back(number);
      return;
    }
    for (const std::string &word : words)
    {
      // A set may contain others.
      const auto other = sets_.find(upper_case(word));
      if (other != sets_.end() && &other->second != &set)
        set.insert(set.end(), other->second.begin(), other->second.end());
      else if (!word.empty())
        set.push_back(whole_number(word));
    }
  }


  void DeckReader::read_data(const Keyword &keyword,
                             const std::vector<std::string> &words)
  {
    if (keyword.name == "*NODE")
      add_node(words);
    else if (keyword.name == "*ELEMENT" && !skips_elements_)
      add_to_element(keyword, words);
    else if (keyword.name == "*ELSET")
      add_to_set(keyword, words);
    else if (keyword.name == "*INSTANCE")
      refuse("the file moves an instance of its part; write the nodes where "
             "they are");
  }


  /// Sets of sections take precedence over those of elements.
  void DeckReader::group_by_section()
  {
    std::map<long, std::string> group;
    for (const std::string &section : sections_)
    {
      const auto set = sets_.find(upper_case(section));
      if (set != sets_.end())
        for (const long number : set->second)
          group[number] = section;
    }
    for (Element &element : elements_)
      if (const auto found = group.find(element.number); found != group.end())
        element.group = found->second;
  }


  AbaqusDeck DeckReader::deck() const
  {
    AbaqusDeck result;
    std::map<std::string, unsigned int> numbers;
    std::ostringstream text;
    text << nodes_.size() << ' ' << elements_.size() << " 0 0 0\n";
    for (const auto &[number, place] : nodes_)
      text << number << ' ' << join(place, " ") << '\n';
    const std::size_t n_nodes = dimension_ == 3 ? 8 : 4;
    for (const Element &element : elements_)
    {
      if (element.nodes.size() != n_nodes)
        throw InputError(where_ + "element " + std::to_string(element.number) +
                         " has " + std::to_string(element.nodes.size()) +
                         " nodes");
      unsigned int group = 0;
      if (!element.group.empty())
      {
        const std::string key = upper_case(element.group);
        group = numbers.emplace(key, numbers.size() + 1).first->second;
        result.groups.emplace(group, element.group);
      }
      text << element.number << ' ' << group
           << (dimension_ == 3 ? " hex" : " quad");
      for (const long node : element.nodes)
      {
        if (nodes_.count(node) == 0)
          throw InputError(where_ + "element " +
                           std::to_string(element.number) + " has the node " +
                           std::to_string(node) + ", which is missing");
        text << ' ' << node;
      }
      text << '\n';
    }
    result.ucd = text.str();
    return result;
  }


  AbaqusDeck DeckReader::read(std::istream &stream)
  {
    Keyword keyword("*");
    for (std::string line; std::getline(stream, line);)
    {
      ++line_;
      line = trim(line);
      if (line.empty() || line.rfind("**", 0) == 0)
        continue;
      if (line[0] == '*')
      {
        keyword = Keyword(line);
        begin(keyword);
      }
      else
        read_data(keyword, split(line, ','));
    }
    if (elements_.empty())
      throw InputError(where_ + "it has no " +
                       (dimension_ == 3 ? "8-node bricks (C3D8, C3D8R)"
                                        : "quadrilaterals of four nodes"));
    group_by_section();
    return deck();
  }
} // namespace


bool is_abaqus_deck(std::istream &stream)
{
  std::string word;
  stream >> word;
  stream.clear();
  stream.seekg(0);
  return !word.empty() && word[0] == '*';
}


AbaqusDeck read_abaqus_deck(std::istream &stream,
                            const unsigned int dimension,
                            const std::string &where)
{
  return DeckReader(dimension, where).read(stream);
}
} // namespace contrecoup
