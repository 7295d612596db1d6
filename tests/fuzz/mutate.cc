// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "fuzz.h"

#include <algorithm>
#include <cstring>
#include <random>

namespace contrecoup::fuzz
{
namespace
{
  /// Words that numbers in texts are replaced with.
  const std::vector<std::string> words{"nan",
                                       "inf",
                                       "-1",
                                       "0",
                                       "1e999",
                                       "-1e-320",
                                       "4294967295",
                                       "4294967296",
                                       "-9223372036854775808",
                                       "1e18",
                                       "2147483648",
                                       "x",
                                       "",
                                       "\"",
                                       "1e308"};

  /// Numbers that counts and offsets in binary files are replaced with.
  const std::vector<std::uint64_t> numbers{0,
                                           1,
                                           0x7f,
                                           0xff,
                                           0x7fff,
                                           0xffff,
                                           0x7fffffff,
                                           0x80000000,
                                           0xffffffff,
                                           0x100000000,
                                           0x7fffffffffffffff,
                                           0xffffffffffffffff,
                                           0x7ff8000000000000,
                                           0x7f800000};

  class Mutation
  {
  public:
    Mutation(const std::string &content, const std::uint64_t seed)
      : text_(content)
      , random_(seed)
    {}

    std::string make()
    {
      const std::size_t count = std::size_t(1) << below(4);
      for (std::size_t i = 0; i < count && !text_.empty(); ++i)
        change();
      return text_;
    }

  private:
    std::size_t below(const std::size_t end)
    {
      return end == 0 ? 0 : random_() % end;
    }

    void change()
    {
      switch (below(9))
      {
        case 0:
          text_[below(text_.size())] ^= static_cast<char>(1 << below(8));
          break;
        case 1:
          text_[below(text_.size())] = static_cast<char>(below(256));
          break;
        case 2:
          put_number();
          break;
        case 3:
          text_.erase(below(text_.size()), 1 + below(16));
          break;
        case 4:
          repeat();
          break;
        case 5:
          // Most files are cut off near their end.
          text_.resize(text_.size() - below(below(text_.size()) + 1));
          break;
        case 6:
          text_.insert(below(text_.size()), 1 + below(8), char(below(256)));
          break;
        default:
          put_word();
      }
    }

    void put_number()
    {
      const std::uint64_t number = numbers[below(numbers.size())];
      const std::size_t size = std::size_t(1) << below(4);
      const std::size_t place = below(text_.size());
      std::memcpy(&text_[place], &number, std::min(size, text_.size() - place));
    }

    void repeat()
    {
      const std::size_t begin = below(text_.size());
      const std::string part = text_.substr(begin, 1 + below(64));
      text_.insert(below(text_.size()), part);
    }

    /// Another word instead of one of those between white space and commas.
    void put_word()
    {
      const char *const between = " \t\n,=;:";
      const std::size_t begin =
        text_.find_first_not_of(between, below(text_.size()));
      if (begin == std::string::npos)
        return;
      const std::size_t end = text_.find_first_of(between, begin);
      const std::size_t length =
        (end == std::string::npos ? text_.size() : end) - begin;
      // In binary files this must not eat everything.
      text_.replace(
        begin, std::min<std::size_t>(length, 24), words[below(words.size())]);
    }

    std::string text_;
    std::mt19937_64 random_;
  };
} // namespace


std::string mutate(const std::string &content, const std::uint64_t number)
{
  return number == 0 ? content : Mutation(content, number).make();
}
} // namespace contrecoup::fuzz
