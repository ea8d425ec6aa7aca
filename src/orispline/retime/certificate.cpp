// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/certificate.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline::inline ORISPLINE_ABI {

std::string Certificate::id_of(std::string_view part) const { return formatted("{}_{}_{}", name, part, unit_in_ids); }

std::vector<Certificate> certificates_of(const MotionLimits& limits, std::span<const SegmentPeaks> peaks) {
  std::vector<Certificate> certificates;
  const auto add = [&](std::string_view name, std::string_view unit, std::string_view unit_in_ids, double scale,
                       const std::optional<double>& limit, CertifiedPeak SegmentPeaks::*member) {
    if (!limit) return;
    const auto worst = std::ranges::max_element(peaks, {}, [&](const SegmentPeaks& p) { return (p.*member).bound; });
    const CertifiedPeak& peak = (*worst).*member;
    certificates.push_back({name, unit, unit_in_ids, *limit * scale, peak.bound * scale, peak.found * scale, peak.time,
                            static_cast<std::size_t>(worst - peaks.begin())});
  };
  add("rate", "°/s", "deg_s", degrees, limits.rate, &SegmentPeaks::rate);
  add("acceleration", "°/s²", "deg_s2", degrees, limits.acceleration, &SegmentPeaks::acceleration);
  add("torque", "N m", "nm", 1.0, limits.torque, &SegmentPeaks::torque);
  return certificates;
}

}  // namespace orispline::inline ORISPLINE_ABI
