// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/hand_over/profile_mapping.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace contrecoup::gas
{
namespace
{
  /// Part of a leaf in reference coordinates.
  template <int dim>
  struct Part
  {
    dealii::Point<dim> begin, end;
  };

  /// Edge vectors of a part, through its centre [m].
  template <int dim>
  std::array<dealii::Tensor<1, dim>, dim> edges_of(const LeafBox<dim> &leaf,
                                                   const Part<dim> &part)
  {
    std::array<dealii::Tensor<1, dim>, dim> edges;
    const dealii::Point<dim> middle =
      part.begin + 0.5 * (part.end - part.begin);
    for (unsigned int d = 0; d < dim; ++d)
    {
      if (leaf.is_box())
      {
        edges[d][d] = leaf.extents[d] * (part.end[d] - part.begin[d]);
        continue;
      }
      dealii::Point<dim> low = middle, high = middle;
      low[d] = part.begin[d];
      high[d] = part.end[d];
      edges[d] = leaf.place(high) - leaf.place(low);
    }
    return edges;
  }


  /// Integrates a profile over parts of leaves.
  template <int dim>
  class PartSampler
  {
  public:
    PartSampler(const ProfileField<dim> &profile,
                const unsigned int exponent,
                const bool rough)
      : profile_(profile)
      , exponent_(exponent)
      , rough_(rough)
    {}

    /// Computes the mean excess of the conserved quantities; returns false
    /// where the profile is ambient.
    bool sample(const LeafBox<dim> &leaf, const Part<dim> &part)
    {
      leaf_ = &leaf;
      volume_ = 0.;
      sum_.assign(dim + 3, 0.);
      is_disturbed_ = false;
      double longest = 0.;
      for (const auto &edge : edges_of(leaf, part))
        longest = std::max(longest, edge.norm());
      // Parts of a thirtieth of the profile resolve its shape.
      const double size = profile_.profile().end(0);
      const double levels = std::ceil(std::log2(longest * 30. / size));
      add(part, rough_ ? 0. : std::min(std::max(levels, 2.), 10.));
      for (double &value : sum_)
        value /= volume_;
      return is_disturbed_;
    }

    const std::vector<double> &mean() const
    {
      return sum_;
    }

  private:
    /// Variation above which a part is bisected [-].
    static constexpr double enough = 0.02;

    void add(const Part<dim> &part, const unsigned int levels_left)
    {
      const dealii::Point<dim> middle =
        part.begin + 0.5 * (part.end - part.begin);
      const auto edges = edges_of(*leaf_, part);
      const auto place = leaf_->place(middle);
      const auto window = profile_.window(place, edges);
      double size = 0.;
      for (const auto &edge : edges)
        size = std::max(size, edge.norm());
      // Near the centre the radial direction varies within a part.
      const bool bent = window.place[0] < 3. * size;
      const bool beyond = profile_.is_beyond(window, bent ? size : 0.);
      if (!beyond && levels_left > 0 &&
          (profile_.variation(window) > enough || bent))
      {
        for (unsigned int c = 0; c < (1U << dim); ++c)
          add(child(part, c), levels_left - 1);
        return;
      }
      double volume = leaf_->jacobian(middle);
      for (unsigned int d = 0; d < dim; ++d)
        volume *= part.end[d] - part.begin[d];
      volume *= radial_weight(place, edges[0]);
      volume_ += volume;
      if (beyond)
        return;
      is_disturbed_ = true;
      profile_.mean(window, excess_);
      for (unsigned int c = 0; c < sum_.size(); ++c)
        sum_[c] += volume * excess_[c];
    }

    /// Mean of r^exponent over a radial edge.
    double radial_weight(const dealii::Point<dim> &place,
                         const dealii::Tensor<1, dim> &edge) const
    {
      if (exponent_ == 0)
        return 1.;
      if (exponent_ == 1)
        return place[0];
      return place[0] * place[0] + edge[0] * edge[0] / 12.;
    }

    static Part<dim> child(const Part<dim> &part, const unsigned int number)
    {
      Part<dim> result = part;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double half = 0.5 * (part.begin[d] + part.end[d]);
        if ((number >> d) & 1U)
          result.begin[d] = half;
        else
          result.end[d] = half;
      }
      return result;
    }

    const ProfileField<dim> &profile_;
    const unsigned int exponent_;
    const bool rough_;
    const LeafBox<dim> *leaf_ = nullptr;
    double volume_ = 0.;
    bool is_disturbed_ = false;
    std::vector<double> sum_, excess_;
  };


  /// Volume, masses and energies of the disturbed points.
  struct Sums
  {
    double volume = 0., air = 0., products = 0., internal = 0., kinetic = 0.;

    void add_over_ranks(const MPI_Comm communicator)
    {
      for (double *value : {&volume, &air, &products, &internal, &kinetic})
        *value = dealii::Utilities::MPI::sum(*value, communicator);
    }
  };


  /// Conserved quantities of one point split into air, products, internal and
  /// kinetic energy.
  template <int dim>
  struct PointState
  {
    using C = Component<dim>;

    PointState(const std::vector<double> &leaf,
               const unsigned int q,
               const unsigned int n_points)
    {
      const unsigned int nc = leaf.size() / n_points;
      density = leaf[C::density * n_points + q];
      for (unsigned int d = 0; d < dim; ++d)
        momentum[d] = leaf[(C::momentum + d) * n_points + q];
      if (nc > C::products)
        products = leaf[C::products * n_points + q];
      kinetic = 0.5 * momentum.norm_square() / density;
      internal = leaf[C::energy * n_points + q] - kinetic;
    }

    void store(std::vector<double> &leaf,
               const unsigned int q,
               const unsigned int n_points) const
    {
      const unsigned int nc = leaf.size() / n_points;
      leaf[C::density * n_points + q] = density;
      for (unsigned int d = 0; d < dim; ++d)
        leaf[(C::momentum + d) * n_points + q] = momentum[d];
      leaf[C::energy * n_points + q] = internal + kinetic;
      if (nc > C::products)
        leaf[C::products * n_points + q] = products;
    }

    /// Scales air and products; velocity and internal energy per volume stay.
    void scale_mass(const double air, const double of_products)
    {
      const double before = density;
      density = air * (density - products) + of_products * products;
      products *= of_products;
      momentum *= density / before;
      kinetic *= density / before;
    }

    double density = 0., products = 0., internal = 0., kinetic = 0.;
    dealii::Tensor<1, dim> momentum;
  };


  /// Maps one profile onto one field.
  template <int dim>
  class Mapper
  {
  public:
    Mapper(const ProfileField<dim> &profile,
           const LeafMesh<dim> &mesh,
           const LeafPoints<dim> &points,
           const GasMaterial &material,
           GasField &field)
      : profile_(profile)
      , mesh_(mesh)
      , points_(points)
      , material_(material)
      , field_(field)
      , n_points_(field.layout().n_points)
      , disturbed_(std::size_t(mesh.n_owned()) * n_points_, false)
    {}

    void fill(const bool rough)
    {
      PartSampler<dim> sampler(profile_, points_.exponent(), rough);
      const unsigned int nc = field_.layout().n_components;
      std::vector<double> values(std::size_t(nc) * n_points_);
      for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      {
        const LeafBox<dim> box = leaf_box(mesh_, leaf);
        const bool beyond = is_beyond(box);
        for (unsigned int q = 0; q < n_points_; ++q)
        {
          const bool any = !beyond && sampler.sample(box, part_of(q));
          disturbed_[std::size_t(leaf) * n_points_ + q] = any;
          for (unsigned int c = 0; c < nc; ++c)
            values[c * n_points_ + q] =
              profile_.ambient_state()[c] + (any ? sampler.mean()[c] : 0.);
        }
        field_.set_leaf(leaf, values);
      }
    }

    ProfileMapping scale()
    {
      ProfileMapping result;
      const Sums sums = sum();
      result.found = {{sums.air, sums.products, sums.internal + sums.kinetic}};
      const auto &box = mesh_.coarse_mesh();
      std::optional<double> part;
      if (box.is_axis_aligned())
        part = profile_.fraction_within(box.lower_corner(), box.upper_corner());
      if (!part)
        return result;
      result.is_complete = true;
      const auto excess =
        profile_.totals(*part, box.lower_corner(), box.upper_corner());
      const auto &ambient = profile_.ambient_state();
      const bool mixture = field_.layout().n_components > dim + 2;
      const double products =
        mixture ? sums.volume * ambient[dim + 2] + excess[2] : 0.;
      result.wanted = {{sums.volume * ambient[0] + excess[0] - products,
                        products,
                        sums.volume * ambient[dim + 1] + excess[1]}};
      result.factors[0] = ratio(result.wanted[0], sums.air);
      result.factors[1] = ratio(result.wanted[1], sums.products);
      apply(result);
      return result;
    }

  private:
    /// Whether the leaf lies outside of the profile.
    bool is_beyond(const LeafBox<dim> &box) const
    {
      dealii::Point<dim> middle = box.origin;
      middle += 0.5 * box.extents;
      return profile_.is_beyond(profile_.window(middle, {}),
                                0.5 * box.extents.norm());
    }

    Part<dim> part_of(const unsigned int q) const
    {
      const auto index = points_.indices(q);
      Part<dim> part;
      for (unsigned int d = 0; d < dim; ++d)
      {
        part.begin[d] = points_.subcell_begin(index[d]);
        part.end[d] = points_.subcell_end(index[d]);
      }
      return part;
    }

    static double ratio(const double wanted, const double found)
    {
      if (found == wanted)
        return 1.;
      if (!(found > 0.) || !(wanted > 0.))
        throw NumericsError("The profile cannot be mapped: the mesh is too "
                            "coarse to see it");
      return wanted / found;
    }

    /// Calls @p function(state, volume) for each disturbed point and stores
    /// the state if it returns true.
    template <typename Function>
    void for_each_point(const Function &function)
    {
      for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
      {
        const auto first = disturbed_.begin() + std::size_t(leaf) * n_points_;
        if (std::find(first, first + n_points_, true) == first + n_points_)
          continue;
        const LeafBox<dim> box = leaf_box(mesh_, leaf);
        auto values = field_.leaf(leaf);
        bool changed = false;
        for (unsigned int q = 0; q < n_points_; ++q)
          if (first[q])
          {
            PointState<dim> state(values, q, n_points_);
            if (function(state, point_volume(box, points_, q)))
            {
              state.store(values, q, n_points_);
              changed = true;
            }
          }
        if (changed)
          field_.set_leaf(leaf, values);
      }
    }

    Sums sum()
    {
      Sums sums;
      for_each_point([&](const PointState<dim> &state, const double volume) {
        sums.volume += volume;
        sums.air += volume * (state.density - state.products);
        sums.products += volume * state.products;
        sums.internal += volume * state.internal;
        sums.kinetic += volume * state.kinetic;
        return false;
      });
      sums.add_over_ranks(mesh_.communicator());
      return sums;
    }

    void apply(ProfileMapping &mapping)
    {
      for_each_point([&](PointState<dim> &state, const double) {
        state.scale_mass(mapping.factors[0], mapping.factors[1]);
        return true;
      });
      const Sums sums = sum();
      const double factor =
        ratio(mapping.wanted[2] - sums.kinetic, sums.internal);
      mapping.factors[2] = factor;
      bool is_physical = true;
      for_each_point([&](PointState<dim> &state, const double) {
        state.internal *= factor;
        const double least = material_.least_energy_density(
          state.density, state.products / state.density);
        is_physical =
          is_physical && state.density > 0. && state.internal > least;
        return true;
      });
      if (dealii::Utilities::MPI::min(is_physical ? 1 : 0,
                                      mesh_.communicator()) == 0)
        throw NumericsError(
          "The profile cannot be mapped: energy corrected by a factor of " +
          brief(factor, 6) + " leaves states without internal energy");
    }

    const ProfileField<dim> &profile_;
    const LeafMesh<dim> &mesh_;
    const LeafPoints<dim> &points_;
    const GasMaterial &material_;
    GasField &field_;
    const unsigned int n_points_;
    std::vector<bool> disturbed_;
  };
} // namespace


