// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/body_layer.h>
#include <contrecoup/geometry/body/image_body.h>
#include <contrecoup/geometry/body/simple_bodies.h>
#include <contrecoup/geometry/image/head_segmentation.h>
#include <contrecoup/geometry/image/label_grid.h>
#include <contrecoup/geometry/image/part_thickness.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  std::string millimetres(const double length)
  {
    return brief(1e3 * length, 3) + " mm";
  }


  /// Largest elements, in tenths of a millimetre, of which a layer of any
  /// direction has no holes: their diagonal is its thickness.
  double closed_by(const double thickness)
  {
    constexpr double tenth = 1e-4, round_off = 1e-9;
    return tenth * std::floor(thickness / std::sqrt(3.) / tenth + round_off);
  }


  std::vector<BodyLayer> layers_of_phantom(ParameterHandler &prm)
  {
    const Section section(prm, "Phantom");
    // See make_nerves() and make_skull(), whose vault has this mean thickness.
    constexpr double fluid = 0.0025, skull = 0.0065, cord = 0.011,
                     stature = 1.756;
    const double head = read_double(prm, "Head scale"),
                 height = read_double(prm, "Stature") / stature;
    std::vector<BodyLayer> layers;
    for (const auto &[part, thickness] :
         {std::pair{"cerebrospinal fluid", fluid * head},
          std::pair{"skull", skull * head},
          std::pair{"spinal cord", cord * height}})
      layers.push_back({part, thickness, "Body/Phantom", thickness});
    const double skin = read_double(prm, "Skin thickness");
    if (skin > 0.)
      layers.push_back({"skin", skin, "Body/Phantom/Skin thickness"});
    return layers;
  }


  /// The phantom's layers, as they are before the warp to the person.
  std::vector<BodyLayer> layers_of_inserted_organs(ParameterHandler &prm)
  {
    {
      const Section section(prm, "Surface");
      if (prm.get("Organs") != "phantom")
        return {};
    }
    std::vector<BodyLayer> layers = layers_of_phantom(prm);
    layers.resize(3); // without skin
    return layers;
  }


  std::vector<BodyLayer> layers_of_shape(ParameterHandler &prm)
  {
    const Section section(prm, "Shape");
    SimpleBody body;
    body.parse_parameters(prm);
    return body.layers();
  }


  /// The parts of a label map, as thick as its voxels have them.
  std::vector<BodyLayer> layers_of_labels(const std::string &file,
                                          const std::vector<LabelRow> &table)
  {
    unsigned int last = 0;
    for (const LabelRow &row : table)
      last = std::max(last, row.last);
    std::vector<unsigned char> part_of(last + 1, LabelGrid::outside);
    for (std::size_t i = 0; i < table.size(); ++i)
      if (table[i].part.tissue != Tissue::none)
        std::fill(part_of.begin() + table[i].first,
                  part_of.begin() + table[i].last + 1,
                  static_cast<unsigned char>(i));
    const VoxelImage image = read_image(file);
    std::vector<unsigned char> parts;
    parts.reserve(image.values.size());
    for (const float label : image.values)
      parts.push_back(label >= 0.F && label <= static_cast<float>(last)
                        ? part_of[static_cast<unsigned int>(label)]
                        : LabelGrid::outside);
    const std::vector<double> thickness =
      part_thicknesses(image.size, image.spacing(), parts, table.size());
    std::vector<BodyLayer> layers;
    for (std::size_t i = 0; i < table.size(); ++i)
      if (thickness[i] > 0.)
        layers.push_back(
          {table[i].part.name, thickness[i], "Body/Image/File", thickness[i]});
    return layers;
  }


  std::vector<BodyLayer> layers_of_image(ParameterHandler &prm)
  {
    const Section section(prm, "Image");
    if (prm.get("Kind") == "labels")
      return prm.get("File").empty()
               ? std::vector<BodyLayer>()
               : layers_of_labels(prm.get("File"),
                                  parse_label_table(prm.get("Labels")));
    const Section head(prm, "Head");
    const HeadRules usual;
    HeadRules rules;
    rules.parse_parameters(prm);
    const std::string path = "Body/Image/Head/";
    return {{"cerebrospinal fluid",
             rules.fluid_thickness,
             path + "Fluid thickness",
             usual.fluid_thickness},
            {"skull",
             rules.skull_thickness,
             path + "Skull thickness",
             usual.skull_thickness},
            {"scalp",
             rules.scalp_thickness,
             path + "Scalp thickness",
             usual.scalp_thickness}};
  }


  /// Whether a layer is thinner than an element. Headers of images have single
  /// precision.
  bool is_thin(const BodyLayer &layer, const double element_size)
  {
    return layer.thickness < element_size * (1. - 1e-6);
  }


  /// Whether a layer is thinner than the diagonal of an element.
  bool has_large_elements(const BodyLayer &layer, const double element_size)
  {
    return is_thin(layer, std::sqrt(3.) * element_size);
  }


  /// "skin, 4 mm (ENTRY), layer 1, 2 mm (ENTRY) are".
  std::string words_of(const std::vector<BodyLayer> &layers)
  {
    std::vector<std::string> words;
    for (const BodyLayer &layer : layers)
      words.push_back(layer.part + ", " + millimetres(layer.thickness) + " (" +
                      layer.entry + ")");
    return join(words, ", ") + (words.size() > 1 ? " are" : " is");
  }


  /// "Scene/Element size of at most 1.7 mm closes it".
  std::string remedy(const std::vector<BodyLayer> &layers,
                     const std::string &entry,
                     const std::string &them)
  {
    double least = layers.front().thickness;
    for (const BodyLayer &layer : layers)
      least = std::min(least, layer.thickness);
    return entry + " of at most " + millimetres(closed_by(least)) + " closes " +
           them;
  }


  /// The line about layers that are thinner than an element, and about others
  /// that are thinner than its diagonal.
  std::string line_of(std::vector<BodyLayer> thin,
                      const std::vector<BodyLayer> &others,
                      const double element_size,
                      const std::string &entry)
  {
    const std::string elements = "elements of " + millimetres(element_size);
    std::vector<std::string> parts;
    if (!thin.empty())
      parts.push_back(
        words_of(thin) + " thinner than the " + elements + ", so that " +
        (thin.size() > 1 ? "they have" : "it has") + " holes or no element");
    if (!others.empty())
      parts.push_back(words_of(others) + " thinner than the diagonal of " +
                      (thin.empty() ? elements : "these") +
                      " and may be in pieces");
    thin.insert(thin.end(), others.begin(), others.end());
    return join(parts, "; ") + "; " + remedy(thin, entry, "the holes");
  }
} // namespace


