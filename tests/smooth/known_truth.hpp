// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <orispline/io/key_file.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

#include "smooth/noisy_motion.hpp"

namespace orispline::known_truth {

using testing_support::pi;

/// A motion that is taken for the truth.
struct Truth {
  std::string name{};
  KeyframeData data{};
};

/// What the rate does at a strike.
enum class Strike {
  pulse,  ///< rises and falls back: the orientation steps
  step,   ///< rises, and falls back three times as slowly later
  ring,   ///< rises, falls and returns: the orientation jerks and comes back; of 45 ms or more, for less is one sample
};

namespace detail {

/// ∫ of a ramp from 0 to 1 over `width`, of sin² shape.
inline double ramp(double u, double width) {
  if (u <= 0.0) return 0.0;
  if (u >= width) return u - 0.5 * width;
  return 0.5 * u - width / (2.0 * pi) * std::sin(pi * u / width);
}

/// The angle of a strike that began u ago, whose rate changes by 1 within `width`.
inline double strike_angle(Strike kind, double u, double width) {
  switch (kind) {
    case Strike::pulse:
      return ramp(u, 0.5 * width) - ramp(u - 0.5 * width, 0.5 * width);
    case Strike::step:
      return ramp(u, width) - ramp(u - width - 0.05, 3.0 * width);
    case Strike::ring:
      break;
  }
  const double third = width / 3.0;
  return ramp(u, third) - 2.0 * ramp(u - third, third) + ramp(u - 2.0 * third, third);
}

}  // namespace detail

/// Sums of sines at 120 Hz; once a second a strike of 20 to 60 ms in which the rate changes by 2 to 10 rad/s about a
/// random axis, to and fro in turn.
inline Truth gait(std::uint64_t seed, Strike kind, std::size_t samples = 1200) {
  Dice dice(1000 + seed);
  Eigen::Vector3d amplitudes[3], phases[3], axes[2] = {dice.vector().normalized(), dice.vector().normalized()};
  for (int k = 0; k < 3; ++k) {
    amplitudes[k] = dice.vector() * 0.6 / (1.0 + k);
    phases[k] = pi * dice.vector();
  }
  struct Event {
    double time, width, change;
  };
  std::vector<Event> events;
  const double end = static_cast<double>(samples) / 120.0;
  for (double t = 0.5; t < end; t += 1.0) {
    const double jitter = dice.between(-0.1, 0.1), width = dice.between(kind == Strike::ring ? 0.045 : 0.02, 0.06),
                 change = dice.between(2.0, 10.0);
    events.push_back({t + jitter, width, events.size() % 2 == 0 ? change : -change});
  }
  Truth truth{.name = "gait" + std::to_string(static_cast<int>(kind)) + "/" + std::to_string(seed)};
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / 120.0;
    Eigen::Vector3d turn = Eigen::Vector3d::Zero(), strikes = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        turn[axis] += amplitudes[k][axis] * std::sin(2.0 * pi * (k + 1) * 0.9 * t + phases[k][axis]);
    for (std::size_t e = 0; e < events.size(); ++e)
      strikes += axes[e / 2 % 2] * events[e].change * detail::strike_angle(kind, t - events[e].time, events[e].width);
    truth.data.times.push_back(t);
    truth.data.orientations.push_back(exp<double>(turn) * exp<double>(strikes));
  }
  return truth;
}

