// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh/writer.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/math/continuous_euler.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/eigen.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

/// The turns of a joint over the frames.
struct JointAngles {
  std::vector<double> degrees{};         ///< of each frame, in the order of the turns
  std::vector<std::size_t> near_lock{};  ///< frames within 1° of gimbal lock
};

constexpr double same_rotation = 1e-9;  // [rad]
constexpr double near_lock = 1.0 * radians_per_degree;

double handedness_of(int i, int j) { return (j - i + 3) % 3 == 1 ? 1.0 : -1.0; }

/// The turns about two different axes that come nearest to a rotation: with half angles α, β and e_i × e_j = ε e_k,
/// (w, q_i) = cos β (cos α, sin α) and (q_j, ε q_k) = sin β (cos α, sin α).
std::array<double, 2> two_turns(int i, int j, const Eigen::Quaterniond& q) {
  const double w = q.w(), x = q.vec()[i], y = q.vec()[j], z = handedness_of(i, j) * q.vec()[3 - i - j];
  const double first = w * w + x * x >= y * y + z * z ? atan2_of(x, w) : atan2_of(z, y);
  const auto [sine, cosine] = elementary::sine_cosine(first);
  return {2.0 * first, 2.0 * atan2_of(y * cosine + z * sine, w * cosine + x * sine)};
}

bool makes(std::span<const int> turns, std::span<const double> angles, const Eigen::Quaterniond& wanted) {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < turns.size(); ++i) q = q * exp<double>(angles[i] * Eigen::Vector3d::Unit(turns[i]));
  return angular_distance(q, wanted) <= same_rotation;
}

std::optional<JointAngles> fewer_turns(std::span<const int> turns, std::span<const Eigen::Quaterniond> rotations,
                                       std::span<const double> start) {
  if (turns.size() == 2 && turns[0] == turns[1]) return std::nullopt;
  JointAngles found;
  found.degrees.reserve(rotations.size() * turns.size());
  std::array before{0.0, 0.0};
  for (std::size_t i = 0; i < start.size(); ++i) before[i] = start[i] * radians_per_degree;
  for (const Eigen::Quaterniond& q : rotations) {
    const std::array angles = turns.size() == 2 ? two_turns(turns[0], turns[1], q)
                                                : std::array{2.0 * atan2_of(q.vec()[turns[0]], q.w()), 0.0};
    if (!makes(turns, angles, q)) return std::nullopt;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      before[i] = nearest_angle(angles[i], before[i]);
      found.degrees.push_back(before[i] * degrees);
    }
  }
  return found;
}

JointAngles three_turns(const EulerOrder& order, std::span<const Eigen::Quaterniond> rotations,
                        std::span<const double> start) {
  const ContinuousEuler turns(order);
  JointAngles found;
  found.degrees.reserve(rotations.size() * 3);
  Eigen::Vector3d before = euler_angles(order, rotations.front());
  if (start.size() == 3) before = Eigen::Vector3d(start[0], start[1], start[2]) * radians_per_degree;
  for (std::size_t k = 0; k < rotations.size(); ++k) {
    before = turns.after(before, rotations[k]);
    if (turns.lock_distance(before) <= near_lock) found.near_lock.push_back(k);
    for (const double angle : before) found.degrees.push_back(angle * degrees);
  }
  return found;
}

/// The angles of turns about these axes of the body (0 x, 1 y, 2 z), each frame's the nearest to those of the frame
/// before, the first frame's to `start` [°], where there is one.
///
/// Nothing where the turns do not make the rotations: fewer than three, or more, or an axis twice in succession.
std::optional<JointAngles> angles_of(std::span<const int> turns, std::span<const Eigen::Quaterniond> rotations,
                                     std::span<const double> start) {
  if (turns.size() == 1 || turns.size() == 2) return fewer_turns(turns, rotations, start);
  if (turns.size() != 3 || turns[0] == turns[1] || turns[1] == turns[2]) return std::nullopt;
  return three_turns({.turns = {turns[0], turns[1], turns[2]}}, rotations, start);
}

constexpr double same_turn = 1e-12;  // [rad]

template <CurvePoint P>
std::vector<const Channel<P>*> by_joint(const std::vector<Channel<P>>& channels, std::size_t joints) {
  std::vector<const Channel<P>*> found(joints);
  for (const Channel<P>& channel : channels) found[channel.joint] = &channel;
  return found;
}

template <CurvePoint P>
std::vector<P> values_at(std::span<const double> times, const Channel<P>* channel, const P& rest) {
  if (!channel) return std::vector<P>(times.size(), rest);
  const ChannelCurve<P> curve(*channel);
  std::vector<P> values;
  values.reserve(times.size());
  for (const double time : times) values.push_back(curve.at(time));
  return values;
}

std::vector<Column> columns_of_kind(std::span<const Column> columns, Column::Kind kind) {
  std::vector<Column> found;
  for (const Column& column : columns)
    if (column.kind == kind) found.push_back(column);
  return found;
}

std::vector<int> axes_of(std::span<const Column> columns) {
  std::vector<int> axes;
  for (const Column& column : columns) axes.push_back(column.axis);
  return axes;
}

