// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/profile_file.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/hdf5_input.h>

#include <deal.II/base/hdf5.h>

#include <filesystem>
#include <sstream>

namespace contrecoup::gas
{
namespace
{
  const std::string units = "m, s, kg/m^3, kg/(m^2 s), J/m^3, Pa";

  const std::vector<std::pair<std::string, Geometry>> geometries = {
    {"spherical", Geometry::spherical},
    {"cylindrical", Geometry::cylindrical},
    {"axisymmetric", Geometry::axisymmetric}};

  std::string geometry_name(const Geometry geometry)
  {
    for (const auto &[name, value] : geometries)
      if (value == geometry)
        return name;
    return "plane";
  }

  Geometry geometry_of(const std::string &name, const std::string &file)
  {
    for (const auto &[known, value] : geometries)
      if (known == name)
        return value;
    throw InputError(file + ": \"" + name +
                     "\" is no geometry of a profile; known are spherical, "
                     "cylindrical, axisymmetric");
  }

  /// Names of the components of a profile with @p n_directions.
  std::vector<std::string> component_names(const std::size_t n_directions)
  {
    std::vector<std::string> names = {"density"};
    for (std::size_t d = 0; d < n_directions; ++d)
      names.push_back("momentum_" + std::to_string(d));
    names.push_back("energy");
    names.push_back("products");
    return names;
  }

  bool is_table(const std::string &file)
  {
    return std::filesystem::path(file).extension() == ".csv";
  }


  /// Writes all data except texts.
  /// @return names of the maps
  std::string write_numbers(const std::string &file, const ProfileData &data)
  {
    using namespace dealii::HDF5;
    File out(file, File::FileAccessMode::create);
    out.set_attribute("time_s", data.time);
    out.set_attribute("afterburn_fraction", data.afterburn_fraction);
    out.set_attribute("afterburn_released", data.afterburn_released);
    out.set_attribute("ambient_density", data.ambient[0]);
    out.set_attribute("ambient_energy", data.ambient[1]);
    out.set_attribute("ambient_products", data.ambient[2]);
    out.set_attribute("ambient_pressure", data.ambient_pressure);
    for (std::size_t d = 0; d < data.edges.size(); ++d)
    {
      const std::string axis = std::to_string(d);
      out.set_attribute("domain_begin_" + axis, data.domain_begin[d]);
      out.set_attribute("domain_end_" + axis, data.domain_end[d]);
      out.write_dataset("edges_" + axis, data.edges[d]);
    }
    const auto names = component_names(data.edges.size());
    for (std::size_t c = 0; c < names.size(); ++c)
      out.write_dataset(names[c], data.values[c]);
    std::vector<std::string> maps;
    for (const auto &[name, values] : data.maps)
    {
      maps.push_back(name);
      out.write_dataset("map_" + name, values);
    }
    return join(maps, ",");
  }

