// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_extents.h>
#include <contrecoup/ale/particles/particle_scene.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>

#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Ratio of bulk to shear modulus above which solids lock.
  constexpr double locking_ratio = 20.;

  /// Margin of the grid around the matter for the support of splines.
  constexpr double margin_cells = 3.;

  const std::vector<std::string> smoothings{"liquids and gels", "all", "none"};

  const std::vector<std::string> field_kinds{"by interface",
                                             "one",
                                             "slip",
                                             "contact"};

  void declare_grid(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Cell size",
                   "0.004",
                   1e-6,
                   1e3,
                   "m",
                   "Cell size of the background grid.");
    declare_list(
      prm,
      "Particles a cell",
      "2, 2, 2",
      3,
      3,
      1.,
      10.,
      "-",
      "Particles per cell along x, y and z; 2, 2, 2 puts 8 into a full cell.");
    declare_selection(prm,
                      "Basis",
                      "cubic",
                      names_of(mpm::bases),
                      "B-splines of the grid: " + help_of(mpm::bases) + ".");
  }

  void declare_scheme(ParameterHandler &prm)
  {
    declare_selection(prm,
                      "Transfer",
                      "flip",
                      names_of(mpm::transfers),
                      "Update of particle velocities from the grid: " +
                        help_of(mpm::transfers) + ".");
    declare_selection(
      prm,
      "Update",
      "musl",
      names_of(mpm::stress_updates),
      "Velocity of the stress update: " + help_of(mpm::stress_updates) + ".");
    declare_integer(
      prm,
      "Series order",
      "2",
      1,
      16,
      used_with("MPM/Transfer = flip, fmpm",
                "Terms of the mass series of flip and fmpm: 1 is the "
                "lumped mass, which slows sound waves; each further "
                "term costs a transfer to the particles and back."));
    declare_double(
      prm,
      "Damping time",
      "1e9",
      1e-9,
      1e9,
      "s",
      used_with("MPM/Transfer = flip",
                "Time constant, independent of the step size, with which "
                "flip damps particle motion that the grid does not "
                "resolve."));
  }

  void declare_fields(ParameterHandler &prm)
  {
    declare_selection(prm,
                      "Fields",
                      field_kinds[0],
                      field_kinds,
                      "Velocity fields: one for all regions, which stick; "
                      "or one per region, which slip or, with contact, may "
                      "also separate. By interface: slip if any region has "
                      "Interface = slip.");
    declare_double(prm,
                   "Friction",
                   "0",
                   0.,
                   10.,
                   "-",
                   "Coulomb friction coefficient between regions in contact.");
    declare_selection(prm,
                      "Smoothing",
                      "liquids and gels",
                      smoothings,
                      "Materials whose volume strain and pressure are "
                      "smoothed with linear splines against locking; gels "
                      "are solids with a bulk modulus above 20 shear moduli.");
  }

  bool locks(const Region &region)
  {
    const SolidMaterial *const solid = region.solid();
    return solid == nullptr ||
           solid->bulk_modulus > locking_ratio * solid->instantaneous_shear;
  }
} // namespace


void ParticleScene::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "MPM");
  const UsedWith used("Method = mpm");
  declare_grid(prm);
  declare_scheme(prm);
  declare_fields(prm);
}


void ParticleScene::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "MPM");
  cell_size_ = read_double(prm, "Cell size");
  scheme_.degree = find_choice(mpm::bases, prm.get("Basis"), "basis");
  scheme_.transfer =
    find_choice(mpm::transfers, prm.get("Transfer"), "transfer");
  scheme_.update =
    find_choice(mpm::stress_updates, prm.get("Update"), "update of stresses");
  scheme_.series_order = read_unsigned(prm, "Series order");
  scheme_.damping_time = read_double(prm, "Damping time");
  smoothing_ = prm.get("Smoothing");
  fields_ = prm.get("Fields");
  friction_ = read_double(prm, "Friction");
  const auto numbers = read_list(prm, "Particles a cell");
  for (unsigned int d = 0; d < 3; ++d)
    source_.per_cell[d] = static_cast<unsigned int>(numbers[d]);
  // At least three times the initial number, so as not to merge at the start.
  constexpr double usually = 64.;
  largest_per_cell_ = static_cast<unsigned int>(
    std::max(usually, 3. * numbers[0] * numbers[1] * numbers[2]));
  if (scheme_.transfer == mpm::Transfer::affine && scheme_.degree == 1)
    throw InputError(
      "MPM/Transfer = apic needs MPM/Basis = quadratic or cubic");
}


