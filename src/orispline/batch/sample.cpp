// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/sample.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/batch/baked_sampler.hpp>
#include <orispline/batch/path_sampler.hpp>
#include <orispline/batch/sample_layout.hpp>
#include <orispline/batch/segment_runs.hpp>
#include <orispline/batch/segment_sampler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using batch::check_room;
using batch::Held;
using batch::sample_one;
using batch::sample_part;

/// Samples that one thread takes at a time.
constexpr std::size_t part_size = 1U << 16U;

std::optional<Error> refusal(const char* message) { return Error{ErrorCode::bad_argument, message, {}}; }

template <class T>
std::optional<Error> without_positions(const Samples<T>& out) {
  return wants_positions(out) ? refusal("found room for positions, wanted none: the curve has orientations only")
                              : std::nullopt;
}

/// Orientations run by run.
template <class T>
class OrientationSampler {
 public:
  OrientationSampler(const AnyCurve& curve, const CompiledCurve<T>* compiled, const Samples<T>& out) noexcept
      : curve_(curve), out_(out), segments_(curve, compiled, out) {}

  [[nodiscard]] const Knots& knots() const noexcept { return curve_.knots(); }
  void on_segment(std::size_t segment, const batch::Clock& clock, std::size_t at, std::size_t count) noexcept {
    segments_.on_segment(segment, clock, at, count);
  }
  void hold(Held held, std::size_t at, std::size_t count) noexcept {
    if (count == 0) return;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    batch::put_held(out_, at, count,
                    held == Held::nothing
                        ? Eigen::Quaterniond(nan, nan, nan, nan)
                        : segments_.orientation_at(held == Held::first ? knots().front() : knots().back()));
  }

 private:
  const AnyCurve& curve_;
  const Samples<T>& out_;
  batch::SegmentSampler<T> segments_;
};

// What can be sampled: each calls `take` with the samplers that fill what is wanted.

template <class T>
struct CurveSource {
  const AnyCurve& curve;
  const CompiledCurve<T>* compiled = nullptr;

  [[nodiscard]] std::optional<Error> check(const Samples<T>& out) const { return without_positions(out); }
  template <class Take>
  void with_samplers(const Samples<T>& out, Take take) const {
    OrientationSampler<T> orientations(curve, compiled, out);
    take(orientations);
  }
};

template <class T>
struct PoseSource {
  const PoseCurve& curve;

  [[nodiscard]] std::optional<Error> check(const Samples<T>& out) const { return batch::check_positions(curve, out); }
  template <class Take>
  void with_samplers(const Samples<T>& out, Take take) const {
    CurveSource<T>{curve.orientation}.with_samplers(out, take);
    if (!wants_positions(out)) return;
    batch::PathSampler<T> positions(*curve.position, out);
    take(positions);
  }
};

template <class T>
struct BakedSource {
  const BakedCurve<T>& curve;

  [[nodiscard]] std::optional<Error> check(const Samples<T>& out) const { return without_positions(out); }
  template <class Take>
  void with_samplers(const Samples<T>& out, Take take) const {
    batch::BakedSampler<T> pieces(curve, out);
    take(pieces);
  }
};

template <class T, class Source>
std::optional<Error> check(const Source& source, const Samples<T>& out, std::size_t wanted) {
  auto error = check_room(out, wanted);
  return error ? error : source.check(out);
}

/// Whole parts on as many threads as wanted.
template <class Part>
void in_parts(std::size_t samples, Work work, Part part) {
  const std::size_t parts = (samples + part_size - 1) / part_size;
  if (work.threads == 1 || parts < 2) return part(0, samples);
  parallel_for(parts, work.threads,
               [&](std::size_t i) { part(i * part_size, std::min(samples, (i + 1) * part_size)); });
}

template <class T, class Source>
Expected<void> sample_uniform_of(const Source& source, double t0, double dt, const Samples<T>& out, Work work) {
  if (auto error = check(source, out, out.size())) return tl::unexpected(std::move(*error));
  if (!(dt >= 0.0) || !std::isfinite(dt))
    return failure(ErrorCode::bad_argument, formatted("the step is {} s, wanted 0 or more", dt));
  if (out.size() == 0) return {};
  if (!std::isfinite(t0)) {
    const Held held = std::isnan(t0) ? Held::nothing : t0 < 0.0 ? Held::first : Held::last;
    source.with_samplers(out, [&](auto& sampler) { sampler.hold(held, 0, out.size()); });
    return {};
  }
  in_parts(out.size(), work, [&](std::size_t from, std::size_t to) {
    source.with_samplers(out, [&](auto& sampler) { sample_part(sampler, t0, dt, from, to); });
  });
  return {};
}

template <class T, class Source>
Expected<void> sample_at_of(const Source& source, std::span<const double> times, const Samples<T>& out, Work work) {
  if (auto error = check(source, out, times.size())) return tl::unexpected(std::move(*error));
  in_parts(times.size(), work, [&](std::size_t from, std::size_t to) {
    source.with_samplers(out, [&](auto& sampler) { sample_part(sampler, times, from, to); });
  });
  return {};
}

