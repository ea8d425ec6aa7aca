// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/sample.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <orispline/batch/parallel.hpp>
#include <orispline/batch/segment_sampler.hpp>

namespace orispline {
namespace {

using batch::Clock;
using batch::SegmentSampler;

/// Samples that one thread takes at a time.
constexpr std::size_t part_size = 1U << 16U;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class T>
std::optional<Error> check(const Samples<T>& out, std::size_t wanted) {
  const auto fails = [wanted](const char* what, std::size_t found, std::size_t components) -> std::optional<Error> {
    return Error{
        ErrorCode::bad_argument,
        fmt::format("found room for {} {}, wanted {} numbers for {} samples", found, what, components * wanted, wanted),
        {}};
  };
  if (out.orientations.size() != 4 * wanted) return fails("numbers of orientations", out.orientations.size(), 4);
  if (!out.angular_velocities.empty() && out.angular_velocities.size() != 3 * wanted)
    return fails("numbers of angular velocities", out.angular_velocities.size(), 3);
  if (!out.angular_accelerations.empty() && out.angular_accelerations.size() != 3 * wanted)
    return fails("numbers of angular accelerations", out.angular_accelerations.size(), 3);
  return std::nullopt;
}

/// A curve as it is sampled: with its segments compiled, or not yet.
template <class T>
struct Source {
  const AnyCurve& curve;
  const CompiledCurve<T>* compiled = nullptr;

  [[nodiscard]] std::span<const double> knots() const { return curve.knots().times(); }
  [[nodiscard]] Eigen::Quaterniond first() const { return curve(curve.domain().start); }
  [[nodiscard]] Eigen::Quaterniond last() const { return curve(curve.domain().end); }
};

Eigen::Quaterniond unknown() { return {nan, nan, nan, nan}; }

/// Samples `from` … `to - 1` of even times. The time of a sample is the kernel's own.
template <class T>
void sample_part(const Source<T>& source, double t0, double dt, std::size_t from, std::size_t to,
                 const Samples<T>& out) {
  SegmentSampler<T> sampler(source.curve, source.compiled, out);
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
  const auto knots = source.knots();
  std::size_t k = first_that(from, knots.front(), reached);
  sampler.held(source.first(), from, k - from);
  const std::size_t end = knots.size() == 1 ? k : first_that(k, knots.back(), beyond);
  std::size_t segment = k < end ? source.curve.knots().segment_at(time(k)) : 0;
  while (k < end) {
    const bool last = segment + 2 >= knots.size();
    const std::size_t next = last ? end : first_that(k, knots[segment + 1], reached);
    if (next > k)
      sampler.on_segment(segment, Clock{.times = nullptr, .start = t0, .step = dt, .first = static_cast<double>(k)}, k,
                         next - k);
    k = next;
    if (last) break;
    ++segment;
    if (k < end && segment + 2 < knots.size() && time(k) >= knots[segment + 1])
      segment = source.curve.knots().segment_at(time(k));
  }
  sampler.held(source.last(), end, to - end);
}

/// Times `from` … `to - 1`, which do not decrease; NaN may stand between them.
template <class T>
void sample_part(const Source<T>& source, std::span<const double> times, std::size_t from, std::size_t to,
                 const Samples<T>& out) {
  SegmentSampler<T> sampler(source.curve, source.compiled, out);
  const auto knots = source.knots();
  std::size_t k = from, segment = 0;
  const auto run = [&](auto belongs) {  // of samples from k on
    std::size_t end = k + 1;
    while (end < to && belongs(times[end])) ++end;
    return end - k;
  };
  while (k < to) {
    const double t = times[k];
    std::size_t count = 0;
    if (std::isnan(t)) {
      sampler.held(unknown(), k, count = run([](double next) { return std::isnan(next); }));
    } else if (t < knots.front()) {
      sampler.held(source.first(), k, count = run([&](double next) { return next < knots.front(); }));
    } else if (t > knots.back() || knots.size() == 1) {
      sampler.held(source.last(), k, count = run([&](double next) { return next > knots.back(); }));
    } else {
      if (segment + 2 < knots.size() && t >= knots[segment + 1]) segment = source.curve.knots().segment_at(t);
      const bool last = segment + 2 >= knots.size();
      const double limit =
          last ? std::nextafter(knots.back(), std::numeric_limits<double>::infinity()) : knots[segment + 1];
      count = run([&](double next) { return next < limit; });
      sampler.on_segment(segment, Clock{.times = times.data() + k, .start = 0.0, .step = 0.0, .first = 0.0}, k, count);
    }
    k += count;
  }
}

/// One sample at any time.
template <class T>
void sample_one(const Source<T>& source, const double& t, std::size_t at, SegmentSampler<T>& sampler) {
  const Domain domain = source.curve.domain();
  if (std::isnan(t)) sampler.held(unknown(), at, 1);
  else if (t < domain.start) sampler.held(source.first(), at, 1);
  else if (t > domain.end || source.knots().size() == 1) sampler.held(source.last(), at, 1);
  else
    sampler.on_segment(source.curve.knots().segment_at(t), Clock{.times = &t, .start = 0.0, .step = 0.0, .first = 0.0},
                       at, 1);
}

/// Whole parts on as many threads as wanted.
template <class Part>
void in_parts(std::size_t samples, Work work, Part part) {
  const std::size_t parts = (samples + part_size - 1) / part_size;
  if (work.threads == 1 || parts < 2) return part(0, samples);
  parallel_for(parts, work.threads,
               [&](std::size_t i) { part(i * part_size, std::min(samples, (i + 1) * part_size)); });
}

template <class T>
Expected<void> sample_uniform_of(const Source<T>& source, double t0, double dt, const Samples<T>& out, Work work) {
  if (auto error = check(out, out.size())) return tl::unexpected(std::move(*error));
  if (!(dt >= 0.0) || !std::isfinite(dt))
    return failure(ErrorCode::bad_argument, fmt::format("the step is {} s, wanted 0 or more", dt));
  if (out.size() == 0) return {};
  if (!std::isfinite(t0)) {
    SegmentSampler<T>(source.curve, source.compiled, out)
        .held(std::isnan(t0) ? unknown()
              : t0 < 0.0     ? source.first()
                             : source.last(),
              0, out.size());
    return {};
  }
  in_parts(out.size(), work, [&](std::size_t from, std::size_t to) { sample_part(source, t0, dt, from, to, out); });
  return {};
}

template <class T>
Expected<void> sample_of(const Source<T>& source, std::span<const double> times, const Samples<T>& out, Work work) {
  if (auto error = check(out, times.size())) return tl::unexpected(std::move(*error));
  double latest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] >= latest) latest = times[k];
    else if (!std::isnan(times[k]))
      return failure(ErrorCode::bad_argument,
                     fmt::format("{} s comes after {} s, wanted times that do not decrease", times[k], latest),
                     {.time = k});
  }
  in_parts(times.size(), work, [&](std::size_t from, std::size_t to) { sample_part(source, times, from, to, out); });
  return {};
}

}  // namespace