void ParticleScene::make_materials(const RegionDescriptions &regions)
{
  materials_.clear();
  const auto all = regions.regions();
  const bool slips = std::any_of(
    all.begin(), all.end(), [](const Region &region) { return region.slides; });
  if (fields_ == "one" && slips)
    throw InputError("MPM/Fields = one makes all regions stick, but a region "
                     "has Interface = slip; change one of them");
  if (fields_ == field_kinds[0])
    fields_ = slips ? "slip" : "one";
  if (fields_ != "one" && all.size() < 2)
    throw InputError("MPM/Fields = " + fields_ +
                     " selects no interface: there is a single region");
  if (friction_ > 0. && fields_ == "one")
    throw InputError("MPM/Friction = " + brief(friction_) +
                     " acts between the fields of regions; it needs "
                     "MPM/Fields = slip or contact");
  for (const Region &region : all)
  {
    mpm::ParticleMaterial material;
    material.name = region.name;
    if (const SolidMaterial *const solid = region.solid())
      material.law = *solid;
    else if (const Tait *const liquid = std::get_if<Tait>(&region.law))
      material.law = *liquid;
    else
      throw InputError("Region " + region.name +
                       "/Material: particles are tait, elastic, viscoelastic, "
                       "johnson-cook or a tissue; gases need Method = ale");
    material.kinematics = region.kinematics;
    material.plasticity = region.plasticity;
    material.linear_viscosity = region.viscosity.linear;
    material.quadratic_viscosity = region.viscosity.quadratic;
    material.is_smoothed =
      smoothing_ == "all" || (smoothing_ != "none" && locks(region));
    // Materials that may separate need their own pressure field.
    material.smoothing_group = regions_part() ? materials_.size() : 0;
    material.field = fields_ == "one" ? 0 : materials_.size();
    materials_.push_back(material);
  }
}


void ParticleScene::make_source(const MeshDescription &mesh,
                                const RegionDescriptions &regions)
{
  MeshLayers layers = mesh.layers();
  regions.check_layers(mesh.has_layers() ? layers : MeshLayers());
  if (!mesh.has_layers())
    layers = {MeshLayer()};
  // A table by layer is faster if nothing depends on the place.
  std::vector<int> of_layer;
  if (!regions.depends_on_place())
    for (const MeshLayer &layer : layers)
    {
      of_layer.push_back(regions.find_region({}, layer));
      const std::string words = "the layer \"" + layer.label() + "\" of the ";
      if (of_layer.back() < 0 && mesh.head() != nullptr)
        throw InputError("Region: " + words + "head is in none");
      if (of_layer.back() < 0 && mesh.has_layers())
        log_line("WARNING: Region: " + words + "body is in none; it is empty");
    }
  source_.material_at =
    [mesh, regions, layers, of_layer](const dealii::Point<3> &place) {
      const int layer = mesh.layer_at(place);
      if (layer < 0)
        return mpm::ParticleSource::none;
      return of_layer.empty() ? regions.find_region(place, layers[layer])
                              : of_layer[layer];
    };
  source_.velocity_at = [regions](const dealii::Point<3> &place,
                                  const unsigned int material) {
    return regions.velocity_at(place, material);
  };
  const auto all = regions.regions();
  source_.dilatation_at = [regions, all](const dealii::Point<3> &place,
                                         const unsigned int material) {
    const double density = regions.matter_at(place, material).density;
    const Tait *const liquid = std::get_if<Tait>(&all[material].law);
    return liquid == nullptr ? 0. : liquid->density() / density - 1.;
  };
}


void ParticleScene::make_box(const MeshDescription &mesh,
                             const double largest_speed,
                             const double end_time)
{
  const auto corners = mesh.corners();
  box_.cell_size = cell_size_;
  box_.reflects = mesh.sides_at_rest();
  box_.is_no_slip = mesh.clamped_sides();
  const double margin = margin_cells * cell_size_ + largest_speed * end_time;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const bool lower = box_.reflects[2 * d], upper = box_.reflects[2 * d + 1];
    double first = corners[0][d] - (lower ? 0. : margin),
           last = corners[1][d] + (upper ? 0. : margin);
    const double cells = (last - first) / cell_size_;
    box_.n_cells[d] =
      static_cast<unsigned int>(std::max(1., std::ceil(cells - 1e-6)));
    if (lower && upper && std::abs(box_.n_cells[d] - cells) > 1e-6)
      throw InputError(
        "MPM/Cell size = " + brief(cell_size_) +
        " m: from wall to wall along " + std::string(1, "xyz"[d]) + " are " +
        brief(last - first) + " m, which must be a multiple of it");
    // Walls coincide with planes of nodes.
    box_.lower[d] =
      upper && !lower ? last - box_.n_cells[d] * cell_size_ : first;
  }
}


void ParticleScene::reinit(const ImpactScene &impact)
{
  const MeshDescription &mesh = impact.mesh;
  make_box(mesh, impact.regions.largest_components().norm(), impact.end_time);
  make_materials(impact.regions);
  make_source(mesh, impact.regions);
  walls_.clear();
  for (const ContactPlane &plane : impact.planes.planes())
    walls_.push_back({plane.name, plane.point, plane.normal, plane.friction});
  if (const double radius = mesh.sphere_radius(); radius > 0.)
    walls_.push_back({"sphere", {}, {}, 0., radius, true});
}


mpm::FieldContact ParticleScene::field_contact() const
{
  std::vector<unsigned int> fields;
  for (const mpm::ParticleMaterial &material : materials_)
    fields.push_back(material.field);
  if (fields_ == "one")
    return mpm::FieldContact();
  return mpm::FieldContact(
    scheme_.degree,
    fields,
    find_choice(mpm::field_interfaces, fields_, "interface of velocity fields"),
    half_spacing(),
    std::pow(cell_size_, 3) /
      (source_.per_cell[0] * source_.per_cell[1] * source_.per_cell[2]),
    friction_);
}


bool ParticleScene::regions_part() const
{
  return fields_ == field_kinds[3];
}


double ParticleScene::half_spacing() const
{
  return 0.5 * cell_size_ /
         *std::max_element(source_.per_cell.begin(), source_.per_cell.end());
}
} // namespace contrecoup::ale
