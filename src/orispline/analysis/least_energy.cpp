// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/least_energy.hpp>

#include <orispline/analysis/energy.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

std::optional<double> least_energy(const Keyframes& keys) {
  if (keys.size() < 2 || keys.size() > most_keys_for_least_energy) return std::nullopt;
  const auto of_orientations =
      Keyframes::make({.times = {keys.times().begin(), keys.times().end()},
                       .orientations = {keys.orientations().begin(), keys.orientations().end()}});
  if (!of_orientations) return std::nullopt;
  const auto curve = make_curve("least", *of_orientations);
  return curve ? std::optional(energies(*curve).acceleration) : std::nullopt;
}

}}  // namespace orispline
