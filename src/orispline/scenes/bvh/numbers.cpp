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
#include <orispline/math/so3.hpp>
#include <orispline/scenes/bvh/turns.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

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

/// Angles of a file [°] that are those found but for full turns keep their digits.
void take_digits(std::span<const double> of_file, std::span<double> found) {
  constexpr double full = 360.0, rounding = 1e-9;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double same = of_file[i] + full * std::round((found[i] - of_file[i]) / full);
    if (std::abs(found[i] - same) <= rounding) found[i] = same;
  }
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

NumberFinder::NumberFinder(const Skeleton& skeleton, const Clip& clip, const Frames& frames, const Source* source,
                           SourceAngles kept)
    : skeleton_(skeleton),
      clip_(clip),
      frames_(frames),
      source_(source),
      kept_(kept),
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
  std::vector<double> start, of_source;
  if (source_ && columns == columns_of_kind(source_->joints[planned.joint].columns, rotation)) {
    of_source = source_angles(planned.joint, track);
    if (!of_source.empty() && kept_ == SourceAngles::all) return {.columns = columns, .numbers = std::move(of_source)};
    const std::vector<Column>& all = source_->joints[planned.joint].columns;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].kind == rotation) start.push_back(source_->numbers[first_columns_[planned.joint] + i]);
  }
  auto angles = angles_of(columns, track.rotations, start);
  if (!angles) {
    columns = columns_of(order);
    angles = angles_of(columns, track.rotations, {});
  } else if (!of_source.empty()) {
    take_digits(of_source, angles->degrees);
  }
  return {columns, std::move(angles->degrees), std::move(angles->near_lock), angles->detour};
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
  JointNumbers found{.columns = columns, .near_lock = std::move(turns.near_lock), .detour = turns.detour};
  found.numbers.reserve(columns.size() * frames_.times.size());
  auto angle = turns.numbers.begin();
  for (const Eigen::Vector3d& translation : track->translations)
    for (const Column& column : columns)
      found.numbers.push_back(column.kind == position ? translation[column.axis] : *angle++);
  return found;
}

}}}  // namespace orispline::scenes::bvh