/// The first time that is less than one before it.
std::optional<Error> decrease(std::span<const double> times) {
  if (batch::kernels().are_in_order(times.data(), times.size())) return std::nullopt;
  double latest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] >= latest) latest = times[k];
    else if (!std::isnan(times[k]))
      return Error{ErrorCode::bad_argument,
                   formatted("{} s comes after {} s, wanted times that do not decrease", times[k], latest),
                   {.time_index = k}};
  }
  return std::nullopt;
}

template <class T, class Source>
Expected<void> sample_of(const Source& source, std::span<const double> times, const Samples<T>& out, Work work) {
  if (auto error = check(source, out, times.size())) return tl::unexpected(std::move(*error));
  if (auto error = decrease(times)) return tl::unexpected(std::move(*error));
  return sample_at_of(source, times, out, work);
}

}  // namespace

template <class T>
Expected<void> sample_uniform(const AnyCurve& curve, double t0, double dt, const Samples<T>& out, Work work) {
  return sample_uniform_of(CurveSource<T>{curve}, t0, dt, out, work);
}

template <class T>
Expected<void> sample_uniform(const CompiledCurve<T>& curve, double t0, double dt, const Samples<T>& out, Work work) {
  return sample_uniform_of(CurveSource<T>{curve.curve(), &curve}, t0, dt, out, work);
}

template <class T>
Expected<void> sample_uniform(const PoseCurve& curve, double t0, double dt, const Samples<T>& out, Work work) {
  return sample_uniform_of(PoseSource<T>{curve}, t0, dt, out, work);
}

template <class T>
Expected<void> sample_uniform(const BakedCurve<T>& curve, double t0, double dt, const Samples<T>& out, Work work) {
  return sample_uniform_of(BakedSource<T>{curve}, t0, dt, out, work);
}

template <class T>
Expected<void> sample(const AnyCurve& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_of(CurveSource<T>{curve}, times, out, work);
}

template <class T>
Expected<void> sample(const CompiledCurve<T>& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_of(CurveSource<T>{curve.curve(), &curve}, times, out, work);
}

template <class T>
Expected<void> sample(const PoseCurve& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_of(PoseSource<T>{curve}, times, out, work);
}

template <class T>
Expected<void> sample(const BakedCurve<T>& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_of(BakedSource<T>{curve}, times, out, work);
}

template <class T>
Expected<void> sample_at(const AnyCurve& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_at_of(CurveSource<T>{curve}, times, out, work);
}

template <class T>
Expected<void> sample_at(const CompiledCurve<T>& curve, std::span<const double> times, const Samples<T>& out,
                         Work work) {
  return sample_at_of(CurveSource<T>{curve.curve(), &curve}, times, out, work);
}

template <class T>
Expected<void> sample_at(const PoseCurve& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_at_of(PoseSource<T>{curve}, times, out, work);
}

template <class T>
Expected<void> sample_at(const BakedCurve<T>& curve, std::span<const double> times, const Samples<T>& out, Work work) {
  return sample_at_of(BakedSource<T>{curve}, times, out, work);
}

template <class T>
Expected<void> sample_many(std::span<const CompiledCurve<T>> curves, double t, const Samples<T>& out, Work work) {
  if (auto error = check_room(out, curves.size())) return tl::unexpected(std::move(*error));
  if (wants_positions(out))
    return failure(ErrorCode::bad_argument, "found room for positions, wanted none: the curves have orientations only");
  in_parts(curves.size(), work, [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      OrientationSampler<T> orientations(curves[k].curve(), &curves[k], out);
      sample_one(orientations, t, k);
    }
  });
  return {};
}

// NOLINTBEGIN(bugprone-macro-parentheses): they are types
#define ORISPLINE_SAMPLE_FROM(Curve, T)                                                              \
  template Expected<void> sample_uniform<T>(const Curve&, double, double, const Samples<T>&, Work);  \
  template Expected<void> sample<T>(const Curve&, std::span<const double>, const Samples<T>&, Work); \
  template Expected<void> sample_at<T>(const Curve&, std::span<const double>, const Samples<T>&, Work);
#define ORISPLINE_SAMPLE(T)                  \
  ORISPLINE_SAMPLE_FROM(AnyCurve, T)         \
  ORISPLINE_SAMPLE_FROM(CompiledCurve<T>, T) \
  ORISPLINE_SAMPLE_FROM(PoseCurve, T)        \
  ORISPLINE_SAMPLE_FROM(BakedCurve<T>, T)    \
  template Expected<void> sample_many<T>(std::span<const CompiledCurve<T>>, double, const Samples<T>&, Work);
// NOLINTEND(bugprone-macro-parentheses)
ORISPLINE_SAMPLE(double)
ORISPLINE_SAMPLE(float)

}}  // namespace orispline
