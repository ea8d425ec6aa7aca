// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <orispline/base/abi.hpp>
#include <orispline/base/decimal.hpp>
#include <orispline/math/eigen.hpp>
#include <orispline/report/page_document.hpp>
#include <orispline/report/page_lists.hpp>

// The JSON of pages: numbers rounded to what a line on a screen can show, and texts that end no script.

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

constexpr std::string_view data_version = "2";  ///< of studio/report/README.md, "The data"

using Member = std::pair<std::string_view, std::string>;  // name, JSON

/// A line for each of the values.
template <class Value, class JsonOf>
std::string array_of(const std::vector<Value>& values, JsonOf json_of_value) {
  std::string json = "[";
  for (const Value& value : values) json += (json.size() > 1 ? ",\n" : "") + json_of_value(value);
  return json + ']';
}

/// One flat array of whole numbers, which are short.
std::string list_of(const std::vector<long long>& values) {
  std::string json = "[";
  for (const long long value : values)
    fmt::format_to(std::back_inserter(json), "{}{}", json.size() > 1 ? "," : "", value);
  return json + ']';
}

std::string object_of(std::initializer_list<Member> members) {
  std::string json = "{";
  for (const auto& [name, value] : members)
    fmt::format_to(std::back_inserter(json), "{}\"{}\":{}", json.size() > 1 ? "," : "", name, value);
  return json + '}';
}

std::string json_of(double value) { return number_json(value); }

std::string number_or_null(const std::optional<double>& value) { return value ? number_json(*value) : "null"; }

std::string json_of(const PagePath& path) {
  return object_of({{"t", doubles_json(path.times)}, {"q", floats_json(path.orientations)}});
}

std::string json_of(const PageKeys& keys) {
  return object_of({{"t", doubles_json(keys.path.times)},
                    {"q", floats_json(keys.path.orientations)},
                    {"p", floats_json(keys.positions)}});
}

/// The lists of a method that others may have too.
struct SharedLists {
  std::string times, error_times;  ///< JSON
  bool errors_are_many = false;    ///< and written short
};

std::string json_of(const PageSamples& samples, SharedLists shared) {
  return object_of({{"t", std::move(shared.times)},
                    {"q", floats_json(samples.path.orientations)},
                    {"w", halves_json(samples.angular_velocities)},
                    {"a", halves_json(samples.angular_accelerations)},
                    {"j", halves_json(samples.angular_jerks)},
                    {"torque", halves_json(samples.torques)},
                    {"p", floats_json(samples.positions)},
                    {"error_t", std::move(shared.error_times)},
                    {"error_deg", shared.errors_are_many ? halves_json(samples.errors) : floats_json(samples.errors)},
                    {"straight", samples.is_straight ? "true" : "false"},
                    {"exactness_deg", number_or_null(samples.exactness)}});
}

std::string_view name_of(Better better) {
  constexpr std::array<std::string_view, 3> names{"less", "more", "neither"};
  return names[static_cast<std::size_t>(better)];
}

std::string_view name_of(PageBody body) {
  constexpr std::array<std::string_view, 3> names{"aircraft", "box", "axes"};
  return names[static_cast<std::size_t>(body)];
}

std::string json_of(const PageUnit& unit) {
  return object_of({{"unit", text_json(unit.name)}, {"size", json_of(unit.size)}});
}

std::string json_of(const PageBand& band) {
  return object_of({{"label", text_json(band.label)},
                    {"t", doubles_json(band.times)},
                    {"low", floats_json(band.low)},
                    {"high", floats_json(band.high)}});
}

std::string json_of(const PageColumn& column) {
  return object_of({{"id", text_json(column.id)},
                    {"label", text_json(column.label)},
                    {"unit", text_json(column.unit)},
                    {"explanation", text_json(column.explanation)},
                    {"better", text_json(name_of(column.better))},
                    {"is_time", column.is_time ? "true" : "false"},
                    {"rounding", json_of(column.rounding)}});
}

