// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <peers/peers.hpp>

namespace orispline::bench {

std::vector<Peer<double>> peers_of(const Track& track) {
  std::vector<Peer<double>> all = eigen_peers(track);
  const auto append = [&all](std::vector<Peer<double>> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  append(glm_peers(track));
#if defined(ORISPLINE_BENCH_SMOOTH)
  append(smooth_peers(track));
#endif
#if defined(ORISPLINE_BENCH_SOPHUS)
  append(sophus_peers(track));
#endif
#if defined(ORISPLINE_BENCH_BASALT)
  append(basalt_peers(track));
#endif
  return all;
}

std::vector<Peer<float>> float_peers_of(const Track& track) { return glm_float_peers(track); }

std::vector<RatesPeer> rates_peers_of(const Track& track) {
  std::vector<RatesPeer> all{eigen_rates_peer(track)};
#if defined(ORISPLINE_BENCH_BASALT)
  all.push_back(basalt_rates_peer(track));
#endif
  return all;
}

}  // namespace orispline::bench
