// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/history.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    constexpr std::size_t largest_block = 1 << 16;
    constexpr double longest_wait = 2.;

    std::string header_of(const std::vector<NamedValue> &row)
    {
      std::vector<std::string> columns;
      for (const NamedValue &value : row)
        columns.push_back(value.unit.empty()
                            ? value.name
                            : value.name + " [" + value.unit + "]");
      return join(columns, ",");
    }
  } // namespace

  HistoryFile::HistoryFile(const std::string &file)
    : file_(file)
  {}

  HistoryFile::~HistoryFile()
  {
    try
    {
      flush();
    }
    catch (const std::exception &)
    {
      // A destructor must not throw; the run has already reported its error.
    }
  }

  void HistoryFile::start()
  {
    remove_quietly(file_);
    header_.clear();
    pending_.clear();
    size_ = 0;
  }

  void HistoryFile::resume(const std::uint64_t n_bytes)
  {
    header_.clear();
    pending_.clear();
    size_ = n_bytes;
    if (n_bytes == 0)
    {
      remove_quietly(file_);
      return;
    }
    std::error_code error;
    if (std::filesystem::file_size(file_, error) < n_bytes || error)
      throw InputError("\"" + file_ +
                       "\" is missing or lacks rows that the checkpoint "
                       "knows of; cannot resume");
    std::filesystem::resize_file(file_, n_bytes, error);
    if (error)
      throw SystemError("cannot write \"" + file_ + "\": " + error.message());
    std::ifstream input(file_);
    std::getline(input, header_);
  }

  void HistoryFile::add_row(const std::vector<NamedValue> &row)
  {
    const std::string header = header_of(row);
    if (header_.empty())
    {
      header_ = header;
      pending_ += header + '\n';
    }
    else if (header != header_)
      throw InputError("\"" + file_ + "\" has the columns \"" + header_ +
                       "\" and cannot take \"" + header + "\"");
    std::vector<std::string> numbers;
    for (const NamedValue &value : row)
      numbers.push_back(exact(value.value));
    pending_ += join(numbers, ",") + '\n';

    const std::chrono::duration<double> waited =
      std::chrono::steady_clock::now() - last_flush_;
    if (pending_.size() > largest_block || waited.count() > longest_wait)
      flush();
  }

  void HistoryFile::flush()
  {
    last_flush_ = std::chrono::steady_clock::now();
    if (pending_.empty())
      return;
    errno = 0;
    std::ofstream output(file_, std::ios::binary | std::ios::app);
    output << pending_ << std::flush;
    const int reason = errno;
    const bool written = static_cast<bool>(output);
    output.close();
    if (!written || !output)
    {
      std::error_code ignored;
      std::filesystem::resize_file(file_, size_, ignored);
      pending_.clear();
      throw SystemError("cannot write \"" + file_ +
                        "\": " + std::strerror(reason));
    }
    size_ += pending_.size();
    pending_.clear();
  }

  std::uint64_t HistoryFile::size() const
  {
    return size_;
  }
} // namespace io
} // namespace contrecoup