/// The rotations of every joint of a BVH file, each against its parent.
inline std::vector<Truth> bvh_joints(const std::string& path) {
  std::ifstream file(path);
  std::vector<Truth> joints;
  std::vector<std::vector<std::string>> channels;
  double interval = 0.0;
  std::string word;
  while (file >> word && word != "Time:") {
    if (word == "ROOT" || word == "JOINT") {
      file >> word;
      joints.push_back({.name = "bvh/" + word});
    } else if (word == "CHANNELS") {
      std::size_t count = 0;
      file >> count;
      auto& names = channels.emplace_back(count);
      for (std::string& name : names) file >> name;
    }
  }
  file >> interval;
  double value = 0.0;
  for (std::size_t frame = 0;; ++frame) {
    for (std::size_t j = 0; j < joints.size(); ++j) {
      Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
      for (const std::string& name : channels[j]) {
        if (!(file >> value)) {
          for (Truth& joint : joints) joint.data.orientations.resize(joint.data.times.size());
          return joints;
        }
        if (!name.ends_with("rotation")) continue;
        q = q * exp<double>(Eigen::Vector3d(value * degree * Eigen::Vector3d::Unit(name[0] - 'X')));
      }
      joints[j].data.orientations.push_back(q.normalized());
    }
    for (Truth& joint : joints) joint.data.times.push_back(interval * static_cast<double>(frame));
  }
}

/// Noise of σ [rad] per axis in the body frame; a share of the samples turns by 20° more.
inline KeyframeData disturbed(const KeyframeData& truth, double noise, std::uint64_t seed, double outliers = 0.0) {
  std::mt19937_64 engine(seed * 7919 + 17);
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * pi * uniform()); };
  const auto vector = [&] {
    const double x = normal(), y = normal(), z = normal();
    return Eigen::Vector3d(x, y, z);
  };
  KeyframeData noisy{.times = truth.times};
  for (const Eigen::Quaterniond& q : truth.orientations) {
    Eigen::Quaterniond there = q * exp<double>(Eigen::Vector3d(noise * vector()));
    if (outliers > 0.0 && uniform() < outliers)
      there = there * exp<double>(Eigen::Vector3d(20.0 * degree * vector().normalized()));
    noisy.orientations.push_back(there.normalized());
  }
  return noisy;
}

/// σ per axis [rad] from the third differences, as if times were even, of which each has √20 times the noise: by their
/// median, so that single quick turns are no noise.
inline double own_noise(const KeyframeData& data) {
  const auto& q = data.orientations;
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 3 < q.size(); ++i) {
    const Eigen::Vector3d a = shortest_increment(q[i], q[i + 1]), b = shortest_increment(q[i + 1], q[i + 2]),
                          c = shortest_increment(q[i + 2], q[i + 3]);
    lengths.push_back((c - 2.0 * b + a).norm());
  }
  return median(std::move(lengths)) / (median_length * std::sqrt(20.0));
}

inline double rms_between(const std::vector<Eigen::Quaterniond>& found, const std::vector<Eigen::Quaterniond>& wanted) {
  double sum = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double d = angular_distance(found[i], wanted[i]);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(wanted.size()));
}

/// The recordings that are read as they are: flight, sensor, camera, spacecraft.
inline std::vector<Truth> recordings(const std::string& folder) {
  std::vector<Truth> truths;
  const auto add = [&](const char* name, const std::string& file, const io::ReadOptions& options) {
    auto read = io::read_keys(folder + "/" + file, options);
    if (!read) return;
    KeyframeData data{.times = std::move(read->data.times), .orientations = std::move(read->data.orientations)};
    for (Eigen::Quaterniond& q : data.orientations) q.normalize();
    truths.push_back({name, std::move(data)});
  };
  add("px4", "flight/px4_quad_sample_attitude.csv", {});
  add("broad", "imu/broad_06_undisturbed_fast_rotation_A_40s.csv",
      {.columns = {{"qw", "opt_qw"}, {"qx", "opt_qx"}, {"qy", "opt_qy"}, {"qz", "opt_qz"}}, .drop_invalid = true});
  add("tum", "trajectory/tum_fr2_desk_groundtruth.txt", {.drop_duplicates = true});
  add("mro", "spacecraft/mro_ck_sliced_-74000.csv",
      {.columns = {{"t", "sclk_ticks"}, {"qw", "q0_w"}, {"qx", "q1"}, {"qy", "q2"}, {"qz", "q3"}},
       .time_scale = Decimal::parse("0.00390625").value(),
       .conjugate = true});
  return truths;
}

}  // namespace orispline::known_truth
