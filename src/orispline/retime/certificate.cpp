// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/motion_limits.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// How a limited vector is named and shown.
struct Naming {
  std::string_view name, id;
  Unit shown, in_ids;
};

/// In the order of LimitedQuantity::Vector.
constexpr std::array namings{
    Naming{"rate", "rate", {"°/s", radians_per_degree}, {"deg_s", radians_per_degree}},
    Naming{"acceleration", "acceleration", {"°/s²", radians_per_degree}, {"deg_s2", radians_per_degree}},
    Naming{"jerk", "jerk", {"°/s³", radians_per_degree}, {"deg_s3", radians_per_degree}},
    Naming{"torque", "torque", {"N m", 1.0}, {"nm", 1.0}},
    Naming{"speed", "speed", {"m/s", 1.0}, {"m_s", 1.0}},
    Naming{"linear acceleration", "linear_acceleration", {"m/s²", 1.0}, {"m_s2", 1.0}}};

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

}  // namespace

std::string Certificate::id_of(std::string_view part) const { return formatted("{}_{}_{}", id, part, in_ids.name); }

std::string Certificate::text_of(double value) const { return formatted("{:.6g} {}", value / shown.size, shown.name); }

std::vector<Certificate> certificates_of(const MotionLimits& limits, std::span<const SegmentPeaks> peaks) {
  std::vector<Certificate> certificates;
  const auto quantities = quantities_of(limits);
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const LimitedQuantity& quantity = quantities[k];
    const auto worst = std::ranges::max_element(peaks, {}, [k](const SegmentPeaks& p) { return p[k].bound; });
    const CertifiedPeak& peak = (*worst)[k];
    const Naming& naming = namings[static_cast<std::size_t>(quantity.vector)];
    const std::string_view preposition = quantity.is_of_position() ? "along" : "about";
    certificates.push_back(
        {.name = quantity.axis ? formatted("{} {} {}", naming.name, preposition, axes[*quantity.axis])
                               : std::string(naming.name),
         .id = quantity.axis ? formatted("{}_{}", naming.id, axes[*quantity.axis]) : std::string(naming.id),
         .shown = quantity.stated_in.name.empty() ? naming.shown : quantity.stated_in,
         .in_ids = naming.in_ids,
         .limit = quantity.limit,
         .bound = peak.bound,
         .found = peak.found,
         .time = peak.time,
         .segment = static_cast<std::size_t>(worst - peaks.begin()),
         .body = peak.body});
  }
  return certificates;
}

}}  // namespace orispline
