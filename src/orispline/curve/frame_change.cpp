// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/frame_change.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/end_rate_names.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::string_view world_axes = "world_axes", body_axes = "body_axes", world_rotation = "world_rotation",
                           body_rotation = "body_rotation";

/// Opposite ways along one line, the first of which is its positive one.
using Ways = std::string_view;

/// The lines that a system of axes lies along.
struct KindOfAxes {
  std::array<Ways, 3> lines;
  std::string_view letters;
};
constexpr KindOfAxes compass{{"NS", "EW", "UD"}, "N or S, E or W, U or D"};
constexpr KindOfAxes without_compass{{"RL", "FB", "UD"}, "R or L, F or B, U or D"};

/// Which way an axis points.
struct Way {
  std::size_t line;
  bool is_negative;
};

std::optional<Way> way_of(char letter, const KindOfAxes& kind) {
  for (std::size_t line = 0; line < kind.lines.size(); ++line)
    if (const std::size_t place = kind.lines[line].find(letter); place != Ways::npos) return Way{line, place == 1};
  return std::nullopt;
}

bool are_all_of(std::string_view letters, const KindOfAxes& kind) {
  return std::ranges::all_of(letters, [&](char letter) { return way_of(letter, kind).has_value(); });
}

/// Axes as three letters, in which option.
struct Letters {
  std::string_view option, text;

  [[nodiscard]] tl::unexpected<Error> refused(std::string_view wanted) const {
    return bad_option(option, formatted("found {}, wanted {}", in_quotes(text), wanted));
  }
};

std::string wanted_letters(AxesOf whose) {
  return whose == AxesOf::body ? formatted("{} for the axes of a body, such as FRD", without_compass.letters)
                               : formatted("{} with a compass, such as NED, or {} without one, such as RFU",
                                           compass.letters, without_compass.letters);
}

Expected<KindOfAxes> kind_of(const Letters& letters, AxesOf whose) {
  if (letters.text.size() != 3)
    return letters.refused("three letters that say where +x, +y and +z point: " + wanted_letters(whose));
  if (are_all_of(letters.text, without_compass)) return without_compass;
  if (whose == AxesOf::world && are_all_of(letters.text, compass)) return compass;
  return letters.refused(wanted_letters(whose));
}

Expected<std::array<Way, 3>> ways_of(const Letters& letters, const KindOfAxes& kind) {
  std::array<Way, 3> ways{};
  for (std::size_t k = 0; k < ways.size(); ++k) {
    ways[k] = *way_of(letters.text[k], kind);
    for (std::size_t before = 0; before < k; ++before)
      if (ways[before].line == ways[k].line)
        return letters.refused(formatted("no two letters along one line, as '{}' and '{}' are: {}",
                                         letters.text[before], letters.text[k], kind.letters));
  }
  return ways;
}

AxisChange change_between(const std::array<Way, 3>& from, const std::array<Way, 3>& to) {
  std::array<int, 3> old{};
  std::array<bool, 3> negated{};
  for (std::size_t k = 0; k < to.size(); ++k) {
    const auto same = std::ranges::find(from, to[k].line, &Way::line);
    old[k] = static_cast<int>(same - from.begin());
    negated[k] = same->is_negative != to[k].is_negative;
  }
  return {old, negated};
}

Expected<void> check_unit(std::string_view option, const std::optional<Eigen::Quaterniond>& rotation) {
  if (!rotation) return {};
  const double norm = rotation->coeffs().stableNorm();
  if (std::abs(norm - 1.0) <= norm_error_limit) return {};
  return bad_option(option, formatted("found a quaternion of norm {:.6g}, wanted 1", norm));
}

/// `start_rate=WX,WY,WZ` in the new frames; any other setting, and one that is none, as it is.
std::string turned_setting(std::string_view setting, const NewFrames& frames) {
  const std::size_t equals = setting.find('=');
  const std::string_view name = setting.substr(0, equals);
  if (equals == setting.npos || (name != start_rate_name && name != end_rate_name)) return std::string(setting);
  Eigen::Vector3d rate;
  const auto numbers = pieces_of(setting.substr(equals + 1), ',');
  if (numbers.size() != 3) return std::string(setting);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto number = number_in(numbers[k]);
    if (!number) return std::string(setting);
    rate[static_cast<Eigen::Index>(k)] = *number;
  }
  rate = frames.body_rate(rate);
  return formatted("{}={},{},{}", name, rate.x(), rate.y(), rate.z());
}

}  // namespace

