// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <peers/peers.hpp>
#include <peers/uniform_time.hpp>
#include <workload/verify.hpp>

namespace orispline::bench {

/// Smooth's fit adds up along the track.
inline constexpr double through_keys_limit = 1e-10;

/// What a contender of some shape must give at a time of the track.
class ShapeTruth {
 public:
  ShapeTruth(Shape shape, const Track& track, const Definition& definition)
      : shape_(shape), track_(track), definition_(definition) {}

  [[nodiscard]] LongQuaternion orientation(double t) const {
    if (shape_ == Shape::slerp) return definition_.slerp(t);
    if (shape_ == Shape::quintic) return definition_.quintic(t);
    return definition_.uniform_bspline(place(t), first_key(t));
  }
  [[nodiscard]] LongVector angular_velocity(double t) const {
    if (shape_ == Shape::quintic) return definition_.angular_velocity(t);
    return definition_.uniform_bspline_velocity(place(t), first_key(t));
  }
  [[nodiscard]] LongVector angular_acceleration(double t) const {
    if (shape_ == Shape::quintic) return definition_.angular_acceleration(t);
    return definition_.uniform_bspline_acceleration(place(t), first_key(t));
  }

 private:
  static constexpr std::int64_t unit = 1'000'000'000;
  [[nodiscard]] Real place(double t) const { return Real(1e-9L) * static_cast<Real>(uniform_place(track_, t) % unit); }
  [[nodiscard]] std::size_t first_key(double t) const {
    return static_cast<std::size_t>(uniform_place(track_, t) / unit);
  }

  Shape shape_;
  const Track& track_;
  const Definition& definition_;
};

/// Ends the program when a peer is not at its keys; q and -q are the same.
inline void accept_at_keys(const Peer<double>& peer, const Track& track) {
  std::vector<double> found(track.orientations.size());
  peer.sample(track.times, found);
  double largest = 0.0;
  for (std::size_t i = 0; i < track.keys(); ++i) {
    const Eigen::Map<const Eigen::Vector4d> q(&found[4 * i]), key(&track.orientations[4 * i]);
    const double off = std::min((q - key).norm(), (q + key).norm());
    if (!(off <= largest)) largest = off;
  }
  accept(peer.name + " at its keys", largest, through_keys_limit);
}

}  // namespace orispline::bench