bool has_holes(const BodyLayer &layer,
               const unsigned int n_pieces,
               const double element_size)
{
  return is_thin(layer, element_size) ||
         (n_pieces > 1 && has_large_elements(layer, element_size));
}


std::vector<BodyLayer> read_layers(ParameterHandler &prm)
{
  const Section section(prm, "Body");
  const std::string kind = prm.get("Kind");
  std::vector<BodyLayer> layers;
  if (kind == "phantom")
    layers = layers_of_phantom(prm);
  else if (kind == "shape")
    layers = layers_of_shape(prm);
  else if (kind == "image")
    layers = layers_of_image(prm);
  else if (kind == "surface")
    layers = layers_of_inserted_organs(prm);
  for (BodyLayer &layer : layers)
    for (double *const thickness : {&layer.thickness, &layer.usual})
      *thickness *= read_double(prm, "Scale");
  return layers;
}


std::vector<std::string> thin_layer_lines(const std::vector<BodyLayer> &layers,
                                          const double element_size,
                                          const double usual_size,
                                          const std::string &entry)
{
  std::vector<BodyLayer> warned, remarked, in_pieces;
  for (const BodyLayer &layer : layers)
    if (is_thin(layer, element_size))
      (layer.thickness * usual_size <
             layer.usual * element_size * (1. - 1e-6) ||
           layer.usual == 0.
         ? warned
         : remarked)
        .push_back(layer);
    else if (layer.thickness == layer.usual &&
             has_large_elements(layer, element_size))
      in_pieces.push_back(layer);
  std::vector<std::string> lines;
  if (!warned.empty())
    lines.push_back("WARNING: " + line_of(warned, {}, element_size, entry));
  if (!remarked.empty() || !in_pieces.empty())
    lines.push_back(line_of(remarked, in_pieces, element_size, entry));
  return lines;
}


std::vector<std::string>
uncertain_layer_lines(const std::vector<BodyLayer> &layers,
                      const double element_size,
                      const std::string &entry)
{
  std::vector<BodyLayer> found;
  for (const BodyLayer &layer : layers)
    if (layer.thickness != layer.usual && !is_thin(layer, element_size) &&
        has_large_elements(layer, element_size))
      found.push_back(layer);
  if (found.empty())
    return {};
  return {"WARNING: " + words_of(found) +
          " thinner than the diagonal of elements of " +
          millimetres(element_size) + " and may be in pieces; " +
          remedy(found, entry, found.size() > 1 ? "them" : "it")};
}


std::string layer_pieces_line(const BodyLayer &layer,
                              const unsigned int n_pieces,
                              const double element_size,
                              const std::string &entry)
{
  const bool is_usual = layer.thickness == layer.usual;
  if (n_pieces > 0 && (n_pieces == 1 || layer.thickness < element_size ||
                       (is_usual && !has_holes(layer, n_pieces, element_size))))
    return "";
  return (n_pieces == 0 || !is_usual ? "WARNING: " : "") + layer.part + " of " +
         millimetres(layer.thickness) + " (" + layer.entry + ") " +
         (n_pieces == 0
            ? "has no element"
            : "is in " + std::to_string(n_pieces) + " pieces of elements") +
         (has_large_elements(layer, element_size)
            ? "; " + remedy({layer}, entry, "it")
            : "");
}
} // namespace contrecoup
