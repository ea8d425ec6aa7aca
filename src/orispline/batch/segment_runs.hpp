// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>

#include <orispline/batch/kernel/dispatch.hpp>
#include <orispline/batch/kernel/record.hpp>
#include <orispline/curve/knots.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace batch {

/// What is held: one end of a curve, or nothing for a time that is not a number.
enum class Held { first, last, nothing };

/// Writes runs of samples: on one segment, or held.
template <class S>
concept RunSampler = requires(S s, const Clock& clock, Held held, std::size_t n) {
  { s.knots() } -> std::convertible_to<const Knots&>;
  s.on_segment(n, clock, n, n);  // segment, from which time on, first sample, how many
  s.hold(held, n, n);            // first sample, how many
};

/// Samples `from` … `to - 1` of even times. The time of a sample is the kernel's own.
template <RunSampler Sampler>
void sample_part(Sampler& sampler, double t0, double dt, std::size_t from, std::size_t to) {
  const auto time = [&](std::size_t k) { return static_cast<double>(k) * dt + t0; };
  // The first sample in [k, to) whose time is past a limit, or has reached it.
  const auto first_that = [&](std::size_t k, double limit, auto past) {
    const double guess = dt > 0.0 ? std::floor((limit - t0) / dt) : 0.0;
    auto i = static_cast<std::size_t>(std::clamp(guess, static_cast<double>(k), static_cast<double>(to)));
    while (i > k && past(time(i - 1), limit)) --i;
    while (i < to && !past(time(i), limit)) ++i;
    return i;
  };
  const auto reached = [](double t, double limit) { return t >= limit; };
  const auto beyond = [](double t, double limit) { return t > limit; };
  const Knots& all = sampler.knots();
  const auto knots = all.times();
  std::size_t k = first_that(from, knots.front(), reached);
  if (k > from) sampler.hold(Held::first, from, k - from);
  const std::size_t end = knots.size() == 1 ? k : first_that(k, knots.back(), beyond);
  std::size_t segment = k < end ? all.segment_at(time(k)) : 0;
  while (k < end) {
    const bool last = segment + 2 >= knots.size();
    const std::size_t next = last ? end : first_that(k, knots[segment + 1], reached);
    if (next > k)
      sampler.on_segment(segment, Clock{.times = nullptr, .start = t0, .step = dt, .first = static_cast<double>(k)}, k,
                         next - k);
    k = next;
    if (last) break;
    ++segment;
    if (k < end && segment + 2 < knots.size() && time(k) >= knots[segment + 1]) segment = all.segment_at(time(k));
  }
  if (to > end) sampler.hold(Held::last, end, to - end);
}

/// How many of the times from `k` on belong together, the first of them at least.
template <class Belongs>
[[nodiscard]] std::size_t run_of(std::span<const double> times, std::size_t k, Belongs belongs) {
  std::size_t end = k + 1;
  while (end < times.size() && belongs(times[end])) ++end;
  return end - k;
}

/// How many belong together of times in order, of which none belongs behind one that does not: in steps that double,
/// then halve.
template <class Belongs>
[[nodiscard]] std::size_t run_in_order(std::span<const double> times, std::size_t k, Belongs belongs) {
  const std::size_t size = times.size();
  std::size_t inside = k, step = 1;
  while (step < size - inside && belongs(times[inside + step])) {
    inside += step;
    step *= 2;
  }
  const auto rest = times.subspan(inside + 1, std::min(step, size - inside) - 1);
  return inside + 1 - k + static_cast<std::size_t>(std::ranges::partition_point(rest, belongs) - rest.begin());
}

/// Times from `k` on, in any order and NaN among them: successive ones of one segment are a run. `segment` is one that
/// may be the first time's.
template <RunSampler Sampler>
void sample_runs(Sampler& sampler, std::span<const double> times, std::size_t k, std::size_t& segment) {
  const Knots& all = sampler.knots();
  const auto knots = all.times();
  const bool in_order = kernels().are_in_order(times.data() + k, times.size() - k);
  const auto run = [&](auto belongs) { return in_order ? run_in_order(times, k, belongs) : run_of(times, k, belongs); };
  while (k < times.size()) {
    const double t = times[k];
    std::size_t count = 0;
    if (std::isnan(t)) {
      sampler.hold(Held::nothing, k, count = run([](double next) { return std::isnan(next); }));
    } else if (t < knots.front()) {
      sampler.hold(Held::first, k, count = run([&](double next) { return next < knots.front(); }));
    } else if (t > knots.back() || knots.size() == 1) {
      sampler.hold(Held::last, k, count = run([&](double next) { return next > knots.back(); }));
    } else {
      if (t < knots[segment] || (segment + 2 < knots.size() && t >= knots[segment + 1])) segment = all.segment_at(t);
      const bool last = segment + 2 >= knots.size();
      const double limit =
          last ? std::nextafter(knots.back(), std::numeric_limits<double>::infinity()) : knots[segment + 1];
      count = run([&, start = knots[segment]](double next) { return next >= start && next < limit; });
      sampler.on_segment(segment, Clock{.times = times.data() + k, .start = 0.0, .step = 0.0, .first = 0.0}, k, count);
    }
    k += count;
  }
}

/// Times that are looked at once for their order and, while they are near, once more for their samples.
inline constexpr std::size_t times_at_a_time = 2048;

/// Times `from` … `to - 1`, in any order and NaN among them.
template <RunSampler Sampler>
void sample_part(Sampler& sampler, std::span<const double> times, std::size_t from, std::size_t to) {
  std::size_t segment = 0;
  for (; from < to; from = std::min(to, from + times_at_a_time))
    sample_runs(sampler, times.first(std::min(to, from + times_at_a_time)), from, segment);
}

/// Sample `at`, at any time.
template <RunSampler Sampler>
void sample_one(Sampler& sampler, const double& t, std::size_t at) {
  const Knots& knots = sampler.knots();
  if (std::isnan(t)) sampler.hold(Held::nothing, at, 1);
  else if (t < knots.front()) sampler.hold(Held::first, at, 1);
  else if (t > knots.back() || knots.segments() == 0) sampler.hold(Held::last, at, 1);
  else sampler.on_segment(knots.segment_at(t), Clock{.times = &t, .start = 0.0, .step = 0.0, .first = 0.0}, at, 1);
}

}}}  // namespace orispline::batch