Expected<AxisChange> axis_change_of(std::string_view text, AxesOf whose) {
  const std::string_view option = whose == AxesOf::world ? world_axes : body_axes;
  const auto systems = pieces_of(text, ':');
  if (systems.size() != 2)
    return Letters{option, text}.refused(formatted("two systems of axes with a colon between them, such as {}",
                                                   whose == AxesOf::world ? "NED:ENU" : "FRD:FLU"));
  const Letters from{option, systems[0]}, to{option, systems[1]};
  const auto old_kind = kind_of(from, whose), new_kind = kind_of(to, whose);
  if (!old_kind) return tl::unexpected(old_kind.error());
  if (!new_kind) return tl::unexpected(new_kind.error());
  const auto old_ways = ways_of(from, *old_kind), new_ways = ways_of(to, *new_kind);
  if (!old_ways) return tl::unexpected(old_ways.error());
  if (!new_ways) return tl::unexpected(new_ways.error());
  if (old_kind->letters != new_kind->letters)
    return Letters{option, text}.refused(
        "both with a compass, such as NED:ENU, or both without one, such as RUB:RFU; "
        "`world_rotation` says how a room lies beside the compass");
  return change_between(*old_ways, *new_ways);
}

Expected<void> check(const FrameChange& change) {
  const int world = change.world.axes.determinant(), body = change.body.axes.determinant();
  if (world != body) {
    const bool is_world = world < 0;
    return tl::unexpected(Error{
        .code = ErrorCode::bad_argument,
        .message = formatted("found axes of the {} of which one system is right-handed and the other left-handed, and "
                             "axes of the {} that keep their hand, wanted a change on both sides or on none",
                             is_world ? "world" : "body", is_world ? "body" : "world"),
        .option = std::string(is_world ? world_axes : body_axes),
        .remedy = std::string(is_world ? body_axes : world_axes)});
  }
  if (auto checked = check_unit(world_rotation, change.world.rotation); !checked) return checked;
  return check_unit(body_rotation, change.body.rotation);
}

NewFrames::NewFrames(const FrameChange& change) : change_(change) {
  ORISPLINE_EXPECT(check(change));
  for (CoordinateChange* const side : {&change_.world, &change_.body})
    if (side->rotation) side->rotation->normalize();
  keeps_axes_ = change_.world.axes.is_none() && change_.body.axes.is_none();
  // A mirror on both sides is none: W R Bᵀ is (-W) R (-B)ᵀ.
  const Eigen::Quaterniond world = change_.world.axes.whole_quaternion(), body = change_.body.axes.whole_quaternion();
  for (std::size_t k = 0; k < product_.size(); ++k) {
    Eigen::Vector4d unit = Eigen::Vector4d::Unit(static_cast<Eigen::Index>(k));
    const Eigen::Quaterniond column = world * quaternion_wxyz(unit[0], unit[1], unit[2], unit[3]) * body.conjugate();
    product_[0][k] = column.w();
    product_[1][k] = column.x();
    product_[2][k] = column.y();
    product_[3][k] = column.z();
  }
  scale_ = std::sqrt(world.squaredNorm() * body.squaredNorm());
}

Eigen::Vector3d place_of_body(const Eigen::Quaterniond& orientation, const Eigen::Vector3d& origin) {
  return Eigen::Vector3d::Zero() - to_world<double>(orientation.normalized(), origin);
}

KeyframeData conjugated(KeyframeData data) {
  for (auto* const orientations : {&data.orientations, &data.inner_leaving, &data.inner_arriving})
    for (Eigen::Quaterniond& q : *orientations) q = q.conjugate();
  return data;
}

KeyframeData inverted(KeyframeData data) {
  data = conjugated(std::move(data));
  for (std::size_t i = 0; i < data.positions.size(); ++i)
    data.positions[i] = place_of_body(data.orientations[i], data.positions[i]);
  return data;
}

KeyframeData in_frames(KeyframeData data, const NewFrames& frames) {
  if (frames.change_nothing()) return data;
  for (auto* const orientations : {&data.orientations, &data.inner_leaving, &data.inner_arriving})
    for (Eigen::Quaterniond& q : *orientations) q = frames.orientation(q);
  for (Eigen::Vector3d& p : data.positions) p = frames.in_world(p);
  for (auto* const rates : {&data.angular_velocities, &data.angular_accelerations, &data.angular_jerks})
    for (Eigen::Vector3d& rate : *rates) rate = frames.body_rate(rate);
  return data;
}

Expected<Track> in_frames(const Track& track, const FrameChange& change) {
  if (auto checked = check(change); !checked) return tl::unexpected(std::move(checked.error()));
  const NewFrames frames(change);
  return Keyframes::make(in_frames(track.keys.data(), frames), track.recipe.signs).map([&](const Keyframes& turned) {
    Track result = track.with_keys(turned);
    for (Eigen::Quaterniond& q : result.as_read) q = frames.orientation(q);
    if (!frames.change_nothing())
      for (Eigen::Vector3d& p : result.positions_apart.positions) p = frames.in_world(p);
    result.recipe = in_frames(track.recipe, frames);
    return result;
  });
}

Recipe in_frames(Recipe recipe, const NewFrames& frames) {
  if (frames.change_nothing()) return recipe;
  std::vector<std::string> settings;
  for (const std::string_view setting : pieces_of(recipe.method, ':'))
    settings.push_back(turned_setting(setting, frames));
  recipe.method = joined(settings, ":");
  return recipe;
}

}}  // namespace orispline
