// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/application/check_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/output/summary.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace contrecoup
{
namespace io
{
  namespace
  {
    const std::vector<std::pair<const char *, double CostEstimate::*>> figures =
      {{"cells", &CostEstimate::cells},
       {"unknowns", &CostEstimate::unknowns},
       {"steps", &CostEstimate::steps},
       {"memory_bytes", &CostEstimate::memory},
       {"wall_seconds", &CostEstimate::seconds},
       {"output_bytes", &CostEstimate::output}};

    Json to_json(const CostEstimate &cost)
    {
      Json json;
      for (const auto &[name, figure] : figures)
        json[name] = cost.*figure > 0. && std::isfinite(cost.*figure)
                       ? Json(cost.*figure)
                       : Json(nullptr);
      return json;
    }

    bool contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }

    /// Adds the addresses of numbers below @p node; any in an empty object.
    void add_numbers(const Json &node,
                     const std::string &path,
                     std::vector<std::string> &outputs)
    {
      const std::string begin = path.empty() ? "" : path + ".";
      if (node.is_object() && node.empty())
        outputs.push_back(begin + "*");
      else if (node.is_object())
        for (const auto &item : node.items())
          add_numbers(item.value(), begin + item.key(), outputs);
      else if (node.is_number() || node.is_null())
        outputs.push_back(path);
    }
  } // namespace

  std::vector<std::string> summary_outputs(const std::vector<Assumption> &plan)
  {
    Json summary = Json::parse(to_text(Summary()));
    summary.erase("format");
    std::vector<std::string> outputs;
    add_numbers(summary, "", outputs);
    const auto any = std::find(outputs.begin(), outputs.end(), "assumptions.*");
    if (!plan.empty())
      outputs.erase(any);
    for (const Assumption &item : plan)
      outputs.push_back("assumptions." + item.name + ".*");
    return outputs;
  }

  const std::vector<std::string> &history_features()
  {
    static const std::vector<std::string> features{"first",
                                                   "last",
                                                   "largest",
                                                   "smallest",
                                                   "peak",
                                                   "lowest",
                                                   "impulse",
                                                   "arrival"};
    return features;
  }

  std::vector<std::string>
  history_outputs(const std::string &file,
                  const std::vector<std::string> &columns)
  {
    std::vector<std::string> outputs;
    for (const std::string &column : columns)
      for (const std::string &feature : history_features())
        outputs.push_back(join({file, feature, column}, ":"));
    return outputs;
  }

  std::vector<std::string> file_outputs(const FileNames &names,
                                        const std::vector<std::string> &tables)
  {
    std::vector<std::string> outputs = tables;
    for (const auto *list : {&names.results, &names.others})
      for (std::string name : *list)
        if (!contains(name, "/") && name != "summary.json" &&
            ((contains(name, ".csv") && tables.empty()) ||
             contains(name, ".json")))
        {
          // "#" stands for digits.
          std::replace(name.begin(), name.end(), '#', '*');
          outputs.push_back(name + ":*");
        }
    return outputs;
  }

  void write_check_file(const CheckReport &report)
  {
    const char *file = std::getenv("CONTRECOUP_CHECK_FILE");
    if (file == nullptr)
      return;
    Json json = {{"application", report.application},
                 {"format", formats::forecast.number}};
    json.update(to_json(report.cost));
    json["outputs"] = report.outputs;
    for (const auto &[name, cost] : report.stages)
    {
      Json stage = {{"name", name}};
      stage.update(to_json(cost));
      json["stages"].push_back(stage);
    }
    write_file(file, [&](std::ostream &out) {
      out << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
    });
  }

  CheckReport read_check_file(const std::string &file)
  {
    const Json json = read_json(file, formats::forecast);
    CheckReport report;
    try
    {
      report.application = json.at("application").get<std::string>();
      for (const auto &[name, figure] : figures)
        report.cost.*figure =
          json.at(name).is_null() ? 0. : json.at(name).get<double>();
      report.outputs = json.at("outputs").get<std::vector<std::string>>();
    }
    catch (const Json::exception &)
    {
      throw SystemError("cannot read the forecast \"" + file + "\"");
    }
    return report;
  }
} // namespace io
} // namespace contrecoup
