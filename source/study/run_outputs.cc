// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/application/check_file.h>
#include <contrecoup/io/output/history_reader.h>
#include <contrecoup/study/curve.h>
#include <contrecoup/study/factor.h>
#include <contrecoup/study/run_outputs.h>
#include <contrecoup/study/table.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace contrecoup::study
{
namespace
{
  namespace fs = std::filesystem;
  constexpr const char *summary_file = "summary.json";

  /// Administrative files, which hold no results.
  bool is_administrative(const std::string &name)
  {
    return name == "manifest.json" || name == "study.json" ||
           name.find(".stage.json") != std::string::npos;
  }

  bool ends_with(const std::string &text, const std::string &end)
  {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
  }

  double largest(const Curve &curve)
  {
    return *std::max_element(curve.values.begin(), curve.values.end());
  }

  double smallest(const Curve &curve)
  {
    return *std::min_element(curve.values.begin(), curve.values.end());
  }

  /// Features of a curve by name; NaN where the curve has gaps.
  std::vector<std::pair<std::string, double>> features(const Curve &curve)
  {
    std::vector<std::pair<std::string, double>> values = {
      {"first", curve.values.front()}, {"last", curve.values.back()}};
    const bool is_whole =
      std::all_of(curve.values.begin(), curve.values.end(), [](double value) {
        return std::isfinite(value);
      });
    // In the order of io::history_features().
    for (double (*feature)(const Curve &) :
         {largest, smallest, peak, lowest, impulse, arrival})
      values.emplace_back(io::history_features()[values.size()],
                          is_whole ? feature(curve)
                                   : std::numeric_limits<double>::quiet_NaN());
    return values;
  }

  /// Unit of a feature of a column.
  std::string feature_unit(const std::string &feature, const std::string &unit)
  {
    return feature == "arrival"   ? "s"
           : feature != "impulse" ? unit
                                  : trim((unit == "-" ? "" : unit) + " s");
  }

  /// Gives numbers the units that "units" of the same file has by their names.
  void give_units(const nlohmann::json &units, nlohmann::json &node)
  {
    for (auto item = node.begin(); item != node.end(); ++item)
      if (item->is_object())
        give_units(units, *item);
      else if (units.contains(item.key()) &&
               (item->is_number() || item->is_null()))
        *item = {{"value", *item}, {"unit", units[item.key()]}};
  }

  std::string unit_in(const nlohmann::json &object)
  {
    return object.is_object() && object.contains("unit") &&
               object["unit"].is_string()
             ? object["unit"].get<std::string>()
             : "";
  }
} // namespace

OutputAddress parse_address(const std::string &text, const std::string &where)
{
  OutputAddress address;
  const std::size_t colon = text.find(':');
  const std::string file = text.substr(0, colon);
  const std::size_t slash = file.rfind('/');
  if (slash != std::string::npos)
    address.folder = file.substr(0, slash);
  const std::string rest =
    slash == std::string::npos ? text : text.substr(slash + 1);
  if (colon == std::string::npos)
  {
    address.file = summary_file;
    address.place = rest;
  }
  else
  {
    address.file = rest.substr(0, rest.find(':'));
    address.place = rest.substr(rest.find(':') + 1);
  }
  const std::string ending = fs::path(address.file).extension().string();
  const bool is_table = ending == ".csv";
  if (address.place.empty() || (!is_table && ending != ".json") ||
      (is_table && address.place.find(':') == std::string::npos))
    throw InputError(
      where + ": \"" + text +
      "\" is no output of a run; possible are a path in summary.json as "
      "results.NAME, STAGE/results.NAME of a scene, FILE.json:PATH and "
      "FILE.csv:ROW:COLUMN");
  return address;
}

RunOutputs::RunOutputs(const std::string &folder)
{
  add_files(folder, "");
  std::vector<std::string> stages;
  std::error_code ignored;
  for (const auto &entry : fs::directory_iterator(folder, ignored))
    if (fs::exists(entry.path() / summary_file, ignored))
      stages.push_back(entry.path().filename().string());
  std::sort(stages.begin(), stages.end());
  for (const std::string &stage : stages)
    add_files(folder, stage + "/");
  mark_lower_limits();
}

void RunOutputs::mark_lower_limits()
{
  const auto mark = [&](const std::string &address) {
    if (const auto found = values_.find(address); found != values_.end())
      found->second.is_lower_limit = true;
  };
  const std::string contact = "contact_";
  for (const auto &[address, output] : values_)
    for (const std::string flag : {"cut_off", "cut off"})
      if (output.value == 1. && ends_with(address, flag))
      {
        const std::string begin =
          address.substr(0, address.size() - flag.size());
        // The last is the whole name of a measure, without "_".
        for (const std::string &limit : {begin + "impulse",
                                         begin + "duration",
                                         begin + "positive_phase",
                                         begin + "positive phase",
                                         begin + "value",
                                         begin.substr(0, begin.size() - 1)})
          mark(limit);
        // The force of a contact that lasts may still grow.
        if (ends_with(begin, contact))
          for (const char *const name : {"force", "force_of_step", "area"})
            mark(begin.substr(0, begin.size() - contact.size()) + "peak_" +
                 contact + name);
      }
}

void RunOutputs::add_files(const std::string &folder,
                           const std::string &subfolder)
{
  std::vector<std::string> files;
  std::error_code ignored;
  for (const auto &entry :
       fs::directory_iterator(folder + "/" + subfolder, ignored))
    if (entry.is_regular_file(ignored))
      files.push_back(entry.path().filename().string());
  std::sort(files.begin(), files.end());
  for (const std::string &file : files)
  {
    const std::string name = subfolder + file;
    const std::string path = folder + "/" + name;
    if (ends_with(file, ".json") && !is_administrative(file))
    {
      std::ifstream input(path);
      nlohmann::json content = nlohmann::json::parse(input, nullptr, false);
      if (content.is_object())
      {
        content.erase("format");
        const nlohmann::json units = content.value("units", nlohmann::json());
        if (units.is_object())
          give_units(units, content);
      }
      add_object(
        content, file == summary_file ? subfolder : name + ":", "", "");
    }
    else if (ends_with(file, ".csv"))
      try
      {
        add_table(path, name + ":");
      }
      catch (const InputError &)
      {
        // A damaged table has no outputs.
      }
  }
}

void RunOutputs::add(const std::string &address,
                     const double value,
                     const std::string &unit)
{
  // The first of rows with the same name counts.
  if (values_.emplace(address, RunOutput{value, unit == "-" ? "" : unit, false})
        .second)
    names_.push_back(address);
}

void RunOutputs::add_object(const nlohmann::json &node,
                            const std::string &begin,
                            const std::string &path,
                            const std::string &unit)
{
  if (node.is_object() && node.contains("value") && node.contains("unit"))
    add_object(node["value"], begin, path, unit_in(node));
  else if (node.is_object())
    for (const auto &item : node.items())
      add_object(item.value(),
                 begin,
                 path + (path.empty() ? "" : ".") + item.key(),
                 unit_in(node));
  else if (!path.empty() && (node.is_number() || node.is_null()))
    add(begin + path,
        node.is_number() ? node.get<double>()
                         : std::numeric_limits<double>::quiet_NaN(),
        unit);
}

void RunOutputs::add_table(const std::string &file, const std::string &begin)
{
  const TableHead head = read_head(file);
  if (head.is_history())
  {
    const io::HistoryTable table = io::read_history(file);
    const std::vector<double> &times = table.column("time", file);
    for (std::size_t i = 0; i < table.names.size(); ++i)
      if (!times.empty() && table.names[i] != "time")
        for (const auto &[feature, value] : features({times, table.columns[i]}))
          add(begin + feature + ":" + head.names[i],
              value,
              feature_unit(feature, head.units[i]));
    return;
  }
  const Table table = read_table(file);
  const auto unit = std::find(table.names.begin(), table.names.end(), "unit");
  const std::size_t units =
    static_cast<std::size_t>(unit - table.names.begin());
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (std::size_t i = 0; i < table.names.size(); ++i)
    {
      const std::string &cell = table.rows[row][i];
      const double value = leading_number(cell);
      if (std::isfinite(value) || cell == "nan")
        add(begin + table.row_name(row) + ":" + table.names[i],
            value,
            table.units[i].empty() && units < table.names.size()
              ? table.rows[row][units]
              : table.units[i]);
    }
}

RunOutput RunOutputs::at(const std::string &address) const
{
  const auto found = values_.find(address);
  if (found == values_.end())
    throw InputError("the run has no output \"" + address + "\"" +
                     suggest_address(address, names_));
  return found->second;
}

std::string suggest_address(const std::string &address,
                            const std::vector<std::string> &known)
{
  std::vector<std::string> of_file;
  const std::size_t colon = address.find(':');
  if (colon != std::string::npos)
    for (const std::string &other : known)
      if (other.compare(0, colon + 1, address, 0, colon + 1) == 0)
        of_file.push_back(other);
  std::string best = nearest(address, of_file);
  if (best.empty())
    best = nearest(address, known);
  return best.empty() ? "" : "; did you mean \"" + best + "\"?";
}
} // namespace contrecoup::study
