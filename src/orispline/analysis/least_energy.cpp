// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/least_energy.hpp>

#include <algorithm>

#include <orispline/analysis/energy.hpp>
#include <orispline/families/registry.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

bool are_equal(const Keyframes& a, const Keyframes& b) {
  return std::ranges::equal(a.times(), b.times()) &&
         std::ranges::equal(a.orientations(), b.orientations(),
                            [](const auto& p, const auto& q) { return p.coeffs() == q.coeffs(); });
}

}  // namespace

std::optional<double> least_energy(const Keyframes& keys) {
  if (keys.size() < 2 || keys.size() > most_keys_for_least_energy) return std::nullopt;
  const auto of_orientations =
      Keyframes::make({.times = {keys.times().begin(), keys.times().end()},
                       .orientations = {keys.orientations().begin(), keys.orientations().end()}});
  if (!of_orientations) return std::nullopt;
  const auto curve = make_curve("least", *of_orientations);
  return curve ? std::optional(energies(*curve).acceleration) : std::nullopt;
}

std::vector<std::size_t> first_of_equal(std::span<const Keyframes* const> tracks) {
  std::vector<std::size_t> firsts;
  for (const Keyframes* track : tracks)
    firsts.push_back(static_cast<std::size_t>(
        std::ranges::find_if(tracks, [&](const Keyframes* other) { return are_equal(*other, *track); }) -
        tracks.begin()));
  return firsts;
}

}  // namespace orispline::inline ORISPLINE_ABI
