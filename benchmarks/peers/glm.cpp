// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <peers/peers.hpp>
#include <peers/search.hpp>

namespace orispline::bench {

namespace {

template <class T>
using Quaternion = glm::qua<T, glm::defaultp>;

template <class T>
Peer<T> slerp(const Track& track) {
  std::vector<Quaternion<T>> keys;
  for (std::size_t i = 0; i < track.keys(); ++i) {
    const double* q = &track.orientations[4 * i];
    keys.emplace_back(static_cast<T>(q[3]), static_cast<T>(q[0]), static_cast<T>(q[1]), static_cast<T>(q[2]));
  }
  return {"glm slerp", Shape::slerp,
          [times = track.times, keys = std::move(keys)](std::span<const double> at, std::span<T> out) {
            for (std::size_t k = 0; k < at.size(); ++k) {
              const auto [i, u] = search(times, at[k]);
              const Quaternion<T> q = glm::slerp(keys[i], keys[i + 1], static_cast<T>(u));
              const T components[4] = {q.x, q.y, q.z, q.w};
              std::memcpy(&out[4 * k], components, sizeof components);
            }
          }};
}

}  // namespace

std::vector<Peer<double>> glm_peers(const Track& track) { return {slerp<double>(track)}; }
std::vector<Peer<float>> glm_float_peers(const Track& track) { return {slerp<float>(track)}; }

}  // namespace orispline::bench