template <class T>
Expected<void> sample_uniform(const AnyCurve& curve, double t0, double dt, const Samples<T>& out, Work work) {
  return sample_uniform_of(Source<T>{curve}, t0, dt, out, work);
}

template <class T>
Expected<void> sample_uniform(const CompiledCurve<T>& curve, double t0, double dt, const Samples<T>& out, Work work) {
  return sample_uniform_of(Source<T>{curve.curve(), &curve}, t0, dt, out, work);
}

template <class T>
Expected<void> sample(const AnyCurve& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_of(Source<T>{curve}, times, out, work);
}

template <class T>
Expected<void> sample(const CompiledCurve<T>& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_of(Source<T>{curve.curve(), &curve}, times, out, work);
}

template <class T>
Expected<void> sample_at(const CompiledCurve<T>& curve, std::span<const double> times, const Samples<T>& out,
                         Work work) {
  if (auto error = check(out, times.size())) return tl::unexpected(std::move(*error));
  in_parts(times.size(), work, [&](std::size_t from, std::size_t to) {
    const Source<T> source{curve.curve(), &curve};
    SegmentSampler<T> sampler(source.curve, source.compiled, out);
    for (std::size_t k = from; k < to; ++k) sample_one(source, times[k], k, sampler);
  });
  return {};
}

template <class T>
Expected<void> sample_many(std::span<const CompiledCurve<T>> curves, double t, const Samples<T>& out, Work work) {
  if (auto error = check(out, curves.size())) return tl::unexpected(std::move(*error));
  in_parts(curves.size(), work, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      const Source<T> source{curves[k].curve(), &curves[k]};
      SegmentSampler<T> sampler(source.curve, source.compiled, out);
      sample_one(source, t, k, sampler);
    }
  });
  return {};
}

#define ORISPLINE_SAMPLE(T)                                                                                        \
  template Expected<void> sample_uniform<T>(const AnyCurve&, double, double, const Samples<T>&, Work);             \
  template Expected<void> sample_uniform<T>(const CompiledCurve<T>&, double, double, const Samples<T>&, Work);     \
  template Expected<void> sample<T>(const AnyCurve&, std::span<const double>, const Samples<T>&, Work);            \
  template Expected<void> sample<T>(const CompiledCurve<T>&, std::span<const double>, const Samples<T>&, Work);    \
  template Expected<void> sample_at<T>(const CompiledCurve<T>&, std::span<const double>, const Samples<T>&, Work); \
  template Expected<void> sample_many<T>(std::span<const CompiledCurve<T>>, double, const Samples<T>&, Work);
ORISPLINE_SAMPLE(double)
ORISPLINE_SAMPLE(float)

}  // namespace orispline