  /// Writes text attributes of fixed length; deal.II only writes variable
  /// length.
  void
  write_texts(const std::string &file,
              const std::vector<std::pair<std::string, std::string>> &texts)
  {
    const io::Hdf5Handle out(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT),
                             H5Fclose);
    for (const auto &[name, text] : texts)
    {
      const io::Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
      H5Tset_size(type, text.size() + 1);
      const io::Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
      const io::Hdf5Handle attribute(
        H5Acreate2(out, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
      if (H5Awrite(attribute, type, text.c_str()) < 0)
        throw SystemError("the attribute \"" + name + "\" is refused");
    }
  }


  /// Whether @p file is HDF5 and claims to be a profile.
  bool is_profile(const std::string &file)
  {
    try
    {
      const io::Hdf5Input in(file);
      bool good = in.has_attribute("format") && in.has_attribute("maps");
      for (const char *name : {"edges_0", "density", "energy", "products"})
        good = good && in.has_dataset(name);
      return good;
    }
    catch (const InputError &)
    {
      return false;
    }
  }

  ProfileData read_hdf5(const std::string &file)
  {
    if (!is_profile(file))
      throw InputError(file + " is no profile: neither a table named .csv nor "
                              "HDF5 written by \"Output/Profile file\"");
    const io::Hdf5Input in(file);
    const auto number = [&](const std::string &name) {
      return in.number(name);
    };
    const auto text = [&](const std::string &name) { return in.text(name); };
    const auto cells = [&](const std::string &name) {
      return in.numbers(name);
    };
    io::require_format(io::formats::profile, text("format"), file);
    ProfileData data;
    data.version = text("version");
    data.material = text("material");
    data.geometry = geometry_of(text("geometry"), file);
    data.time = number("time_s");
    data.afterburn_fraction = number("afterburn_fraction");
    data.afterburn_released = number("afterburn_released");
    data.ambient = {{number("ambient_density"),
                     number("ambient_energy"),
                     number("ambient_products")}};
    data.ambient_pressure = number("ambient_pressure");
    const std::size_t n = data.geometry == Geometry::axisymmetric ? 2 : 1;
    for (std::size_t d = 0; d < n; ++d)
    {
      const std::string axis = std::to_string(d);
      data.domain_begin.push_back(number("domain_begin_" + axis));
      data.domain_end.push_back(number("domain_end_" + axis));
      data.edges.push_back(cells("edges_" + axis));
    }
    for (const std::string &name : component_names(n))
      data.values.push_back(cells(name));
    for (const std::string &name : split(text("maps"), ','))
      if (!trim(name).empty())
        data.maps[name] = cells("map_" + name);
    return data;
  }


  void write_table(std::ostream &out, const ProfileData &data)
  {
    const auto say = [&](const std::string &name, const std::string &value) {
      out << "# " << name << " = " << value << '\n';
    };
    say("format", io::format_text(io::formats::profile));
    say("units", units);
    say("version", data.version);
    say("material", data.material);
    say("geometry", geometry_name(data.geometry));
    say("time_s", exact(data.time));
    say("afterburn_fraction", exact(data.afterburn_fraction));
    say("afterburn_released", exact(data.afterburn_released));
    say("ambient_density", exact(data.ambient[0]));
    say("ambient_energy", exact(data.ambient[1]));
    say("ambient_products", exact(data.ambient[2]));
    say("ambient_pressure", exact(data.ambient_pressure));
    std::vector<std::string> names;
    for (std::size_t d = 0; d < data.edges.size(); ++d)
    {
      const std::string axis = std::to_string(d);
      say("domain_begin_" + axis, exact(data.domain_begin[d]));
      say("domain_end_" + axis, exact(data.domain_end[d]));
      names.push_back("begin_" + axis);
      names.push_back("end_" + axis);
    }
    for (const std::string &name : component_names(data.edges.size()))
      names.push_back(name);
    for (const auto &item : data.maps)
      names.push_back("map_" + item.first);
    out << join(names, ",") << '\n';

    const std::size_t n0 = data.edges[0].size() - 1;
    for (std::size_t cell = 0; cell < data.values[0].size(); ++cell)
    {
      std::vector<std::string> row;
      for (std::size_t d = 0; d < data.edges.size(); ++d)
        for (const std::size_t end : {0, 1})
          row.push_back(
            exact(data.edges[d][(d == 0 ? cell % n0 : cell / n0) + end]));
      for (const auto &values : data.values)
        row.push_back(exact(values[cell]));
      for (const auto &item : data.maps)
        row.push_back(exact(item.second[cell]));
      out << join(row, ",") << '\n';
    }
  }


  /// Content of a table: lines "# name = value", column names, values.
  struct Table
  {
    std::map<std::string, std::string> notes;
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;
  };

  double number_in(const std::string &word, const std::string &where)
  {
    std::size_t used = 0;
    double number = 0.;
    try
    {
      number = std::stod(word, &used);
    }
    catch (const std::exception &)
    {
      used = std::string::npos;
    }
    if (used != word.size())
      throw InputError(where + ": \"" + word + "\" is no number");
    return number;
  }

  Table read_lines(const std::string &file)
  {
    Table table;
    std::istringstream stream(read_text("the profile", file));
    std::string line;
    for (unsigned int number = 1; std::getline(stream, line); ++number)
    {
      const std::string where = file + ", line " + std::to_string(number);
      line = trim(line);
      const auto equals = line.find('=');
      if (!line.empty() && line[0] == '#' && equals != std::string::npos)
        table.notes[trim(line.substr(1, equals - 1))] =
          trim(line.substr(equals + 1));
      if (line.empty() || line[0] == '#')
        continue;
      const auto words = split(line, ',');
      if (table.names.empty())
      {
        for (const std::string &word : words)
          table.names.push_back(trim(word));
        continue;
      }
      if (words.size() != table.names.size())
        throw InputError(where + ": needs " +
                         std::to_string(table.names.size()) + " numbers");
      std::vector<double> row;
      for (const std::string &word : words)
        row.push_back(number_in(word, where));
      table.rows.push_back(row);
    }
    return table;
  }

  std::vector<double>
  column(const Table &table, const std::string &name, const std::string &file)
  {
    const auto found = std::find(table.names.begin(), table.names.end(), name);
    if (found == table.names.end())
      throw InputError(file + ": has no column \"" + name + "\"");
    std::vector<double> result;
    for (const auto &row : table.rows)
      result.push_back(row[found - table.names.begin()]);
    return result;
  }

  /// Cell edges along a direction, from the lower and upper bounds of all
  /// cells.
  std::vector<double>
  edges_of(const Table &table, const std::string &axis, const std::string &file)
  {
    std::vector<double> edges = column(table, "begin_" + axis, file);
    const auto ends = column(table, "end_" + axis, file);
    edges.insert(edges.end(), ends.begin(), ends.end());
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  ProfileData read_table(const std::string &file)
  {
    const Table table = read_lines(file);
    const auto note = [&](const std::string &name) {
      const auto found = table.notes.find(name);
      if (found == table.notes.end())
        throw InputError(file + ": has no line \"# " + name + " = ...\"");
      return found->second;
    };
    const auto number = [&](const std::string &name) {
      return number_in(note(name), file + ", " + name);
    };
    const auto number_or = [&](const std::string &name, const double other) {
      return table.notes.count(name) > 0 ? number(name) : other;
    };
    if (table.notes.count("format") > 0)
      io::require_format(io::formats::profile, note("format"), file);
    ProfileData data;
    data.geometry = geometry_of(note("geometry"), file);
    data.time = number("time_s");
    data.ambient = {{number("ambient_density"),
                     number("ambient_energy"),
                     number_or("ambient_products", 0.)}};
    data.ambient_pressure = number("ambient_pressure");
    data.afterburn_fraction = number_or("afterburn_fraction", 0.);
    data.afterburn_released = number_or("afterburn_released", 0.);
    const auto take_note = [&](const std::string &name, std::string &text) {
      if (table.notes.count(name) > 0)
        text = table.notes.at(name);
    };
    take_note("version", data.version);
    take_note("material", data.material);
    const std::size_t n = data.geometry == Geometry::axisymmetric ? 2 : 1;
    for (std::size_t d = 0; d < n; ++d)
    {
      const std::string axis = std::to_string(d);
      data.edges.push_back(edges_of(table, axis, file));
      const auto &edges = data.edges.back();
      data.domain_begin.push_back(
        number_or("domain_begin_" + axis, edges.empty() ? 0. : edges.front()));
      data.domain_end.push_back(
        number_or("domain_end_" + axis, std::numeric_limits<double>::max()));
    }
    for (const std::string &name : component_names(n))
      data.values.push_back(column(table, name, file));
    for (const std::string &name : table.names)
      if (name.rfind("map_", 0) == 0)
        data.maps[name.substr(4)] = column(table, name, file);
    return data;
  }
} // namespace


void write_profile(const std::string &file, const ProfileData &data)
{
  if (is_table(file))
  {
    io::write_file(file, [&](std::ostream &out) { write_table(out, data); });
    return;
  }
  try
  {
    const std::string maps = write_numbers(file, data);
    write_texts(file,
                {{"format", io::format_text(io::formats::profile)},
                 {"units", units},
                 {"version", data.version},
                 {"material", data.material},
                 {"geometry", geometry_name(data.geometry)},
                 {"maps", maps}});
  }
  catch (const std::exception &error)
  {
    io::remove_quietly(file);
    throw SystemError(file + " cannot be written: " + error.what());
  }
  if (!is_profile(file))
    throw SystemError(file + " cannot be written");
}


ProfileData read_profile(const std::string &file)
{
  require_readable("the profile", file);
  return is_table(file) ? read_table(file) : read_hdf5(file);
}
} // namespace contrecoup::gas
