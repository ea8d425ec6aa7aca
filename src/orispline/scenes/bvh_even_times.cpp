// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh_even_times.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr int most_parts = 64;  // of the shortest step between keys, which need not be at every frame

/// The distances of times from the first one, and how far each may be off.
class EvenTimes {
 public:
  EvenTimes(std::span<const double> times, TimeRounding rounding) : times_(times), rounding_(rounding) {}

  /// The shortest step between times that are not the same within their rounding; from 0 on where there is none.
  [[nodiscard]] StepRange shortest_step() const {
    StepRange shortest{0.0, std::numeric_limits<double>::max()};
    for (std::size_t i = 1; i < times_.size(); ++i) {
      const double step = times_[i] - times_[i - 1], off = off_at(i) + off_at(i - 1);
      if (step > off && step + off < shortest.most) shortest = {step - off, step + off};
    }
    return shortest;
  }

  /// What is left of a range of steps by all times; nothing where nothing is.
  [[nodiscard]] std::optional<StepRange> narrowed(StepRange steps) const {
    for (std::size_t i = 1; i < times_.size(); ++i) {
      const double distance = times_[i] - times_[0], off = off_at(i) + off_at(0);
      const double count = std::round(distance / steps.middle());
      if (count == 0.0 && distance <= off) continue;
      steps.least = std::max(steps.least, (distance - off) / count);
      steps.most = std::min(steps.most, (distance + off) / count);
      if (!(steps.least <= steps.most)) return std::nullopt;
    }
    return steps;
  }

  /// Whether the rounding is small beside a step: else any grid would do.
  [[nodiscard]] bool tells(double step) const {
    return 4.0 * (off_at(times_.size() - 1) + off_at(0)) < step && times_.back() - times_.front() < most_frames * step;
  }

 private:
  [[nodiscard]] double off_at(std::size_t i) const { return rounding_at(times_[i], rounding_); }

  std::span<const double> times_;
  TimeRounding rounding_;
};

}  // namespace

double rounding_at(double time, TimeRounding rounding) noexcept {
  const double of_double = 8.0 * std::numeric_limits<double>::epsilon() * std::abs(time);
  if (time == 0.0 || rounding == TimeRounding::to_double) return of_double;
  return std::ldexp(1.0, std::ilogb(time) - std::numeric_limits<float>::digits) + of_double;
}

Decimal StepRange::shortest() const {
  const int first = static_cast<int>(std::floor(std::log10(most)));
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    const int exponent = first + 1 - digits;
    const Decimal nearest = Decimal::from_double(std::round(middle() * std::pow(10.0, -exponent)));
    if (const Decimal step = nearest * Decimal::power_of_ten(exponent); has(step.to_double())) return step;
  }
  return Decimal::from_double(middle());
}

std::optional<StepRange> even_steps_of(std::span<const double> times, TimeRounding rounding) {
  const EvenTimes even(times, rounding);
  const StepRange step = even.shortest_step();
  if (step.least == 0.0) return std::nullopt;
  for (int parts = 1; parts <= most_parts; ++parts) {
    const StepRange part{step.least / parts, step.most / parts};
    if (!even.tells(part.middle())) return std::nullopt;
    if (const auto steps = even.narrowed(part)) return steps;
  }
  return std::nullopt;
}

}}}  // namespace orispline::scenes::bvh
