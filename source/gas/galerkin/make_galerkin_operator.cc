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
  class GalerkinOperator : public GasOperator<dim, Real>
  {
  public:
    GalerkinOperator(const OperatorContext<dim> &context, const Gas &gas)
      : GasOperator<dim, Real>(context)
      , space_(context.mesh, context.layout)
      , faces_(space_, context, gas)
      , leaves_(space_, faces_, context, gas)
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

    using GasOperator<dim, Real>::layout_;
    using GasOperator<dim, Real>::mesh_;
    GalerkinSpace<dim, Real> space_;
    GalerkinFaces<dim, Gas, Real> faces_;
    GalerkinLeaves<dim, Gas, Real> leaves_;
  };
} // namespace


template <int dim, typename Real>
std::unique_ptr<GasOperator<dim, Real>>
make_galerkin_operator(const OperatorContext<dim> &context,
                       const GasMaterial &material)
{
  return std::visit(
    [&](const auto &gas) -> std::unique_ptr<GasOperator<dim, Real>> {
      using Gas = std::decay_t<decltype(gas)>;
      return std::make_unique<GalerkinOperator<dim, Gas, Real>>(context, gas);
    },
    material.model());
}


const OperatorMakers contrecoup_galerkin_makers = {
  make_galerkin_operator<1, double>,
  make_galerkin_operator<2, double>,
  make_galerkin_operator<3, double>,
  make_galerkin_operator<3, float>};
} // namespace contrecoup::gas
