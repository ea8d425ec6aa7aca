// SPDX-License-Identifier: Apache-2.0
// In place of samples.cpp, for packages without samples in bulk: motion after motion, in one thread.
#include <limits>

#include "curve.hpp"
#include "errors.hpp"
#include "keys.hpp"
#include "outputs.hpp"

namespace orispline::c {

class Sampler {};

std::shared_ptr<const Sampler> sampler_of(const PoseCurve&) { return nullptr; }

namespace {

struct Sample {
  Motion motion;
  LinearMotion linear;
};

Eigen::Vector3d vector_of(const Sample& sample, orispline_quantity quantity) {
  switch (quantity) {
    case ORISPLINE_ANGULAR_VELOCITY:
      return sample.motion.angular_velocity;
    case ORISPLINE_ANGULAR_ACCELERATION:
      return sample.motion.angular_acceleration;
    case ORISPLINE_ANGULAR_JERK:
      return sample.motion.angular_jerk;
    case ORISPLINE_ANGULAR_VELOCITY_WORLD:
      return angular_velocity_world(sample.motion);
    case ORISPLINE_ANGULAR_ACCELERATION_WORLD:
      return angular_acceleration_world(sample.motion);
    case ORISPLINE_ANGULAR_JERK_WORLD:
      return angular_jerk_world(sample.motion);
    case ORISPLINE_POSITION:
      return sample.linear.position;
    case ORISPLINE_VELOCITY:
      return sample.linear.velocity;
    default:
      return sample.linear.acceleration;
  }
}

template <class T>
void put(const orispline_output& output, std::size_t k, const Sample& sample, orispline_order order) {
  T* const to = static_cast<T*>(output.numbers) + stride_of(output) * k;
  if (output.quantity == ORISPLINE_ORIENTATION) return put_quaternion(to, sample.motion.orientation, order);
  const Eigen::Vector3d v = vector_of(sample, output.quantity);
  for (int i = 0; i < 3; ++i) to[i] = static_cast<T>(v[i]);
}

Expected<void> check_positions(const PoseCurve& pose, Outputs outputs) {
  for (const orispline_output& output : outputs)
    if (is_of_position(output.quantity) && !pose.position)
      return bad_option("quantity", "these keys have no positions, wanted some");
  return {};
}

Expected<void> fill(const PoseCurve& pose, const Times& times, orispline_order order, Extrapolation beyond,
                    Outputs outputs) {
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double t = times[k];
    if (beyond == Extrapolation::error)
      if (auto inside = pose.orientation.checked_motion(t); !inside && !(t != t)) {
        inside.error().where.time_index = k;
        return tl::unexpected(std::move(inside.error()));
      }
    const Sample sample{extrapolated(pose.orientation, t, beyond),
                        pose.position ? extrapolated(*pose.position, t, beyond) : LinearMotion{}};
    for (const orispline_output& output : outputs)
      if (output.type == ORISPLINE_FLOAT) put<float>(output, k, sample, order);
      else put<double>(output, k, sample, order);
  }
  return {};
}

Expected<void> sample_all(const orispline_curve* curve, const Times& times, orispline_order order, const char* beyond,
                          const orispline_output* outputs, std::size_t output_count) {
  const auto body = checked(curve);
  if (!body) return tl::unexpected(body.error());
  const auto wanted = outputs_in(outputs, output_count, order, times.size());
  if (!wanted) return tl::unexpected(wanted.error());
  return check_positions((*body)->pose, *wanted).and_then([&] { return extrapolation_named(beyond); })
      .and_then([&](Extrapolation how) { return fill((*body)->pose, times, order, how, *wanted); });
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_sample_even(const orispline_curve* curve, double start, double step, size_t count,
                                     orispline_order order, const char* beyond, uint32_t,
                                     const orispline_output* outputs, size_t output_count, orispline_error** error) {
  return guarded(error, [&] {
    return check_even(start, step).and_then([&] {
      return sample_all(curve, Times(start, step, count), order, beyond, outputs, output_count);
    });
  });
}

orispline_code orispline_sample_at(const orispline_curve* curve, const double* times, size_t count,
                                   orispline_order order, const char* beyond, uint32_t,
                                   const orispline_output* outputs, size_t output_count, orispline_error** error) {
  return guarded(error, [&] {
    return (count == 0 ? Expected<void>() : check_pointer(times, "times")).and_then([&] {
      return sample_all(curve, Times(std::span(times, count)), order, beyond, outputs, output_count);
    });
  });
}
