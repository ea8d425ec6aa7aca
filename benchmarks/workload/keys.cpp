// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <cstdlib>
#include <workload/keys.hpp>

namespace orispline::bench {

void give_up(std::string_view reason) {
  std::fprintf(stderr, "orispline_bench: %.*s\n", static_cast<int>(reason.size()), reason.data());
  std::exit(EXIT_FAILURE);
}

Keyframes keys_of(const Track& track) {
  KeyframeData data;
  data.times = track.times;
  for (std::size_t i = 0; i < track.keys(); ++i)
    data.orientations.emplace_back(Eigen::Quaterniond(&track.orientations[4 * i]));
  return value_or_give_up(Keyframes::make(std::move(data)));
}

Track normalised(Track track) {
  const Keyframes keys = keys_of(track);
  track.orientations.clear();
  for (const Eigen::Quaterniond& q : keys.orientations())
    track.orientations.insert(track.orientations.end(), q.coeffs().begin(), q.coeffs().end());
  return track;
}

AnyCurve curve_through(const Track& track, std::string_view method) {
  CurveOptions options;
  if (method == "quintic") options.parameters.emplace("tension", track.tensions);
  return value_or_give_up(make_curve({method, options}, keys_of(track)));
}

}  // namespace orispline::bench
