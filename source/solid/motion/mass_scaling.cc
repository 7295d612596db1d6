// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/motion/mass_scaling.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>

namespace contrecoup::solid
{
double element_square_frequency(const HexGeometry<double> &geometry,
                                const SolidMaterial &material)
{
  dealii::SymmetricTensor<2, 3> gram;
  for (const Vector3<double> &b : geometry.volume_gradient)
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        gram[i][j] += 8. * b[i] * b[j] * geometry.inverse_volume;
  const double shear = material.instantaneous_shear;
  const double lame = std::max(0., material.bulk_modulus - 2. / 3. * shear);
  const double stiffness =
    lame * trace(gram) + 2. * shear * dealii::eigenvalues(gram)[0];
  return 8. * stiffness / (material.density * geometry.volume);
}


void MassScaling::reinit(const SolidMesh &mesh,
                         const std::vector<SolidMaterial> &materials,
                         const double smallest_step,
                         const MPI_Comm communicator)
{
  active_ = smallest_step > 0.;
  nodal_masses_.assign(mesh.tissues.size(), {});
  report_.clear();
  if (!active_)
    return;
  std::vector<double> sums(2 * mesh.tissues.size(), 0.);
  for (std::size_t i = 0; i < mesh.elements.size(); ++i)
  {
    HexVectors<double> x;
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        x[c][d] = mesh.nodes[mesh.elements[i][c]][d];
    const HexGeometry<double> geometry = hex_geometry(to_modes(x));
    const unsigned int tissue = mesh.tissue[i];
    // Factor on the density: (smallest_step * omega / 2)^2.
    const double density_factor =
      0.25 * smallest_step * smallest_step *
      element_square_frequency(geometry, materials[tissue]);
    if (density_factor <= 1.)
      continue;
    const double added =
      (density_factor - 1.) * materials[tissue].density * geometry.volume;
    for (const std::uint32_t node : mesh.elements[i])
      nodal_masses_[tissue].push_back({node, added / 8.});
    sums[2 * tissue] += 1.;
    sums[2 * tissue + 1] += added;
  }
  dealii::Utilities::MPI::sum(sums, communicator, sums);
  for (unsigned int k = 0; k < mesh.tissues.size(); ++k)
  {
    const Tissue tissue = mesh.tissues[k];
    report_.push_back(
      {tissue_column("scaled_elements", tissue), "-", sums[2 * k]});
    report_.push_back(
      {tissue_column("added_mass", tissue), "kg", sums[2 * k + 1]});
  }
}


void MassScaling::add_to(std::vector<double> &masses) const
{
  for (const std::vector<NodalMass> &tissue : nodal_masses_)
    for (const NodalMass &added : tissue)
      masses[added.node] += added.mass;
}


template <typename Real>
double MassScaling::kinetic_energy(const unsigned int tissue,
                                   const std::vector<Real> &squares) const
{
  double sum = 0.;
  for (const NodalMass &added : nodal_masses_[tissue])
    sum += 0.5 * added.mass * double(squares[added.node]);
  return sum;
}


template double MassScaling::kinetic_energy(const unsigned int,
                                            const std::vector<double> &) const;
template double MassScaling::kinetic_energy(const unsigned int,
                                            const std::vector<float> &) const;
} // namespace contrecoup::solid
