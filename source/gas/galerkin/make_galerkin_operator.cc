// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/galerkin/galerkin_leaves.h>
#include <contrecoup/gas/galerkin/make_galerkin_operator.h>

namespace contrecoup::gas
{
namespace
{
  /// The discontinuous Galerkin scheme of any degree on deal.II's MatrixFree:
  /// the faces of a batch of cells just before its leaves. Each leaf adds its
  /// fluxes in one order, which does not depend on the ranks.
  template <int dim, typename Gas, typename Real>
  class GalerkinOperator : public GasOperator<dim>
  {
  public:
    using GasOperator<dim>::apply;
    using GasOperator<dim>::analyse;

    GalerkinOperator(const LeafMesh<dim> &mesh,
                     const LeafLayout &layout,
                     const Scheme &scheme,
                     const Gas &gas,
                     const Boundary<dim> &boundary)
      : GasOperator<dim>(mesh, layout, boundary)
      , space_(mesh, layout)
      , faces_(space_, layout, scheme, gas, boundary)
      , leaves_(mesh, space_, faces_, layout, scheme, gas, boundary)
    {}

    void reinit() override
    {
      space_.reinit();
      faces_.reinit();
      leaves_.reinit();
    }

    void apply(const BasicStage<Real> &stage,
               QuietLeaves<dim> &quiet_leaves) override
    {
      quiet_leaves.begin_stage(stage.in);
      const auto is_active = [&](const auto &leaves) {
        return std::any_of(
          leaves.begin(), leaves.end(), [&](const unsigned int leaf) {
            return quiet_leaves.is_active(leaf / layout_.width);
          });
      };
      // Faces just before the first leaves that need them: what they read and
      // write is still at hand then.
      std::vector<bool> is_done(space_.faces().size(), false);
      for (unsigned int b = 0; b < space_.cells().size(); ++b)
      {
        const auto &cells = space_.cells()[b];
        if (!is_active(cells.leaf))
          continue;
        if (b + 1 < space_.cells().size())
          for (const unsigned int face : space_.cells()[b + 1].faces)
            if (!is_done[face])
              faces_.prefetch(face, stage.in);
        for (const unsigned int face : cells.faces)
          if (!is_done[face])
          {
            faces_.compute(face, stage);
            is_done[face] = true;
          }
        leaves_.update(b, stage, quiet_leaves);
      }
      fill_padding(stage.results.state);
      for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
        if (quiet_leaves.is_active(batch))
          quiet_leaves.find_woken_leaves(batch, stage.results.state);
    }

    void analyse(const BasicStage<Real> &stage) override
    {
      for (unsigned int b = 0; b < space_.cells().size(); ++b)
        leaves_.analyse(b, stage);
    }

  private:
    /// Padding lanes copy the first, so that they never overflow.
    void fill_padding(Real *state) const
    {
      if (mesh_.n_owned() == 0)
        return;
      const unsigned int batch = mesh_.n_batches() - 1;
      Real *const values = state + batch * layout_.batch_size();
      for (unsigned int lane = mesh_.n_filled_lanes(batch);
           lane < layout_.width;
           ++lane)
        for (std::size_t i = 0; i < layout_.batch_size(); i += layout_.width)
          values[i + lane] = values[i];
    }

    using GasOperator<dim>::layout_;
    using GasOperator<dim>::mesh_;
    GalerkinSpace<dim, Real> space_;
    GalerkinFaces<dim, Gas, Real> faces_;
    GalerkinLeaves<dim, Gas, Real> leaves_;
  };
} // namespace


template <int dim>
std::unique_ptr<GasOperator<dim>>
make_galerkin_operator(const LeafMesh<dim> &mesh,
                       const LeafLayout &layout,
                       const Scheme &scheme,
                       const GasMaterial &material,
                       const Boundary<dim> &boundary)
{
  return std::visit(
    [&](const auto &gas) {
      return visit_precision(
        layout.precision,
        [&](const auto real) -> std::unique_ptr<GasOperator<dim>> {
          using Gas = std::decay_t<decltype(gas)>;
          using Real = kernel_number<dim, std::decay_t<decltype(real)>>;
          return std::make_unique<GalerkinOperator<dim, Gas, Real>>(
            mesh, layout, scheme, gas, boundary);
        });
    },
    material.model());
}


#define CONTRECOUP_INSTANTIATE(dim)                                  \
  template std::unique_ptr<GasOperator<dim>> make_galerkin_operator( \
    const LeafMesh<dim> &,                                           \
    const LeafLayout &,                                              \
    const Scheme &,                                                  \
    const GasMaterial &,                                             \
    const Boundary<dim> &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
