// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/unicode.h>

#include <boost/locale/utf.hpp>

#include <cstdio>
#include <vector>

namespace contrecoup
{
namespace
{
  namespace utf = boost::locale::utf;
  using Utf8 = utf::utf_traits<char>;

  /// Letters from one code point to another that look like @p plain.
  struct Lookalikes
  {
    utf::code_point first, last;
    const char *name;
    const char *plain;
  };

  const std::vector<Lookalikes> &lookalikes()
  {
    const char *blank = "a space", *minus = "-", *none = "nothing";
    static const std::vector<Lookalikes> all = {
      {0xA0, 0xA0, "no-break space", blank},
      {0xAB, 0xAB, "quotation mark", none},
      {0xAD, 0xAD, "soft hyphen", minus},
      {0xBB, 0xBB, "quotation mark", none},
      {0x2000, 0x200A, "typographic space", blank},
      {0x200B, 0x200F, "invisible letter", none},
      {0x2010, 0x2015, "hyphen or dash", minus},
      {0x2018, 0x201F, "quotation mark", none},
      {0x2028, 0x202E, "invisible letter", none},
      {0x202F, 0x202F, "narrow no-break space", blank},
      {0x205F, 0x205F, "typographic space", blank},
      {0x2060, 0x2064, "invisible letter", none},
      {0x2212, 0x2212, "minus sign", minus},
      {0x3000, 0x3000, "ideographic space", blank},
      {0xFE63, 0xFE63, "small hyphen", minus},
      {0xFEFF, 0xFEFF, "byte order mark", none},
      {0xFF01, 0xFF5E, "full-width letter", "the ASCII one"}};
    return all;
  }

  /// "U+00A0 (no-break space) after "0.5"".
  std::string told(const utf::code_point code,
                   const std::string &name,
                   const std::string &before)
  {
    char number[16];
    std::snprintf(number, sizeof(number), "U+%04X", code);
    return number + (name.empty() ? "" : " (" + name + ")") +
           (before.empty() ? " at the beginning"
                           : " after " + quotation(before));
  }

  /// Description of the first letter beyond ASCII: of all, or of lookalikes.
  std::string find_letter(const std::string &text, const bool any)
  {
    for (auto here = text.begin(); here != text.end();)
    {
      const std::string before(text.begin(), here);
      const utf::code_point code = Utf8::decode(here, text.end());
      if (code < 128 || !utf::is_valid_codepoint(code))
        continue;
      for (const Lookalikes &those : lookalikes())
        if (code >= those.first && code <= those.last)
          return told(code, those.name, before) + ": write " + those.plain +
                 " instead";
      if (any)
        return told(code, "", before) + ": no number has it";
    }
    return "";
  }
} // namespace


std::string why_not_utf8(const std::string &text)
{
  for (auto here = text.begin(); here != text.end();)
  {
    const auto begin = here;
    if (utf::is_valid_codepoint(Utf8::decode(here, text.end())))
      continue;
    const std::string before(text.begin(), begin);
    char byte[8];
    std::snprintf(
      byte, sizeof(byte), "0x%02X", static_cast<unsigned char>(*begin));
    return std::string("not UTF-8: byte ") + byte +
           (before.empty() ? " at the beginning"
                           : " after " + quotation(before)) +
           "; save the file as UTF-8";
  }
  return "";
}


std::string find_lookalike(const std::string &text)
{
  return find_letter(text, false);
}


std::string find_foreign_letter(const std::string &text)
{
  return find_letter(text, true);
}
} // namespace contrecoup