/// The columns that say all translations: those planned if the other coordinates stay at rest.
std::vector<Column> enough_positions(std::vector<Column> planned, std::span<const Eigen::Vector3d> translations,
                                     const Eigen::Vector3d& rest) {
  for (const Column& column : position_columns()) {
    if (std::ranges::find(planned, column) != planned.end()) continue;
    const auto stays = [&](const Eigen::Vector3d& at) { return at[column.axis] == rest[column.axis]; };
    if (!std::ranges::all_of(translations, stays)) return position_columns();
  }
  return planned;
}

}  // namespace

struct NumberFinder::Track {
  std::vector<Eigen::Quaterniond> rotations{};
  std::vector<Eigen::Vector3d> translations{};
};

NumberFinder::NumberFinder(const Skeleton& skeleton, const Clip& clip, const Frames& frames, const Source* source)
    : skeleton_(skeleton),
      clip_(clip),
      frames_(frames),
      source_(source),
      rotations_(by_joint(clip.rotations, skeleton.size())),
      translations_(by_joint(clip.translations, skeleton.size())) {
  if (!source) return;
  std::size_t columns = 0;
  for (const WrittenJoint& joint : source->joints)
    first_columns_.push_back(std::exchange(columns, columns + joint.columns.size()));
}

Expected<NumberFinder::Track> NumberFinder::track_of(std::size_t joint) const {
  const JointPose& rest = skeleton_[joint].rest;
  Track track{values_at(frames_.times, rotations_[joint], rest.rotation),
              values_at(frames_.times, translations_[joint], rest.translation)};
  for (std::size_t k = 0; k < track.rotations.size(); ++k) {
    track.rotations[k].normalize();
    if (!track.rotations[k].coeffs().allFinite())
      return failure(ErrorCode::bad_data, formatted("{}: found no rotation at {} s, wanted keys and tangents that do "
                                                    "not cancel each other",
                                                    place_of(skeleton_, clip_, joint), frames_.times[k]));
  }
  return track;
}

std::vector<double> NumberFinder::source_angles(std::size_t joint, const Track& track) const {
  if (source_->frames != track.rotations.size()) return {};
  const std::vector<Column>& columns = source_->joints[joint].columns;
  const std::size_t stride = source_->numbers.size() / source_->frames;
  const double* numbers = source_->numbers.data() + first_columns_[joint];
  std::vector<double> angles;
  for (const Eigen::Quaterniond& rotation : track.rotations) {
    if (angular_distance(rotation_of(columns, numbers), rotation) > same_turn) return {};
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].kind == Column::Kind::rotation) angles.push_back(numbers[i]);
    numbers += stride;
  }
  return angles;
}

JointNumbers NumberFinder::turns_of(const PlannedJoint& planned, const Track& track, const EulerOrder& order) const {
  constexpr auto rotation = Column::Kind::rotation;
  std::vector<Column> columns = columns_of_kind(planned.written.columns, rotation);
  const auto is_none = [](const Eigen::Quaterniond& q) {
    return angular_distance(q, Eigen::Quaterniond::Identity()) <= same_turn;
  };
  if (columns.empty() && std::ranges::all_of(track.rotations, is_none)) return {};
  std::vector<double> start;
  if (source_ && columns == columns_of_kind(source_->joints[planned.joint].columns, rotation)) {
    if (auto angles = source_angles(planned.joint, track); !angles.empty()) return {columns, std::move(angles), {}};
    const std::vector<Column>& all = source_->joints[planned.joint].columns;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].kind == rotation) start.push_back(source_->numbers[first_columns_[planned.joint] + i]);
  }
  auto angles = angles_of(axes_of(columns), track.rotations, start);
  if (!angles) {
    columns = columns_of(order);
    angles = angles_of(axes_of(columns), track.rotations, {});
  }
  return {columns, std::move(angles->degrees), std::move(angles->near_lock)};
}

Expected<JointNumbers> NumberFinder::of(const PlannedJoint& planned, const EulerOrder& order) const {
  if (planned.joint == no_parent) return JointNumbers{};
  const auto track = track_of(planned.joint);
  if (!track) return tl::unexpected(track.error());
  constexpr auto position = Column::Kind::position;
  const auto positions = enough_positions(columns_of_kind(planned.written.columns, position), track->translations,
                                          skeleton_[planned.joint].rest.translation);
  JointNumbers turns = turns_of(planned, *track, order);
  std::vector<Column> columns = planned.written.columns;
  if (positions != columns_of_kind(columns, position) ||
      turns.columns != columns_of_kind(columns, Column::Kind::rotation)) {
    columns = positions;
    columns.insert(columns.end(), turns.columns.begin(), turns.columns.end());
  }
  JointNumbers found{.columns = columns, .near_lock = std::move(turns.near_lock)};
  found.numbers.reserve(columns.size() * frames_.times.size());
  auto angle = turns.numbers.begin();
  for (const Eigen::Vector3d& translation : track->translations)
    for (const Column& column : columns)
      found.numbers.push_back(column.kind == position ? translation[column.axis] : *angle++);
  return found;
}

}}}  // namespace orispline::scenes::bvh