template <int dim>
ProfileMapping map_profile(const ProfileField<dim> &profile,
                           const LeafMesh<dim> &mesh,
                           const LeafPoints<dim> &points,
                           const GasMaterial &material,
                           GasField &field,
                           const bool rough)
{
  Mapper<dim> mapper(profile, mesh, points, material, field);
  mapper.fill(rough);
  return rough ? ProfileMapping() : mapper.scale();
}


template <int dim>
bool is_steep_in(const ProfileField<dim> &profile,
                 const LeafBox<dim> &leaf,
                 const unsigned int n_points)
{
  const double steep = 0.05;
  Part<dim> whole, part;
  for (unsigned int d = 0; d < dim; ++d)
  {
    whole.end[d] = 1.;
    part.end[d] = 1. / n_points;
  }
  const double half_diagonal = 0.5 * leaf.extents.norm();
  dealii::Point<dim> middle;
  for (unsigned int d = 0; d < dim; ++d)
    middle[d] = 0.5;
  const auto around = profile.window(leaf.place(middle), edges_of(leaf, whole));
  if (profile.is_beyond(around, half_diagonal) ||
      profile.variation(around) <= steep)
    return false;
  // Tests all subcells: their windows differ along and across the radius.
  const auto subcell = edges_of(leaf, part);
  for (unsigned int i = 0; i < n_points; ++i)
    for (unsigned int j = 0; j < (dim > 1 ? n_points : 1); ++j)
      for (unsigned int k = 0; k < (dim > 2 ? n_points : 1); ++k)
      {
        const std::array<unsigned int, 3> index = {{i, j, k}};
        dealii::Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = (index[d] + 0.5) / n_points;
        if (profile.variation(profile.window(leaf.place(x), subcell)) > steep)
          return true;
      }
  return false;
}


