// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>
#include <workload/track.hpp>

#if defined(__GNUC__)
#define ORISPLINE_PEERS __attribute__((visibility("default")))
#else
#define ORISPLINE_PEERS
#endif

namespace orispline::bench {

enum class Shape { quintic, slerp, uniform_bspline, through_keys };

/// Another way to sample the keys of a track. Only plain numbers pass: peers are compiled for this very processor.
template <class T>
struct Peer {
  std::string name;
  Shape shape;  ///< which definition it must agree with; through_keys: only at the keys
  /// Samples at the times, in any order; qx, qy, qz, qw sample after sample.
  std::function<void(std::span<const double> times, std::span<T> out)> sample;
};

/// The rates too: body frame, x, y, z sample after sample.
using SampleRates = std::function<void(std::span<const double> times, std::span<double> orientations,
                                       std::span<double> angular_velocities, std::span<double> angular_accelerations)>;

struct RatesPeer {
  std::string name;
  Shape shape;
  SampleRates sample;
};

/// Every peer that this build has.
[[nodiscard]] ORISPLINE_PEERS std::vector<Peer<double>> peers_of(const Track& track);
[[nodiscard]] ORISPLINE_PEERS std::vector<Peer<float>> float_peers_of(const Track& track);
[[nodiscard]] ORISPLINE_PEERS std::vector<RatesPeer> rates_peers_of(const Track& track);

/// Many curves at one time by the formula and the standard library's sine and cosine: segments[13 i] … are qx, qy, qz,
/// qw of the segment's key and its three half-angle vectors. All are blended alike.
template <class T>
ORISPLINE_PEERS void many_by_formula(std::span<const T> segments, T u, T tension, std::span<T> out);

std::vector<Peer<double>> eigen_peers(const Track& track);
std::vector<Peer<double>> glm_peers(const Track& track);
std::vector<Peer<float>> glm_float_peers(const Track& track);
std::vector<Peer<double>> smooth_peers(const Track& track);
std::vector<Peer<double>> sophus_peers(const Track& track);
std::vector<Peer<double>> basalt_peers(const Track& track);
RatesPeer eigen_rates_peer(const Track& track);
RatesPeer basalt_rates_peer(const Track& track);

}  // namespace orispline::bench
