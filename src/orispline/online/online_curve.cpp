// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/online_curve.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/batch/sample_layout.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

std::optional<Error> check_method(const Method& method) {
  const auto family = family_of_method(method);
  if (family && (!(*family)->is_global() || (*family)->keys_beside)) return std::nullopt;
  return Error{
      ErrorCode::bad_argument,
      formatted("method '{}' has no online curve, wanted one of {}", method.name, joined(online_methods(), ", ")),
      {}};
}

}  // namespace

OnlineCurve::OnlineCurve(StreamMethod method, std::size_t capacity, Signs signs)
    : method_(std::move(method)),
      signs_(signs),
      segments_(segments_in_place(method_, capacity - 1)),
      starts_(2 * (capacity - 1)) {
  if (!segments_) segments_ = segments_of_windows(method_, capacity - 1);
}

Expected<OnlineCurve> OnlineCurve::make(const Method& method, std::size_t capacity, Signs signs) {
  if (auto error = check_method(method)) return tl::unexpected(std::move(*error));
  if (capacity < least_capacity || capacity > greatest_capacity)
    return failure(ErrorCode::bad_argument,
                   formatted("the capacity is {} keys, wanted {} to {}", capacity, least_capacity, greatest_capacity));
  auto made = StreamMethod::make(method);
  if (!made) return tl::unexpected(std::move(made.error()));
  if (!made->keys_beside)
    return failure(ErrorCode::bad_argument,
                   formatted("{}: with these settings a segment depends on all keys, wanted others for an online curve",
                             method.name));
  return OnlineCurve(std::move(*made), capacity, signs);
}

Expected<void> OnlineCurve::append(const StreamKey& key) {
  if (finished_)
    return failure(ErrorCode::bad_argument, "the curve is finished, wanted no more keys; reset() begins a new curve");
  const auto orientation = checked_orientation(keys_, key, times_.all(), parts_);
  if (!orientation) return tl::unexpected(orientation.error());
  if (auto error = method_.check_settings(keys_, key)) return tl::unexpected(std::move(*error));
  const Place known = newest_;
  const RecentTimes known_times = times_;
  times_.push(key.time);
  newest_ = {key.time, *orientation, key.position.value_or(Eigen::Vector3d::Zero())};
  if (keys_ > 0 && signs_ == Signs::shortest && newest_.orientation.dot(known.orientation) < 0.0)
    newest_.orientation.coeffs() = -newest_.orientation.coeffs();
  segments_->push(key, newest_.orientation);
  if (keys_ == 0) {
    first_ = newest_;
    parts_ = parts_of(key);
  }
  ++keys_;
  if (keys_ < method_.keys_at_start) return {};
  auto made = make_final(Stream::open);
  if (!made) {
    segments_->pop();
    newest_ = known;
    times_ = known_times;
    --keys_;
  }
  return made;
}

/// Makes the segments final that have all their keys.
Expected<void> OnlineCurve::make_final(Stream stream) {
  const KeyUse& use = method_.family->key_use;
  const std::size_t pending = stream == Stream::open ? look_ahead() : method_.first_key;
  for (;; ++final_segments_) {
    const std::uint64_t start = method_.first_key + use.stride * final_segments_;
    if (start + use.stride + pending >= keys_) return {};
    const auto stored = segments_->store(next_place_, static_cast<std::size_t>(keys_ - 1 - start), stream);
    if (!stored) return tl::unexpected(stored.error());
    starts_[next_place_] = starts_[next_place_ + places()] = stored->start;
    end_ = stored->end;
    next_place_ = next_place_ + 1 < places() ? next_place_ + 1 : 0;
  }
}

Expected<void> OnlineCurve::finish() {
  if (keys_ == 0) return failure(ErrorCode::bad_data, "empty: no keys");
  if (auto error = method_.check_count(static_cast<std::size_t>(keys_))) return tl::unexpected(std::move(*error));
  auto made = make_final(Stream::finished);
  if (made) finished_ = true;
  return made;
}

