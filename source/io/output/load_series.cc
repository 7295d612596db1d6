// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/hdf5_input.h>
#include <contrecoup/io/output/load_series.h>

#include <filesystem>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// An array of the load file.
    std::string array(const std::string &file,
                      const std::string &name,
                      const std::string &size,
                      const std::string &type)
    {
      return "<DataItem Dimensions=\"" + size + "\" " + type +
             " Format=\"HDF\">" + file + ":/" + name + "</DataItem>";
    }

    const char *const single_precision = "NumberType=\"Float\" Precision=\"4\"";
    const char *const double_precision = "NumberType=\"Float\" Precision=\"8\"";
    const char *const integer = "NumberType=\"Int\" Precision=\"4\"";

    std::string attribute(const std::string &name, const std::string &content)
    {
      return "<Attribute Name=\"" + name +
             "\" AttributeType=\"Scalar\" Center=\"Cell\">" + content +
             "</Attribute>\n";
    }
  } // namespace


  void write_load_series(const std::string &load_file)
  {
    const Hdf5Input input(load_file);
    if (!input.has_dataset("connectivity"))
      return;
    const std::vector<double> times = input.numbers("time");
    const std::string n_facets = std::to_string(input.numbers("area").size());
    const std::string n_times = std::to_string(times.size());
    const std::string n_vertices =
      std::to_string(input.numbers("vertex").size() / 3);
    const std::string n_numbers =
      std::to_string(input.numbers("connectivity").size());

    const std::filesystem::path path(load_file);
    const std::string file = path.filename().string();
    const std::string facets =
      "<Topology TopologyType=\"Mixed\" NumberOfElements=\"" + n_facets +
      "\">" + array(file, "connectivity", n_numbers, integer) +
      "</Topology>\n<Geometry GeometryType=\"XYZ\">" +
      array(file, "vertex", n_vertices + " 3", single_precision) +
      "</Geometry>\n";
    std::string measures;
    for (const char *const name : {"peak", "impulse", "arrival", "duration"})
      if (input.has_dataset(name))
        measures +=
          attribute(name, array(file, name, n_facets, double_precision));
    const std::string samples =
      array(file, "overpressure", n_facets + " " + n_times, single_precision);
    write_file(
      std::filesystem::path(path).replace_extension("xdmf").string(),
      [&](std::ostream &out) {
        out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
               "<Grid Name=\"loads\" GridType=\"Collection\" "
               "CollectionType=\"Temporal\">\n";
        for (std::size_t i = 0; i < times.size(); ++i)
          out << "<Grid Name=\"skin\">\n<Time Value=\"" << exact(times[i])
              << "\"/>\n"
              << facets
              << attribute(
                   "overpressure",
                   "<DataItem ItemType=\"HyperSlab\" Dimensions=\"" + n_facets +
                     " 1\"><DataItem Dimensions=\"3 2\" NumberType=\"Int\" "
                     "Format=\"XML\">0 " +
                     std::to_string(i) + " 1 1 " + n_facets + " 1</DataItem>" +
                     samples + "</DataItem>")
              << measures << "</Grid>\n";
        out << "</Grid>\n</Domain>\n</Xdmf>\n";
      });
  }
} // namespace io
} // namespace contrecoup
