// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/vtk_collection.h>

namespace contrecoup
{
namespace io
{
  void write_collection(const std::string &file,
                        const std::vector<CollectionEntry> &entries)
  {
    constexpr int digits = 12;
    write_file(file, [&](std::ostream &out) {
      out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" "
             "version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
      unsigned int part = 0;
      for (std::size_t i = 0; i < entries.size(); ++i)
      {
        const CollectionEntry &entry = entries[i];
        part = i > 0 && entries[i - 1].time == entry.time ? part + 1 : 0;
        out << "<DataSet timestep=\"" << brief(entry.time, digits)
            << "\" group=\"\" part=\"" << part << "\"";
        if (!entry.part.empty())
          out << " name=\"" << entry.part << "\"";
        out << " file=\"" << entry.file << "\"/>\n";
      }
      out << "</Collection>\n</VTKFile>\n";
    });
  }
} // namespace io
} // namespace contrecoup
