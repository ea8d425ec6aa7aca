// SPDX-License-Identifier: Apache-2.0
// Contract: a segment depends on exactly as many keys as declared, a tension at a key on the two segments beside it.
#include <contract/family_contract.hpp>

namespace orispline::contract {
namespace {

using namespace testing_support;

constexpr std::size_t key_count = 12;

/// True where the two curves differ visibly on a segment; bitwise equality counts as equal, anything between fails.
bool segment_changed(const AnyCurve& before, const AnyCurve& after, std::size_t segment) {
  bool changed = false;
  for (const double u : {0.2, 0.5, 0.8}) {
    const KnotSpan a = before.knots().span(segment), b = after.knots().span(segment);
    const Motion m = before.motion(a.start() + u * a.step()), n = after.motion(b.start() + u * b.step());
    if (m.orientation.coeffs() == n.orientation.coeffs() && m.angular_jerk == n.angular_jerk) continue;
    changed = true;
    EXPECT_GT(relative_error(n.orientation, m.orientation), tolerance::algebra) << "a change of rounding size";
  }
  return changed;
}

class LocalityContract : public FamilyContract {
 protected:
  /// Keys that segment i may depend on: as many on either side.
  [[nodiscard]] static bool within_support(std::size_t key, std::size_t segment) {
    const auto beyond = static_cast<std::size_t>(GetParam().support_keys / 2 - 1);
    return key + beyond >= segment && key <= segment + 1 + beyond;
  }
  /// Segments away from the ends, which feel their end rule.
  static constexpr std::array<std::size_t, 5> inner_segments{3, 4, 5, 6, 7};
};

TEST_P(LocalityContract, SegmentFeelsTheKeysOfItsSupportAndNoOthers) {
  const KeyframeData data = random_walk(31, key_count, Spacing::uneven);
  const AnyCurve before = curve(keyframes(data));
  for (std::size_t moved = 0; moved < key_count; ++moved) {
    KeyframeData other = data;
    other.orientations[moved] = other.orientations[moved] * exp<double>(Eigen::Vector3d(0.3, -0.2, 0.4));
    const AnyCurve after = curve(keyframes(other));
    for (const std::size_t segment : inner_segments)
      EXPECT_EQ(segment_changed(before, after, segment), within_support(moved, segment))
          << "key " << moved << ", segment " << segment;
  }
}

TEST_P(LocalityContract, KeyTimesBeyondTheSupportDoNotMatter) {
  const KeyframeData data = random_walk(32, key_count, Spacing::uneven);
  const AnyCurve before = curve(keyframes(data));
  for (std::size_t moved = 0; moved < key_count; ++moved) {
    KeyframeData other = data;
    other.times[moved] += 0.03;
    const AnyCurve after = curve(keyframes(other));
    for (const std::size_t segment : inner_segments)
      if (!within_support(moved, segment)) {
        EXPECT_FALSE(segment_changed(before, after, segment)) << "key " << moved << ", segment " << segment;
      }
  }
}

TEST_P(LocalityContract, ParameterAtAKeyTouchesExactlyItsTwoSegments) {
  const Keyframes keys = keyframes(random_walk(33, key_count, Spacing::uneven));
  for (const Parameter& parameter : GetParam().parameters) {
    if (!parameter.per_key) continue;
    const std::vector<double> everywhere(key_count, parameter.initial);
    const AnyCurve before = curve(keys, {.parameters = {{std::string(parameter.name), everywhere}}});
    for (std::size_t key = 0; key < key_count; ++key) {
      std::vector<double> here = everywhere;
      here[key] += 0.2;
      const AnyCurve after = curve(keys, {.parameters = {{std::string(parameter.name), here}}});
      for (const std::size_t segment : inner_segments)
        EXPECT_EQ(segment_changed(before, after, segment), key == segment || key == segment + 1)
            << parameter.name << " of key " << key << ", segment " << segment;
    }
  }
}

TEST_P(LocalityContract, OneValueMeansTheSameForEveryKey) {
  const Keyframes keys = keyframes(random_walk(34, 6, Spacing::uneven));
  for (const Parameter& parameter : GetParam().parameters) {
    const std::string name(parameter.name);
    const AnyCurve one = curve(keys, {.parameters = {{name, {0.37}}}});
    const AnyCurve each = curve(keys, {.parameters = {{name, std::vector(6, 0.37)}}});
    for (const double t : sample_times(keys.times())) EXPECT_EQ(one(t).coeffs(), each(t).coeffs());
  }
}

ORISPLINE_FOR_EVERY_FAMILY(LocalityContract);

}  // namespace
}  // namespace orispline::contract
