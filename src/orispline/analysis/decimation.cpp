// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/decimation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_parts.hpp>
#include <orispline/families/registry.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double largest_jitter = 0.35;  // of the step: neighbours meet by rounding only, where the step is 2

/// Numbers in [0, 1) that are the same on every machine, as those of std::uniform_real_distribution are not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

std::size_t moved(std::size_t index, std::size_t step, Dice& dice) {
  const double shift = largest_jitter * static_cast<double>(step) * (2.0 * dice() - 1.0);
  return static_cast<std::size_t>(std::lround(static_cast<double>(index) + shift));
}

std::size_t random_step(std::size_t step, Dice& dice) {
  const std::array steps{step / 4, step / 2, step, 2 * step};
  return std::max<std::size_t>(1, steps[static_cast<std::size_t>(4.0 * dice())]);
}

std::string ordinal(std::size_t n) {
  const std::size_t last = n % 10;
  const bool teen = n % 100 / 10 == 1;
  return formatted("{}{}", n, teen ? "th" : last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

constexpr std::size_t phases = 4;

/// The keys but every 4th of the inner ones, and those.
struct Parted {
  KeyframeData kept;
  std::vector<std::size_t> left_out;
};

Parted parted(const Keyframes& keys, std::size_t phase) {
  std::vector<std::size_t> kept, left_out;
  for (std::size_t i = 0; i < keys.size(); ++i)
    (i > 0 && i + 1 < keys.size() && i % phases == phase ? left_out : kept).push_back(i);
  return {kept_keys(keys.data(), kept), std::move(left_out)};
}

}  // namespace

std::vector<std::size_t> kept_samples(const Decimation& decimation, std::size_t samples) {
  ORISPLINE_EXPECT(decimation.keep_every >= 1);
  Dice dice(decimation.seed);
  std::vector<std::size_t> kept;
  for (std::size_t next = 0; next < samples;) {
    const bool moves = decimation.spacing == Spacing::jittered && next > 0;
    const std::size_t index = moves ? std::max(kept.back() + 1, moved(next, decimation.keep_every, dice)) : next;
    if (index < samples) kept.push_back(index);
    next += decimation.spacing == Spacing::random ? random_step(decimation.keep_every, dice) : decimation.keep_every;
  }
  return kept;
}

KeyframeData kept_keys(const KeyframeData& data, std::span<const std::size_t> kept) {
  return list_by_list(data, [kept](const auto& list) { return entries_at(list, kept); });
}

std::string name_of(const Decimation& decimation) {
  std::string every = formatted("every {}", ordinal(decimation.keep_every));
  switch (decimation.spacing) {
    case Spacing::jittered:
      return formatted("{}, jittered (seed {})", every, decimation.seed);
    case Spacing::random:
      return formatted("{} in the mean, at random (seed {})", every, decimation.seed);
    case Spacing::even:
      break;
  }
  return every;
}

Expected<DistanceStatistics> leave_out_error(const Keyframes& keys, const Method& method) {
  if (keys.size() < 3)
    return failure(ErrorCode::bad_data, formatted("found {} keys, wanted 3 to leave one out", keys.size()));
  std::vector<double> distances(keys.size() - 2);
  for (std::size_t phase = 0; phase < phases; ++phase) {
    const Parted parts = parted(keys, phase);
    if (parts.left_out.empty()) continue;
    const auto curve = Keyframes::make(parts.kept, Signs::as_given).and_then([&](const Keyframes& kept) {
      return make_curve(method, kept);
    });
    if (!curve) return tl::unexpected(curve.error());
    for (const std::size_t i : parts.left_out)
      distances[i - 1] = angular_distance((*curve)(keys.times()[i]), keys.orientations()[i]);
  }
  return distance_statistics(std::move(distances), 1);
}

}}  // namespace orispline
