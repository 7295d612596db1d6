// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/version.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/run/cost_cache.h>

#include <link.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

namespace contrecoup
{
namespace io
{
  namespace
  {
    namespace fs = std::filesystem;
    /// Name of the processor; empty if unknown.
    std::string processor()
    {
      std::ifstream file("/proc/cpuinfo");
      for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0)
          return line;
      return "";
    }

    /// Version, and modification time of the newest of program and libraries.
    std::string build()
    {
      fs::file_time_type newest = fs::file_time_type::min();
      dl_iterate_phdr(
        [](dl_phdr_info *const loaded, std::size_t, void *const time) {
          const std::string name = loaded->dlpi_name;
          std::error_code error;
          const auto made =
            fs::last_write_time(name.empty() ? "/proc/self/exe" : name, error);
          auto &latest = *static_cast<fs::file_time_type *>(time);
          if (!error)
            latest = std::max(latest, made);
          return 0;
        },
        &newest);
      return version() + " " + git_revision() + " " +
             std::to_string(newest.time_since_epoch().count());
    }

    std::string folder()
    {
      if (const char *cache = std::getenv("XDG_CACHE_HOME"))
        if (*cache != '\0')
          return std::string(cache) + "/contrecoup";
      if (const char *home = std::getenv("HOME"))
        if (*home != '\0')
          return std::string(home) + "/.cache/contrecoup";
      return "";
    }
  } // namespace

  CostCache::CostCache(const std::string &scene)
    : key_(processor() + "\n" + build() + "\n" + scene)
  {
    if (!folder().empty())
      file_ = folder() + "/cost_" +
              std::to_string(std::hash<std::string>()(key_)) + ".json";
  }

  std::optional<TriedCost> CostCache::read() const
  {
    // The overload without error code throws for unreadable folders.
    std::error_code ignored;
    if (file_.empty() || !fs::exists(file_, ignored))
      return std::nullopt;
    try
    {
      const Json json = Json::parse(read_file(file_));
      if (json.at("key") != key_)
        return std::nullopt;
      TriedCost cost;
      json.at("cells").get_to(cost.cells);
      json.at("unknowns").get_to(cost.unknowns);
      json.at("steps").get_to(cost.steps);
      json.at("memory").get_to(cost.memory);
      json.at("seconds").get_to(cost.seconds);
      json.at("output").get_to(cost.output);
      json.at("is_exact").get_to(cost.is_exact);
      json.at("step_growth").get_to(cost.step_growth);
      return cost;
    }
    catch (const std::exception &)
    {
      return std::nullopt;
    }
  }

  void CostCache::write(const TriedCost &cost) const noexcept
  {
    try
    {
      if (file_.empty())
        return;
      fs::create_directories(fs::path(file_).parent_path());
      const Json json = {{"key", key_},
                         {"cells", cost.cells},
                         {"unknowns", cost.unknowns},
                         {"steps", cost.steps},
                         {"memory", cost.memory},
                         {"seconds", cost.seconds},
                         {"output", cost.output},
                         {"is_exact", cost.is_exact},
                         {"step_growth", cost.step_growth}};
      write_file(file_,
                 [&](std::ostream &out) { out << json.dump(1) << '\n'; });
    }
    catch (const std::exception &)
    {
      // Without a cache, the cost is measured again next time.
    }
  }
} // namespace io
} // namespace contrecoup
