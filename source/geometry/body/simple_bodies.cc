// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/body/body_layer.h>
#include <contrecoup/geometry/body/simple_bodies.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>

namespace contrecoup
{
using dealii::Point;

namespace
{
  /// Default sizes, layers and tissues of a shape.
  struct Default
  {
    std::string shape;
    std::vector<std::size_t> counts; ///< allowed numbers of values in Size
    std::vector<double> size;
    std::vector<double> layers;
    std::vector<Tissue> tissues;
  };

  const std::vector<Default> &defaults()
  {
    static const std::vector<Default> table{
      {"sphere", {1}, {0.1}, {}, {Tissue::soft_tissue}},
      {"ellipsoid", {3}, {0.1, 0.08, 0.07}, {}, {Tissue::soft_tissue}},
      {"cylinder", {2}, {0.1, 0.3}, {}, {Tissue::soft_tissue}},
      {"box", {3}, {0.2, 0.2, 0.2}, {}, {Tissue::soft_tissue}},
      {"layered head",
       {1, 3},
       {0.084, 0.068, 0.060},
       {0.0025, 0.0065, 0.005},
       {Tissue::brain,
        Tissue::cerebrospinal_fluid,
        Tissue::skeleton,
        Tissue::soft_tissue}},
      {"surrogate head",
       {1, 3},
       {0.095, 0.075, 0.075},
       {0.006},
       {Tissue::water, Tissue::polycarbonate}}};
    return table;
  }

  const Default &default_of(const std::string &shape)
  {
    for (const Default &one : defaults())
      if (one.shape == shape)
        return one;
    throw InputError("\"" + shape + "\" is not a shape");
  }

  std::vector<std::string> shape_names()
  {
    std::vector<std::string> names;
    for (const Default &one : defaults())
      names.push_back(one.shape);
    return names;
  }
} // namespace


void SimpleBody::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_selection(prm,
                    "Shape",
                    "sphere",
                    shape_names(),
                    "Shape, centred at the origin; heads have layers around "
                    "a core that is an ellipsoid or, with one size, a "
                    "sphere.");
  declare_list(prm,
               "Size",
               "",
               0,
               3,
               1e-6,
               1e3,
               "m",
               "Radius of a sphere; semi-axes of an ellipsoid or of the "
               "core of a head; radius and length of a cylinder along z; "
               "edges of a box. Empty: 0.1; 0.1, 0.08, 0.07 (heads: 0.084, "
               "0.068, 0.06 and 0.095, 0.075, 0.075); 0.1, 0.3; 0.2, 0.2, "
               "0.2.");
  declare_list(
    prm,
    "Layers",
    "",
    0,
    10,
    1e-6,
    1e3,
    "m",
    used_with("Body/Shape/Shape = layered head, surrogate head",
              "Thickness of each layer of a head from the inside. Empty: "
              "0.0025, 0.0065, 0.005 for the layered head, 0.006 for the "
              "surrogate (our choice)."));
  declare_string(
    prm,
    "Tissues",
    "",
    "Tissue of the shape, or of core and layers from the inside, "
    "separated by commas: names out of " +
      join({tissue_names().begin() + 1, tissue_names().end()}, ", ") +
      ", or of the user's own. Empty: soft tissue; brain, cerebrospinal fluid, "
      "skeleton, soft tissue; water, polycarbonate.");
}


void SimpleBody::parse_parameters(dealii::ParameterHandler &prm)
{
  shape_ = prm.get("Shape");
  const Default &usual = default_of(shape_);
  size_ = read_list(prm, "Size");
  if (size_.empty())
    size_ = usual.size;
  if (std::find(usual.counts.begin(), usual.counts.end(), size_.size()) ==
      usual.counts.end())
    throw InputError("Body/Shape/Size has " + std::to_string(size_.size()) +
                     " number(s), a " + shape_ + " needs " +
                     std::to_string(usual.counts.back()));
  layers_ = read_list(prm, "Layers");
  if (layers_.empty())
    layers_ = usual.layers;
  if (usual.layers.empty() && !layers_.empty())
    throw InputError("Body/Shape/Layers: a " + shape_ +
                     " has none; heads have");
  tissues_ = find_tissues(prm.get("Tissues"), "Body/Shape/Tissues");
  if (tissues_.empty())
    tissues_ = usual.tissues;
  if (tissues_.size() != layers_.size() + 1)
    throw InputError("Body/Shape/Tissues: " + std::to_string(tissues_.size()) +
                     " tissue(s) for a core and " +
                     std::to_string(layers_.size()) + " layer(s)");
}


BodyPointer SimpleBody::create() const
{
  const Point<3> origin;
  ShapePointer shape;
  if (shape_ == "cylinder")
    shape = std::make_shared<Cylinder>(Point<3>(0., 0., -0.5 * size_[1]),
                                       Point<3>(0., 0., 0.5 * size_[1]),
                                       size_[0]);
  else if (shape_ == "box")
    shape = std::make_shared<RoundedBox>(
      origin, 0.5 * Point<3>(size_[0], size_[1], size_[2]));
  else if (size_.size() == 1)
    shape = std::make_shared<Sphere>(origin, size_[0]);
  else
    shape = std::make_shared<Ellipsoid>(origin,
                                        Point<3>(size_[0], size_[1], size_[2]));
  std::vector<ShapeBody::PartShape> part_shapes{
    {{"core: " + name_of(tissues_[0]), tissues_[0]}, shape}};
  double depth = 0.;
  for (const BodyLayer &layer : layers())
  {
    depth += layer.thickness;
    part_shapes.push_back({{layer.part, tissues_[part_shapes.size()]},
                           std::make_shared<Offset>(shape, depth)});
  }
  return std::make_shared<ShapeBody>(part_shapes.back().shape, part_shapes);
}


std::vector<BodyLayer> SimpleBody::layers() const
{
  const std::vector<double> &usual = default_of(shape_).layers;
  std::vector<BodyLayer> layers;
  for (std::size_t i = 0; i < layers_.size(); ++i)
    layers.push_back(
      {"layer " + std::to_string(i + 1) + ": " + name_of(tissues_[i + 1]),
       layers_[i],
       "Body/Shape/Layers",
       i < usual.size() ? usual[i] : 0.});
  return layers;
}
} // namespace contrecoup
