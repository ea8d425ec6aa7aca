// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include <orispline/batch/pose_sampler.hpp>

#include "keys.hpp"
#include "outputs.hpp"

// Samples in bulk, made block by block where the caller wants them.

namespace orispline::c {

/// The outputs of one type whose rates are in one frame.
template <class T>
class Blocks {
 public:
  Blocks(Outputs outputs, orispline_order order, RateFrame frame) : order_(order), frame_(frame) {
    constexpr orispline_type type = std::is_same_v<T, double> ? ORISPLINE_DOUBLE : ORISPLINE_FLOAT;
    for (const orispline_output& output : outputs)
      if (output.type == type)
        outputs_.push_back({slot_of(output.quantity), stride_of(output), static_cast<T*>(output.numbers)});
  }

  /// Makes all samples by `sample(times, samples, frame)`.
  template <class Sample>
  [[nodiscard]] Expected<void> fill(const Times& times, Work work, Sample sample) {
    if (outputs_.empty()) return {};
    std::vector<double> room;
    return in_blocks(times.size(), work, [&](std::size_t begin, std::size_t count) {
      return sample(times.part(begin, count, room), samples_at(begin, count), frame_).map([&] {
        hand_out(begin, count);
      });
    });
  }

 private:
  static constexpr std::size_t slots = 7;  // the orientation, its three rates, the position and its two

  struct Output {
    std::size_t slot, stride;
    T* numbers;

    [[nodiscard]] bool is_dense() const noexcept { return stride == width_of_slot(slot); }
  };

  [[nodiscard]] static constexpr std::size_t width_of_slot(std::size_t slot) noexcept { return slot == 0 ? 4 : 3; }
  [[nodiscard]] static constexpr std::size_t slot_of(orispline_quantity quantity) noexcept {
    return static_cast<std::size_t>(quantity >= ORISPLINE_ANGULAR_VELOCITY_WORLD ? quantity - 3 : quantity);
  }

  /// What is made of a slot lies where the first dense output wants it, else in a room of ours.
  [[nodiscard]] Samples<T> samples_at(std::size_t begin, std::size_t count) {
    made_ = {};
    for (const Output& output : outputs_)
      if (output.is_dense() && made_[output.slot].empty()) {
        const std::size_t width = width_of_slot(output.slot);
        made_[output.slot] = {output.numbers + width * begin, width * count};
      }
    const auto make_room = [&](std::size_t slot) {
      if (!made_[slot].empty()) return;
      rooms_[slot].resize(width_of_slot(slot) * count);
      made_[slot] = rooms_[slot];
    };
    make_room(0);
    for (const Output& output : outputs_) make_room(output.slot);
    if (frame_ == RateFrame::world && !made_[3].empty()) make_room(1), make_room(2);
    return {.orientations = made_[0],
            .angular_velocities = made_[1],
            .angular_accelerations = made_[2],
            .angular_jerks = made_[3],
            .positions = made_[4],
            .velocities = made_[5],
            .accelerations = made_[6]};
  }

  void hand_out(std::size_t begin, std::size_t count) const noexcept {
    for (const Output& output : outputs_) {
      T* to = output.numbers + output.stride * begin;
      const T* from = made_[output.slot].data();
      if (to == from) continue;
      for (std::size_t k = 0; k < count; ++k, to += output.stride, from += width_of_slot(output.slot))
        if (output.slot == 0) put_quaternion(to, Eigen::Map<const Eigen::Quaternion<T>>(from), order_);
        else std::copy_n(from, 3, to);
    }
    for (const Output& output : outputs_)
      if (T* q = output.numbers + 4 * begin; output.slot == 0 && q == made_[0].data() && order_ == ORISPLINE_WXYZ)
        for (std::size_t k = 0; k < count; ++k, q += 4) std::rotate(q, q + 3, q + 4);
  }

  std::vector<Output> outputs_;
  orispline_order order_;
  RateFrame frame_;
  std::array<std::vector<T>, slots> rooms_;
  std::array<std::span<T>, slots> made_{};
};

/// All outputs of a type: in one go, unless rates are wanted in both frames.
template <class T, class Sample>
[[nodiscard]] Expected<void> fill_all(Outputs outputs, orispline_order order, const Times& times, Work work,
                                      Sample sample) {
  std::vector<orispline_output> of_body, of_world;
  const auto is_body_rate = [](const orispline_output& output) {
    return output.quantity >= ORISPLINE_ANGULAR_VELOCITY && output.quantity <= ORISPLINE_ANGULAR_JERK;
  };
  const bool turns_all = std::ranges::none_of(outputs, is_body_rate);
  for (const orispline_output& output : outputs)
    (turns_all || is_of_world(output.quantity) ? of_world : of_body).push_back(output);
  return Blocks<T>(of_body, order, RateFrame::body).fill(times, work, sample).and_then([&] {
    return Blocks<T>(of_world, order, RateFrame::world).fill(times, work, sample);
  });
}

}  // namespace orispline::c
