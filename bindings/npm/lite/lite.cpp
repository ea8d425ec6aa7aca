// SPDX-License-Identifier: Apache-2.0
// The part of bindings/c/orispline.h that the small package holds, for a script that passes neither null nor what was
// freed.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>

#include "orispline.h"

using namespace orispline;

struct orispline_error {
  Error error;
};
struct orispline_keys {
  Keyframes keys;
};
struct orispline_curve {
  PoseCurve curve;
};

namespace {

using Quaternions = std::vector<Eigen::Quaterniond>;
using Vectors = std::vector<Eigen::Vector3d>;

/// The header counts them in the same order, from 1.
orispline_code code_of(const Error& error) { return static_cast<orispline_code>(error.code) + 1; }

orispline_code failed(Error error, orispline_error** to) {
  const orispline_code code = code_of(error);
  *to = new orispline_error{std::move(error)};
  return code;
}

Quaternions quaternions(const double* q, std::size_t count, orispline_order order) {
  Quaternions rows;
  for (std::size_t i = 0; i < count; ++i, q += 4)
    rows.push_back(order == ORISPLINE_WXYZ ? Eigen::Quaterniond(q[0], q[1], q[2], q[3])
                                           : Eigen::Quaterniond(q[3], q[0], q[1], q[2]));
  return rows;
}

Vectors vectors(const double* v, std::size_t count) {
  Vectors rows;
  for (std::size_t i = 0; i < count; ++i, v += 3) rows.emplace_back(v[0], v[1], v[2]);
  return rows;
}

void put(const Eigen::Quaterniond& q, orispline_order order, double* to) {
  const std::size_t vector = order == ORISPLINE_WXYZ ? 1 : 0;
  to[order == ORISPLINE_WXYZ ? 0 : 3] = q.w();
  to[vector] = q.x();
  to[vector + 1] = q.y();
  to[vector + 2] = q.z();
}

void put(const Eigen::Vector3d& v, double* to) { std::copy_n(v.data(), 3, to); }

std::int64_t number_or_none(std::optional<std::size_t> number) {
  return number ? static_cast<std::int64_t>(*number) : -1;
}

}  // namespace

int32_t orispline_abi() { return ORISPLINE_C_ABI; }

orispline_code orispline_error_code(const orispline_error* e) { return code_of(e->error); }
const char* orispline_error_message(const orispline_error* e) { return e->error.message.c_str(); }
const char* orispline_error_option(const orispline_error* e) { return e->error.option.c_str(); }
const char* orispline_error_remedy(const orispline_error* e) { return e->error.remedy.c_str(); }
int64_t orispline_error_key(const orispline_error* e) { return number_or_none(e->error.where.key); }
void orispline_error_free(orispline_error* e) { delete e; }

orispline_code orispline_keys_make(const double* times, const double* orientations, size_t count, orispline_order order,
                                   orispline_signs signs, const orispline_column* columns, size_t column_count,
                                   orispline_keys** keys, orispline_error** error) {
  KeyframeData data{.times = {times, times + count}, .orientations = quaternions(orientations, count, order)};
  for (const orispline_column& column : std::span(columns, column_count)) {
    const std::string_view name = column.name;
    if (name == "positions") data.positions = vectors(column.numbers, count);
    if (name == "angular_velocities") data.angular_velocities = vectors(column.numbers, count);
    if (name == "angular_accelerations") data.angular_accelerations = vectors(column.numbers, count);
    if (name == "angular_jerks") data.angular_jerks = vectors(column.numbers, count);
  }
  auto made = Keyframes::make(std::move(data), signs == ORISPLINE_AS_GIVEN ? Signs::as_given : Signs::shortest);
  if (!made) return failed(std::move(made.error()), error);
  *keys = new orispline_keys{std::move(*made)};
  return ORISPLINE_OK;
}
void orispline_keys_free(orispline_keys* keys) { delete keys; }

orispline_code orispline_curve_make(const orispline_keys* keys, const char* method, orispline_curve** curve,
                                    orispline_error** error) {
  auto made = method_from_text(method).and_then([&](const Method& m) { return make_pose_curve(m, keys->keys); });
  if (!made) return failed(std::move(made.error()), error);
  *curve = new orispline_curve{std::move(*made)};
  return ORISPLINE_OK;
}
void orispline_curve_free(orispline_curve* curve) { delete curve; }

orispline_code orispline_curve_domain(const orispline_curve* c, double* start, double* end, orispline_error**) {
  const Domain domain = c->curve.orientation.domain();
  *start = domain.start;
  *end = domain.end;
  return ORISPLINE_OK;
}

int32_t orispline_curve_has_positions(const orispline_curve* c) { return c->curve.position.has_value(); }

orispline_code orispline_curve_orientation(const orispline_curve* c, double time, orispline_order order, double* to,
                                           orispline_error**) {
  put(c->curve.orientation(time), order, to);
  return ORISPLINE_OK;
}

orispline_code orispline_curve_motion(const orispline_curve* c, double time, orispline_side side, orispline_order order,
                                      orispline_motion* to, orispline_error**) {
  const Side at = side == ORISPLINE_LEFT ? Side::left : Side::right;
  const Motion m = c->curve.orientation.motion(time, at);
  put(m.orientation, order, to->orientation);
  put(m.angular_velocity, to->angular_velocity);
  put(m.angular_acceleration, to->angular_acceleration);
  put(m.angular_jerk, to->angular_jerk);
  if (!c->curve.position) return ORISPLINE_OK;
  const LinearMotion p = c->curve.position->linear_motion(time, at);
  put(p.position, to->position);
  put(p.velocity, to->velocity);
  put(p.acceleration, to->acceleration);
  put(p.jerk, to->jerk);
  return ORISPLINE_OK;
}