std::string json_of(const PageMarks& marks) {
  return object_of({{"label", text_json(marks.label)},
                    {"t", doubles_json(marks.path.times)},
                    {"q", floats_json(marks.path.orientations)},
                    {"error_deg", floats_json(marks.errors)}});
}

std::string json_of(const PageClock& clock) {
  return object_of({{"t", doubles_json(clock.times)}, {"own", doubles_json(clock.own)}});
}

template <class Value>
std::string json_or_null(const std::optional<Value>& value) {
  return value ? json_of(*value) : "null";
}

template <class Value>
std::string json_of(const std::map<std::string, Value, std::less<>>& values) {
  std::string json = "{";
  for (const auto& [id, value] : values) {
    if (json.size() > 1) json += ',';
    json.append(text_json(id)).append(":").append(json_of(value));
  }
  return json + '}';
}

std::string json_of(const PageMethod& method, SharedLists shared) {
  return object_of({{"name", text_json(method.name)},
                    {"continuity", text_json(method.continuity)},
                    {"failure", text_json(method.failure)},
                    {"measures", json_of(method.measures)},
                    {"samples", json_of(method.samples, std::move(shared))},
                    {"keys", json_or_null(method.keys)},
                    {"clock", json_or_null(method.clock)},
                    {"bands", json_of(method.bands)}});
}

const std::vector<double>& times_of(const PageMethod& method) { return method.samples.path.times; }
const std::vector<double>& error_times_of(const PageMethod& method) { return method.samples.error_times; }

/// A list that several methods have is written once, in the first of them.
template <class ListOf, class Json>
std::string written_once(const std::vector<PageMethod>& methods, const PageMethod& method, ListOf list_of, Json json) {
  const auto like = std::ranges::find(methods, list_of(method), list_of);
  const bool is_first = &*like == &method || list_of(method).empty();
  return is_first ? json(list_of(method)) : fmt::format(R"({{"like":{}}})", like - methods.begin());
}

std::string json_of(const std::vector<PageMethod>& methods) {
  constexpr std::size_t many_errors = 5000;
  std::size_t errors = 0;
  for (const PageMethod& method : methods) errors += method.samples.errors.size();
  return array_of(methods, [&](const PageMethod& method) {
    return json_of(method, {.times = written_once(methods, method, times_of, steps_json),
                            .error_times = written_once(methods, method, error_times_of, doubles_json),
                            .errors_are_many = errors > many_errors});
  });
}

constexpr double steps_of_extent = 8000.0;  ///< how finely positions are rounded: a step is less than a pixel
constexpr double steps_of_largest =
    500.0;  ///< the same for what is drawn as a line, and for differences, which may be magnified

/// The power of ten that is not larger, in steps of which numbers are rounded as decimals are; 1 where there is nothing
/// to divide.
double decimal_step(double step) {
  if (!(step > 0.0) || !std::isfinite(step)) return 1.0;
  return Decimal::power_of_ten(Decimal::from_double(step).decade()).to_double();
}

