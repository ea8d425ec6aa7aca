// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/online_curve.hpp>

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include <orispline/curve/key_check.hpp>

namespace orispline {
namespace {

Error argument_error(std::string message) { return {ErrorCode::bad_argument, std::move(message), {}}; }

std::optional<Error> check_options(const FamilyInfo& family, std::size_t capacity, const CurveOptions& options) {
  if (capacity < OnlineCurve::least_capacity || capacity > OnlineCurve::greatest_capacity)
    return argument_error(fmt::format("the capacity is {} keys, wanted {} to {}", capacity, OnlineCurve::least_capacity,
                                      OnlineCurve::greatest_capacity));
  if (options.loop) return argument_error("an online curve is open, found a loop");
  for (const auto& [name, values] : options.parameters)
    if (values.size() != 1)
      return argument_error(fmt::format("{}: found {} values of {}, wanted 1 for all keys of an online curve",
                                        family.name, values.size(), name));
  return std::nullopt;
}

/// Ends that no keys can have are refused before there are any: here at four keys in one place.
Expected<void> check_ends(OnlineSegments& segments) {
  RecentKeys keys;
  for (const double t : {0.0, 1.0, 2.0, 3.0}) keys.push(t, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero());
  return segments.store(0, keys, 0).and_then([&] { return segments.store(0, keys, 2); });
}

}  // namespace

Expected<OnlineCurve> OnlineCurve::make(std::string_view method, std::size_t capacity, const CurveOptions& options,
                                        Signs signs) {
  const auto found = find_online_method(method);
  if (!found) return tl::unexpected(found.error());
  if (auto error = check_options(*found->family, capacity, options)) return tl::unexpected(std::move(*error));
  const auto settings = settle(*found->family, options, RecentKeys::most);
  if (!settings) return tl::unexpected(settings.error());
  auto segments = found->segments(capacity - 1, *settings);
  if (!segments) return tl::unexpected(std::move(segments.error()));
  if (auto ends = check_ends(**segments); !ends) return tl::unexpected(std::move(ends.error()));
  OnlineCurve curve;
  curve.family_ = found->family;
  curve.options_ = options;
  curve.signs_ = signs;
  curve.keys_at_start_ = std::max(keys_needed(settings->start.rule), 2 + (*segments)->look_ahead());
  curve.keys_at_finish_ = std::max(keys_needed(settings->start.rule), keys_needed(settings->end.rule));
  curve.segments_ = std::move(*segments);
  curve.starts_.resize(2 * (capacity - 1));
  return curve;
}

Expected<void> OnlineCurve::take(double time, const Eigen::Quaterniond& orientation,
                                 const std::optional<Eigen::Vector3d>& position) {
  if (auto error = check(time, position)) return tl::unexpected(std::move(*error));
  const auto norm = checked_norm(static_cast<std::size_t>(keys_), orientation);
  if (!norm) return tl::unexpected(norm.error());
  Eigen::Quaterniond q(orientation.coeffs() / *norm);
  if (keys_ > 0 && signs_ == Signs::shortest && q.dot(recent_.orientations[recent_.size - 1]) < 0.0)
    q.coeffs() = -q.coeffs();
  recent_.push(time, q, position.value_or(Eigen::Vector3d::Zero()));
  ++keys_;
  has_positions_ = position.has_value();
  if (keys_ < keys_at_start_) return {};
  auto made = make_final(segments_->look_ahead());
  if (!made) {  // only the ghost of the first key can fail: nothing has left the recent keys yet
    --recent_.size;
    --keys_;
  }
  return made;
}

std::optional<Error> OnlineCurve::check(double time, const std::optional<Eigen::Vector3d>& position) const {
  const auto key = static_cast<std::size_t>(keys_);
  if (finished_) return argument_error("the curve is finished, wanted no more keys or a reset before them");
  const auto before = keys_ > 0 ? std::optional(recent_.times[recent_.size - 1]) : std::nullopt;
  if (auto error = check_time(key, time, before)) return error;
  if (keys_ > 0 && position.has_value() != has_positions_)
    return Error{ErrorCode::bad_data,
                 has_positions_ ? "found no position, wanted one as the keys before have"
                                : "found a position, wanted none as the keys before have none",
                 {.key = key}};
  if (position) return check_vector(key, "position", *position);
  return std::nullopt;
}

/// Makes the segments between the keys final but for the last `pending` ones.
Expected<void> OnlineCurve::make_final(std::size_t pending) {
  while (final_segments_ + pending + 1 < keys_) {
    const std::size_t s = recent_.size - 1 - static_cast<std::size_t>(keys_ - 1 - final_segments_);
    if (auto stored = segments_->store(next_place_, recent_, s); !stored) return stored;
    starts_[next_place_] = starts_[next_place_ + places()] = recent_.times[s];
    end_ = recent_.times[s + 1];
    next_place_ = next_place_ + 1 < places() ? next_place_ + 1 : 0;
    ++final_segments_;
  }
  return {};
}

Expected<void> OnlineCurve::finish() {
  if (keys_ == 0) return failure(ErrorCode::bad_data, "empty: no keys");
  if (keys_ > 1 && keys_ < keys_at_finish_)
    return tl::unexpected(settle(*family_, options_, static_cast<std::size_t>(keys_)).error());
  auto made = make_final(0);
  if (made) finished_ = true;
  return made;
}

void OnlineCurve::reset() noexcept {
  recent_.size = 0;
  keys_ = final_segments_ = 0;
  next_place_ = 0;
  finished_ = has_positions_ = false;
}

std::size_t OnlineCurve::kept() const noexcept {
  return static_cast<std::size_t>(std::min<std::uint64_t>(final_segments_, places()));
}

std::span<const double> OnlineCurve::starts() const noexcept { return std::span(starts_).subspan(place_of(0), kept()); }

std::size_t OnlineCurve::place_at(double t, Side side) const noexcept {
  const std::span<const double> all = starts();
  const auto has_begun = [&](std::size_t i) { return side == Side::right ? all[i] <= t : all[i] < t; };
  if (has_begun(all.size() - 1)) return place_of(all.size() - 1);
  if (!(t > all.front())) return place_of(0);
  // Keys come at a nearly even rate: look first where an even one would put the time, or one place beside it, chosen
  // without a branch that could be guessed wrong. The time lies before the last start.
  const auto even =
      static_cast<std::size_t>((t - all.front()) / (end_ - all.front()) * static_cast<double>(all.size()));
  const std::size_t near = std::min(even, all.size() - 2);
  const std::size_t guess = near + (has_begun(near + 1) ? 1 : 0) - (has_begun(near) ? 0 : 1);
  if (guess + 1 < all.size() && has_begun(guess) && !has_begun(guess + 1)) return place_of(guess);
  const auto inner = all.subspan(1);
  const auto next = side == Side::right ? std::ranges::upper_bound(inner, t) : std::ranges::lower_bound(inner, t);
  return place_of(static_cast<std::size_t>(next - inner.begin()));
}

std::optional<Domain> OnlineCurve::available() const noexcept {
  if (keys_ == 0) return std::nullopt;
  if (final_segments_ == 0) return Domain{recent_.times[0], recent_.times[0]};
  return Domain{starts().front(), end_};
}

Eigen::Quaterniond OnlineCurve::operator()(double t) const noexcept {
  if (keys_ == 0) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, nan};
  }
  if (final_segments_ == 0) return recent_.orientations[0];
  const double held = std::clamp(t, starts_[place_of(0)], end_);
  return segments_->orientation(held, place_at(held, Side::right));
}

Motion OnlineCurve::motion(double t, Side side) const noexcept {
  const auto domain = available();
  if (final_segments_ == 0 || t < domain->start || t > domain->end) return {.orientation = (*this)(t)};
  return segments_->motion(t, place_at(t, side));
}

Expected<Motion> OnlineCurve::checked_motion(double t) const {
  const auto domain = available();
  if (!domain) return tl::unexpected(argument_error("the curve has no keys, wanted at least one"));
  if (domain->contains(t)) return motion(t);
  return tl::unexpected(
      argument_error(fmt::format("time {} is not available, wanted {} to {}", t, domain->start, domain->end)));
}

std::optional<LinearMotion> OnlineCurve::linear_motion(double t, Side side) const noexcept {
  const auto domain = available();
  if (!has_positions_) return std::nullopt;
  if (final_segments_ == 0) return LinearMotion{.position = recent_.positions[0]};
  const double held = std::clamp(t, domain->start, domain->end);
  const LinearMotion there = segments_->linear_motion(held, place_at(held, side));
  return t < domain->start || t > domain->end ? LinearMotion{.position = there.position} : there;
}

}  // namespace orispline
