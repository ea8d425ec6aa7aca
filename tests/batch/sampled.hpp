// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <vector>

#include <orispline/batch/sample.hpp>

namespace orispline::testing_support {

/// What is asked of a sample.
enum class Wanted { orientation, velocity, acceleration, jerk };

/// Memory for samples, and how to read them again in either layout.
template <class T>
class Sampled {
 public:
  Sampled(std::size_t count, Wanted wanted, Layout layout = Layout::interleaved)
      : count_(count),
        layout_(layout),
        orientations_(4 * count),
        velocities_(wanted >= Wanted::velocity ? 3 * count : 0),
        accelerations_(wanted >= Wanted::acceleration ? 3 * count : 0),
        jerks_(wanted >= Wanted::jerk ? 3 * count : 0) {}

  [[nodiscard]] Samples<T> spans() {
    return {.orientations = orientations_,
            .angular_velocities = velocities_,
            .angular_accelerations = accelerations_,
            .angular_jerks = jerks_,
            .layout = layout_};
  }

  [[nodiscard]] Eigen::Vector4d orientation(std::size_t i) const { return read<4>(orientations_, i); }
  [[nodiscard]] Eigen::Vector3d velocity(std::size_t i) const { return read<3>(velocities_, i); }
  [[nodiscard]] Eigen::Vector3d acceleration(std::size_t i) const { return read<3>(accelerations_, i); }
  [[nodiscard]] Eigen::Vector3d jerk(std::size_t i) const { return read<3>(jerks_, i); }

  /// Equal in every bit, NaN as well.
  [[nodiscard]] bool same_bits(const Sampled& other) const {
    return same_bits(orientations_, other.orientations_) && same_bits(velocities_, other.velocities_) &&
           same_bits(accelerations_, other.accelerations_) && same_bits(jerks_, other.jerks_);
  }

 private:
  static bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), sizeof(T) * a.size()) == 0);
  }

  template <int Components>
  [[nodiscard]] Eigen::Matrix<double, Components, 1> read(const std::vector<T>& from, std::size_t i) const {
    Eigen::Matrix<double, Components, 1> v = Eigen::Matrix<double, Components, 1>::Zero();
    if (from.empty()) return v;
    for (std::size_t k = 0; k < Components; ++k)
      v[static_cast<Eigen::Index>(k)] =
          static_cast<double>(layout_ == Layout::planar ? from[k * count_ + i] : from[Components * i + k]);
    return v;
  }

  std::size_t count_;
  Layout layout_;
  std::vector<T> orientations_, velocities_, accelerations_, jerks_;
};

}  // namespace orispline::testing_support
