// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/skeleton_page_json.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/report/json_text.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr double steps_of_extent = 8000.0;  ///< how finely positions are rounded: a step is less than a pixel
constexpr double steps_of_largest =
    500.0;  ///< likewise what is drawn as a line, and differences, which may be magnified

/// The largest of 1, 2 and 5 times a power of ten that is not larger; 1 where there is nothing to divide.
double round_step(double step) {
  if (!(step > 0.0) || !std::isfinite(step)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= step) return digit * power;
  return power;
}

/// A value in steps, the nearest whole number of them; 0 where it is out of all proportion.
long long in_steps(double value, double step) {
  constexpr double most = 1e15;
  return std::abs(value) < most * step ? std::llround(value / step) : 0;
}

/// The rounded positions of the first time, then how far each is from that of the time before. So numbers are short.
std::string moves_of(const std::vector<Eigen::Vector3d>& positions, std::size_t joints, double step) {
  std::vector<long long> moves, last(3 * joints, 0);
  moves.reserve(3 * positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const long long at = in_steps(positions[i][static_cast<Eigen::Index>(axis)], step);
      long long& before = last[3 * (i % joints) + axis];
      moves.push_back(at - before);
      before = at;
    }
  return list_of(moves);
}

std::string offsets_of(const PageClip& clip, double step) {
  std::vector<long long> offsets;
  for (std::size_t i = 0; i < clip.after.size(); ++i)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      offsets.push_back(in_steps(clip.after[i][axis] - clip.before[i][axis], step));
  return list_of(offsets);
}

double extent_of(const std::vector<Eigen::Vector3d>& positions) {
  double largest = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::ranges::minmax(positions, {}, [&](const Eigen::Vector3d& position) { return position[axis]; });
    largest = std::max(largest, high[axis] - low[axis]);
  }
  return largest;
}

double largest_offset_of(const PageClip& clip) {
  double largest = 0.0;
  for (std::size_t i = 0; i < clip.after.size(); ++i)
    largest = std::max(largest, (clip.after[i] - clip.before[i]).cwiseAbs().maxCoeff());
  return largest;
}

std::string poses_json(const PageClip& clip) {
  const double step = round_step(clip.before.empty() ? 0.0 : extent_of(clip.before) / steps_of_extent);
  const double offset_step = round_step(largest_offset_of(clip) / steps_of_largest);
  return object_of({{"t", list_of(clip.times)},
                    {"step", number_text(step)},
                    {"before", moves_of(clip.before, clip.joints.size(), step)},
                    {"offset_step", number_text(offset_step)},
                    {"after", offsets_of(clip, offset_step)}});
}

/// Of every joint a list; an empty one where all is 0.
template <std::vector<double> PageJointErrors::*Member>
std::string lines_json(const std::vector<PageJointErrors>& joints, double step) {
  return array_of(joints, [&](const PageJointErrors& joint) {
    std::vector<long long> steps;
    for (const double value : joint.*Member) steps.push_back(in_steps(value, step));
    if (std::ranges::all_of(steps, [](long long value) { return value == 0; })) steps.clear();
    return list_of(steps);
  });
}

template <PageLargest PageJointErrors::*Member>
double error_step(const std::vector<PageJointErrors>& joints) {
  double largest = 0.0;
  for (const PageJointErrors& joint : joints) largest = std::max(largest, (joint.*Member).value);
  return round_step(largest / steps_of_largest);
}

std::string errors_json(const PageClip& clip) {
  const double angle = error_step<&PageJointErrors::angle>(clip.joints),
               distance = error_step<&PageJointErrors::distance>(clip.joints);
  return object_of({{"t", list_of(clip.error_times)},
                    {"angle_step", number_text(angle)},
                    {"angle_deg", lines_json<&PageJointErrors::angles>(clip.joints, angle)},
                    {"distance_step", number_text(distance)},
                    {"distance", lines_json<&PageJointErrors::distances>(clip.joints, distance)}});
}

std::string json_of(const PageKeyCounts& keys) {
  return list_of(std::vector{static_cast<long long>(keys.before), static_cast<long long>(keys.after)});
}

std::string json_of(const PageLargest& largest) { return list_of(std::vector{largest.value, largest.time}); }

std::string json_of(const PageJointErrors& joint) {
  return object_of({{"angle_deg", json_of(joint.angle)},
                    {"distance", json_of(joint.distance)},
                    {"keys", json_of(joint.keys)},
                    {"key_t", list_of(joint.key_times)}});
}

std::string json_of(const PageClip& clip) {
  return object_of({{"name", text_of(clip.name)},
                    {"start", number_text(clip.start)},
                    {"end", number_text(clip.end)},
                    {"rotation_keys", json_of(clip.rotation_keys)},
                    {"translation_keys", json_of(clip.translation_keys)},
                    {"poses", poses_json(clip)},
                    {"errors", errors_json(clip)},
                    {"joints", array_of(clip.joints, [](const PageJointErrors& joint) { return json_of(joint); })}});
}

std::string json_of(const PageJoint& joint) {
  return object_of({{"name", text_of(joint.name)},
                    {"parent", joint.parent ? number_text(static_cast<double>(*joint.parent)) : "null"},
                    {"is_compared", joint.is_compared ? "true" : "false"}});
}

std::string limit_json(const std::optional<double>& limit) { return limit ? number_text(*limit) : "null"; }

std::string skeleton_json(const SkeletonPage& page) {
  return object_of({{"before", text_of(page.before)},
                    {"after", text_of(page.after)},
                    {"unit", text_of(page.length_unit)},
                    {"shell", number_text(page.shell)},
                    {"up", text_of(page.up == PageUp::y ? "y" : "z")},
                    {"angle_limit", limit_json(page.angle_limit)},
                    {"distance_limit", limit_json(page.distance_limit)},
                    {"joints", array_of(page.joints, [](const PageJoint& joint) { return json_of(joint); })},
                    {"clips", array_of(page.clips, [](const PageClip& clip) { return json_of(clip); })}});
}

}  // namespace

std::string json_of(const SkeletonPage& page) {
  return object_of({{"title", text_of(page.title)},
                    {"command", text_of(page.command)},
                    {"date", text_of(page.date)},
                    {"version", text_of(page.version)},
                    {"notes", array_of(page.notes, [](const std::string& note) { return text_of(note); })},
                    {"skeleton", skeleton_json(page)}});
}

}}}  // namespace orispline::report
