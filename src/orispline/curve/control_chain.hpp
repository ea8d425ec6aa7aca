// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/curve/chain.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/slerp.hpp>

namespace orispline {

/// The unknowns of curves that pass through their keys by way of control orientations, one for each key: what is common
/// to their chains of equations. A step turns a control orientation about its own axes: p ← p exp(step).
class ControlChain {
 public:
  /// The keys with increments of `share` times their length; the controls as far from them as those of `before`, or on
  /// them.
  template <class Chain>
  ControlChain(const Keyframes& keys, double share, const Chain* before) {
    const auto q = keys.orientations();
    keys_.push_back(q[0]);
    for (std::size_t i = 0; i + 1 < q.size(); ++i)
      keys_.push_back(share == 1.0 ? q[i + 1] : keys_[i] * exp<double>(share * increment<double>(q[i], q[i + 1])));
    controls_ = keys_;
    if (!before) return;
    for (std::size_t i = 0; i < keys_.size(); ++i)
      controls_[i] = keys_[i] * before->template key<double>(i).conjugate() * before->controls()[i];
  }

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] bool closed() const { return false; }
  [[nodiscard]] bool plausible() const { return true; }
  [[nodiscard]] const std::vector<Eigen::Quaterniond>& controls() const { return controls_; }
  template <Number T>
  [[nodiscard]] Quaternion<T> key(std::size_t i) const {
    return constant<T>(keys_[i]);
  }

  void move(std::span<const Eigen::Vector3d> by) {
    for (std::size_t i = 0; i < by.size(); ++i) controls_[i] = (controls_[i] * exp<double>(by[i])).normalized();
  }

 protected:
  /// The controls moved by a step each.
  template <Number T>
  [[nodiscard]] std::vector<Quaternion<T>> moved(std::span<const Vector3<T>> by) const {
    std::vector<Quaternion<T>> all;
    all.reserve(by.size());
    for (std::size_t i = 0; i < by.size(); ++i) all.push_back(constant<T>(controls_[i]) * exp<T>(by[i]));
    return all;
  }

 private:
  std::vector<Eigen::Quaterniond> keys_, controls_;
};

}  // namespace orispline