void OnlineCurve::reset() noexcept {
  segments_->reset();
  times_.clear();
  parts_ = {};
  keys_ = final_segments_ = 0;
  next_place_ = 0;
  finished_ = false;
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
  if (final_segments_ == 0) return Domain{first_.time, first_.time};
  return Domain{starts().front(), end_};
}

Eigen::Quaterniond OnlineCurve::operator()(double t) const noexcept {
  if (keys_ == 0 || std::isnan(t)) return no_motion<Eigen::Quaterniond>().orientation;
  if (final_segments_ == 0) return first_.orientation;
  const double held = std::clamp(t, starts_[place_of(0)], end_);
  return segments_->orientation(held, place_at(held, Side::right));
}

Motion OnlineCurve::motion(double t, Side side) const noexcept {
  if (keys_ == 0 || std::isnan(t)) return no_motion<Eigen::Quaterniond>();
  const auto domain = available();
  if (final_segments_ == 0 || t < domain->start || t > domain->end) return {.orientation = (*this)(t)};
  return segments_->motion(t, side, place_at(t, side));
}

Expected<Motion> OnlineCurve::checked_motion(double t) const {
  const auto domain = available();
  if (!domain) return failure(ErrorCode::bad_argument, "the curve has no keys, wanted at least one");
  if (domain->contains(t)) return motion(t);
  return failure(ErrorCode::bad_argument,
                 formatted("time {} is not available, wanted {} to {}", t, domain->start, domain->end));
}

std::optional<LinearMotion> OnlineCurve::linear_motion(double t, Side side) const noexcept {
  const auto domain = available();
  if (!parts_.position) return std::nullopt;
  if (std::isnan(t)) return no_motion<Eigen::Vector3d>();
  if (final_segments_ == 0) return LinearMotion{.position = first_.position};
  const double held = std::clamp(t, domain->start, domain->end);
  const LinearMotion there = segments_->linear_motion(held, side, place_at(held, side));
  return t < domain->start || t > domain->end ? LinearMotion{.position = there.position} : there;
}

Expected<void> OnlineCurve::sample(std::span<const double> times, const Samples<double>& out) const {
  if (auto error = batch::check_room(out, times.size())) return tl::unexpected(std::move(*error));
  if (wants_positions(out) && !parts_.position)
    return failure(ErrorCode::bad_argument, "found room for positions, wanted none: the keys have no positions");
  const auto put = [&](std::size_t at, const Motion& motion, const LinearMotion& linear_motion) {
    batch::put(out, at, motion);
    batch::put(out, at, linear_motion);
  };
  const auto domain = available();
  for (std::size_t k = 0, count = 1; k < times.size(); k += count, count = 1) {
    const double t = times[k];
    if (keys_ == 0 || std::isnan(t)) put(k, no_motion<Eigen::Quaterniond>(), no_motion<Eigen::Vector3d>());
    else if (final_segments_ == 0) put(k, {.orientation = first_.orientation}, {.position = first_.position});
    else if (!domain->contains(t)) hold(std::clamp(t, domain->start, domain->end), out, k);
    else {
      const std::size_t place = place_at(t, Side::right);
      const auto belongs = [&](double next) { return domain->contains(next) && place_at(next, Side::right) == place; };
      while (k + count < times.size() && belongs(times[k + count])) ++count;
      segments_->sample(times.subspan(k, count), place, out, k);
    }
  }
  return {};
}

/// Writes a sample at rest, of an end of what is available.
void OnlineCurve::hold(double end, const Samples<double>& out, std::size_t at) const {
  Motion motion;
  segments_->sample({&end, 1}, place_at(end, Side::right), {.orientations = {motion.orientation.coeffs().data(), 4}},
                    0);
  batch::put(out, at, motion);
  if (wants_positions(out)) batch::put(out, at, LinearMotion{.position = linear_motion(end)->position});
}

}}  // namespace orispline