std::string to_text(const ProfileMapping &mapping, const bool has_products)
{
  if (!mapping.is_complete)
    return "  WARNING: the domain cuts the profile other than by planes "
           "through its centre; its totals are those of the cells' means";
  std::string text;
  const std::array<std::string, 3> names = {
    {has_products ? "mass of air" : "mass", "mass of products", "energy"}};
  const std::array<std::string, 3> units = {{" kg", " kg", " J"}};
  for (unsigned int i = 0; i < 3; ++i)
    if (has_products || i != 1)
      text += (text.empty() ? "  " : "\n  ") + names[i] + " " +
              brief(mapping.wanted[i], 12) + units[i] + ", cell means gave " +
              brief(mapping.found[i], 12) + units[i] + "; factor " +
              (i == 2 ? "of heat " : "") + brief(mapping.factors[i], 10);
  return text;
}


#define CONTRECOUP_INSTANTIATE(dim)                              \
  template ProfileMapping map_profile(const ProfileField<dim> &, \
                                      const LeafMesh<dim> &,     \
                                      const LeafPoints<dim> &,   \
                                      const GasMaterial &,       \
                                      GasField &,                \
                                      bool);                     \
  template bool is_steep_in(                                     \
    const ProfileField<dim> &, const LeafBox<dim> &, unsigned int)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
