// SPDX-License-Identifier: Apache-2.0
#include <orispline/batch/sample.hpp>

#include <algorithm>

#include <orispline/base/parallel.hpp>
#include <orispline/batch/sample_layout.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t part_size =
    4096;  // times that a thread looks at: far dearer than the thread where all are outside

bool is_outside(const Domain& domain, double t) noexcept { return t < domain.start || t > domain.end; }

}  // namespace

Expected<void> check_inside(const AnyCurve& curve, std::span<const double> times) {
  const auto stray = std::ranges::find_if(times, [domain = curve.domain()](double t) { return is_outside(domain, t); });
  if (stray == times.end()) return {};
  Error error = curve.checked_motion(*stray).error();
  error.where.time_index = static_cast<std::size_t>(stray - times.begin());
  return tl::unexpected(std::move(error));
}

template <class T>
Expected<void> extrapolate(const PoseCurve& curve, std::span<const double> times, Extrapolation how,
                           const Samples<T>& out, Work work) {
  if (auto error = batch::check_room(out, times.size())) return tl::unexpected(std::move(*error));
  if (auto error = batch::check_positions(curve, out)) return tl::unexpected(std::move(*error));
  if (how == Extrapolation::hold) return {};
  if (how == Extrapolation::error) return check_inside(curve.orientation, times);
  const Domain domain = curve.orientation.domain();
  parallel_for((times.size() + part_size - 1) / part_size, work.threads, [&](std::size_t part) {
    for (std::size_t k = part * part_size; k < std::min(times.size(), (part + 1) * part_size); ++k) {
      if (!is_outside(domain, times[k])) continue;
      batch::put(out, k, extrapolated(curve.orientation, times[k], how));
      if (wants_positions(out)) batch::put(out, k, extrapolated(*curve.position, times[k], how));
    }
  });
  return {};
}

template Expected<void> extrapolate<double>(const PoseCurve&, std::span<const double>, Extrapolation,
                                            const Samples<double>&, Work);
template Expected<void> extrapolate<float>(const PoseCurve&, std::span<const double>, Extrapolation,
                                           const Samples<float>&, Work);

}}  // namespace orispline