/// The largest of 1, 2 and 5 times a power of ten that is not larger; 1 where there is nothing to divide.
double round_step(double step) {
  const double power = decimal_step(step);
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
  return object_of({{"t", doubles_json(clip.times)},
                    {"step", number_json(step)},
                    {"before", moves_of(clip.before, clip.joints.size(), step)},
                    {"offset_step", number_json(offset_step)},
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

/// The steps of what is drawn as lines and stands in tables: both are rounded alike.
struct ErrorSteps {
  double angle = 1.0, distance = 1.0;
};

template <PageLargest PageJointErrors::*Member>
double error_step(const std::vector<PageJointErrors>& joints) {
  double largest = 0.0;
  for (const PageJointErrors& joint : joints) largest = std::max(largest, (joint.*Member).value);
  return decimal_step(largest / steps_of_largest);
}

std::string errors_json(const PageClip& clip, const ErrorSteps& steps) {
  return object_of({{"t", doubles_json(clip.error_times)},
                    {"angle_step", number_json(steps.angle)},
                    {"angle_deg", lines_json<&PageJointErrors::angles>(clip.joints, steps.angle)},
                    {"distance_step", number_json(steps.distance)},
                    {"distance", lines_json<&PageJointErrors::distances>(clip.joints, steps.distance)}});
}

std::string json_of(const PageKeyCounts& keys) {
  return list_of(std::vector{static_cast<long long>(keys.before), static_cast<long long>(keys.after)});
}

std::string json_of(const PageLargest& largest, double step) {
  return fmt::format("[{},{}]", number_json(static_cast<double>(in_steps(largest.value, step)) * step),
                     number_json(largest.time));
}

std::string json_of(const PageJointErrors& joint, const ErrorSteps& steps) {
  return object_of({{"angle_deg", json_of(joint.angle, steps.angle)},
                    {"distance", json_of(joint.distance, steps.distance)},
                    {"keys", json_of(joint.keys)},
                    {"key_t", doubles_json(joint.key_times)}});
}

std::string json_of(const PageClip& clip) {
  const ErrorSteps steps{error_step<&PageJointErrors::angle>(clip.joints),
                         error_step<&PageJointErrors::distance>(clip.joints)};
  return object_of(
      {{"name", text_json(clip.name)},
       {"start", number_json(clip.start)},
       {"end", number_json(clip.end)},
       {"rotation_keys", json_of(clip.rotation_keys)},
       {"translation_keys", json_of(clip.translation_keys)},
       {"poses", poses_json(clip)},
       {"errors", errors_json(clip, steps)},
       {"joints", array_of(clip.joints, [&](const PageJointErrors& joint) { return json_of(joint, steps); })}});
}

std::string json_of(const PageJoint& joint) {
  return object_of({{"name", text_json(joint.name)},
                    {"parent", joint.parent ? number_json(static_cast<double>(*joint.parent)) : "null"},
                    {"is_compared", joint.is_compared ? "true" : "false"}});
}

std::string skeleton_json(const SkeletonPage& page) {
  return object_of({{"before", text_json(page.before)},
                    {"after", text_json(page.after)},
                    {"unit", text_json(page.length_unit)},
                    {"shell", number_json(page.shell)},
                    {"up", text_json(page.up == PageUp::y ? "y" : "z")},
                    {"angle_limit", number_or_null(page.angle_limit)},
                    {"distance_limit", number_or_null(page.distance_limit)},
                    {"joints", array_of(page.joints, [](const PageJoint& joint) { return json_of(joint); })},
                    {"clips", array_of(page.clips, [](const PageClip& clip) { return json_of(clip); })}});
}

}  // namespace

std::string json_of(const Page& page) {
  return object_of({{"data", std::string(data_version)},
                    {"title", text_json(page.title)},
                    {"command", text_json(page.command)},
                    {"date", text_json(page.date)},
                    {"version", text_json(page.version)},
                    {"time_start", text_json(page.time_start)},
                    {"notes", array_of(page.notes, [](const std::string& note) { return text_json(note); })},
                    {"body", text_json(name_of(page.body))},
                    {"keys", json_of(page.keys)},
                    {"reference", json_or_null(page.reference)},
                    {"marks", json_or_null(page.marks)},
                    {"limits", json_of(page.limits)},
                    {"units", json_of(page.units)},
                    {"columns", array_of(page.columns, [](const PageColumn& c) { return json_of(c); })},
                    {"sorted_by", text_json(page.sorted_by)},
                    {"first", text_json(page.first)},
                    {"second", text_json(page.second)},
                    {"methods", json_of(page.methods)}});
}

std::string json_of(const SkeletonPage& page) {
  return object_of({{"data", std::string(data_version)},
                    {"title", text_json(page.title)},
                    {"command", text_json(page.command)},
                    {"date", text_json(page.date)},
                    {"version", text_json(page.version)},
                    {"notes", array_of(page.notes, [](const std::string& note) { return text_json(note); })},
                    {"skeleton", skeleton_json(page)}});
}

}}}  // namespace orispline::report
