// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/allowed_values.h>
#include <contrecoup/base/parameters/declared_tree.h>
#include <contrecoup/base/parameters/number_or_word.h>
#include <contrecoup/base/system/text.h>

namespace contrecoup
{
namespace
{
  using declared::between;

  std::string in_words(const std::string &kind,
                       const std::pair<std::string, std::string> &range)
  {
    const auto &[lower, upper] = range;
    if (lower.empty() && upper.empty())
      return kind;
    if (upper.empty())
      return kind + " of at least " + lower;
    if (lower.empty())
      return kind + " of at most " + upper;
    return kind + " from " + lower + " to " + upper;
  }

  /// The description of a number within that of lists.
  std::string item_of(const std::string &pattern)
  {
    if (pattern.find("[List of <") != 0)
      return pattern;
    return item_of(between(pattern, "[List of <", "> of length"));
  }
} // namespace

std::string plain_words(const std::string &pattern)
{
  if (const auto either = NumberOrWord::create(pattern))
    return in_words("a number", range_of(pattern)) + ", or \"" +
           either->word() + "\"";
  if (pattern.find("[Double ") == 0)
    return in_words("a number", range_of(pattern));
  if (pattern.find("[Integer range ") == 0)
    return in_words("a whole number", range_of(pattern));
  if (pattern == "[Integer]")
    return "a whole number";
  if (pattern.find("[FileName ") == 0)
    return "the name of a file";
  if (pattern.find("[List of <[List of <") == 0)
    return "points of one to three numbers from -1e6 to 1e6, as in \"0,0,1; "
           "0,0,2\"";
  if (pattern.find("[List of <") == 0)
  {
    const std::string count = between(pattern, "> of length ", " (inclusive)");
    const std::size_t dots = count.find("...");
    const std::string most = count.substr(dots + 3);
    const std::string least = count.substr(0, dots);
    return least +
           (most == "4294967295" ? " or more"
            : most == least      ? ""
                                 : " to " + most) +
           " values separated by commas, each " +
           plain_words(between(pattern, "[List of <", "> of length"));
  }
  return join(choices_of(pattern), ", ");
}


std::pair<std::string, std::string> range_of(const std::string &pattern)
{
  const std::string item = item_of(pattern);
  const std::string kind =
    item.find("[Double ") == 0 ? "[Double " : "[Integer range ";
  if (item.find(kind) != 0)
    return {};
  const std::string range = between(item, kind, " (incl");
  const std::size_t dots = range.find("...");
  std::string lower = range.substr(0, dots), upper = range.substr(dots + 3);
  if (lower == "-MAX_DOUBLE" || lower == "-2147483648")
    lower.clear();
  if (upper == "MAX_DOUBLE" || upper == "2147483647")
    upper.clear();
  return {lower, upper};
}


bool is_of_numbers(const std::string &pattern)
{
  const std::string item = item_of(pattern);
  return item.find("[Double") == 0 || item.find("[Integer") == 0;
}


std::vector<std::string> choices_of(const std::string &pattern)
{
  const std::string item = item_of(pattern);
  if (item == "[Bool]")
    return {"true", "false"};
  if (item.find("[Selection ") == 0)
    return split(between(item, "[Selection ", "]"), '|');
  if (const auto either = NumberOrWord::create(item))
    return {either->word()};
  return {};
}


std::string unit_in(const std::string &documentation)
{
  const std::size_t begin = documentation.find('[');
  const std::size_t end = documentation.find_first_of(",]", begin);
  if (end == std::string::npos)
    return "";
  return documentation.substr(begin + 1, end - begin - 1);
}
} // namespace contrecoup
