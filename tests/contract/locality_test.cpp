// SPDX-License-Identifier: Apache-2.0
// Contract: a segment depends on exactly as many keys as declared, and a parameter at a key on no more than it says.
// The segments of a solved family depend on all keys, the less the further these are.
#include <contract/family_contract.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

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

/// The same orientations on a segment, at other times.
void expect_stretched(const AnyCurve& before, const AnyCurve& after, std::size_t segment) {
  for (const double u : {0.2, 0.5, 0.8}) {
    const KnotSpan a = before.knots().span(segment), b = after.knots().span(segment);
    EXPECT_TRUE(near(after(b.start() + u * b.step()), before(a.start() + u * a.step()), tolerance::algebra)) << segment;
  }
}

class LocalityContract : public FamilyContract {
 protected:
  static constexpr std::size_t segment_count = 11;
  /// Segments away from the ends, which feel their end rule.
  static constexpr std::array<std::size_t, 5> inner_segments{3, 4, 5, 6, 7};
  /// The keys at the ends of a segment.
  [[nodiscard]] static std::size_t key_at_start(std::size_t segment) { return use().first + segment * use().stride; }
  [[nodiscard]] static std::size_t key_at_end(std::size_t segment) { return key_at_start(segment) + use().stride; }

  /// Weights of models that depend on all keys are not felt everywhere: only where what is found is given as settings
  /// is there a support, to which tests of the family hold it.
  static constexpr const char* by_settings = "local only where settings give what it finds of the keys";
  [[nodiscard]] static bool is_local_by_settings() { return GetParam().is_global() && GetParam().keys_beside; }

  /// Keys that a segment may depend on, as many on either side, and so many more.
  [[nodiscard]] static bool within_support(std::size_t key, std::size_t segment, std::size_t more = 0) {
    if (GetParam().is_global()) return true;
    const std::size_t beyond = GetParam().reach() + more;
    return key + beyond >= key_at_start(segment) && key <= key_at_end(segment) + beyond;
  }
  [[nodiscard]] static bool parameter_acts(std::size_t key, std::size_t segment) {
    if (GetParam().is_global() && GetParam().parameters.front().ghosts > 0) return true;
    if (GetParam().is_global())
      return key > 0 && key < use().keys_for(segment_count) - 1;  // they join segments: none at an end
    if (use().parameters_reach_far) return within_support(key, segment);
    return key == key_at_start(segment) || key == key_at_end(segment);
  }
};

TEST_P(LocalityContract, SegmentFeelsTheKeysOfItsSupportAndNoOthers) {
  if (is_local_by_settings()) GTEST_SKIP() << by_settings;
  const KeyframeData data = walk(34, segment_count, Spacing::uneven);  // no turn is so sharp that biarcs stop
  const AnyCurve before = curve(keyframes(data));
  for (std::size_t moved = 0; moved < data.times.size(); ++moved) {
    KeyframeData other = data;
    other.orientations[moved] = other.orientations[moved] * exp<double>(Eigen::Vector3d(0.06, -0.04, 0.08));
    const AnyCurve after = curve(keyframes(other));
    for (const std::size_t segment : inner_segments)
      EXPECT_EQ(segment_changed(before, after, segment), within_support(moved, segment))
          << "key " << moved << ", segment " << segment;
  }
}

TEST_P(LocalityContract, KeyTimesBeyondTheSupportDoNotMatter) {
  if (is_local_by_settings()) GTEST_SKIP() << by_settings;
  const KeyframeData data = walk(32, segment_count, Spacing::uneven);
  const AnyCurve before = curve(keyframes(data));
  for (std::size_t moved = 0; moved < data.times.size(); ++moved) {
    KeyframeData other = data;
    other.times[moved] += 0.03;
    const AnyCurve after = curve(keyframes(other));
    for (const std::size_t segment : inner_segments)
      if (!use().feels_times) {
        expect_stretched(before, after, segment);
      } else if (!within_support(moved, segment, use().further_times)) {
        EXPECT_FALSE(segment_changed(before, after, segment)) << "key " << moved << ", segment " << segment;
      } else if (use().further_times > 0 || GetParam().is_global()) {
        EXPECT_TRUE(segment_changed(before, after, segment)) << "key " << moved << ", segment " << segment;
      }
  }
}

TEST_P(LocalityContract, ParameterAtAKeyTouchesExactlyTheSegmentsThatItMay) {
  const Keyframes keys = keyframes(walk(33, segment_count, Spacing::uneven));
  std::map<std::string, std::vector<double>, std::less<>> everywhere;
  for (const Parameter& p : GetParam().parameters)  // at the highest order every tension acts
    everywhere[std::string(p.name)] = p.per_key ? std::vector(keys.size(), p.initial) : std::vector{p.highest};
  const AnyCurve before = curve(keys, {.parameters = everywhere});
  for (const Parameter& parameter : GetParam().parameters) {
    if (!parameter.per_key) continue;
    for (std::size_t key = 0; key < keys.size(); ++key) {
      auto here = everywhere;
      here[std::string(parameter.name)][key] += 0.2;
      const AnyCurve after = curve(keys, {.parameters = here});
      for (const std::size_t segment : inner_segments)
        EXPECT_EQ(segment_changed(before, after, segment), parameter_acts(key, segment))
            << parameter.name << " of key " << key << ", segment " << segment;
    }
  }
}

TEST_P(LocalityContract, OneValueMeansTheSameForEveryKey) {
  const Keyframes keys = keyframes(walk(34, 5, Spacing::uneven));
  for (const Parameter& parameter : GetParam().parameters) {
    const std::string name(parameter.name);
    const double value = parameter.per_key ? 0.37 : parameter.highest;
    const AnyCurve one = curve(keys, {.parameters = {{name, {value}}}});
    const auto each = make_curve({GetParam().name, {.parameters = {{name, std::vector(keys.size(), value)}}}}, keys);
    ASSERT_EQ(each.has_value(), parameter.per_key) << name;
    if (!each) continue;
    for (const double t : times_on(one)) EXPECT_EQ(one(t).coeffs(), (*each)(t).coeffs());
  }
}

ORISPLINE_FOR_EVERY_FAMILY(LocalityContract);

/// Largest difference of orientation on a segment [rad].
double change_on(const AnyCurve& before, const AnyCurve& after, std::size_t segment) {
  const KnotSpan span = before.knots().span(segment);
  double largest = 0.0;
  for (const double u : {0.2, 0.5, 0.8})
    largest = std::max(largest,
                       angular_distance(before(span.start() + u * span.step()), after(span.start() + u * span.step())));
  return largest;
}

class InfluenceContract : public FamilyContract {};

TEST_P(InfluenceContract, OfAKeyDiesAwayWithTheKeysBetween) {
  constexpr std::size_t segment_count = 11;
  const KeyframeData data = walk(35, segment_count, Spacing::even, 0.8);
  const AnyCurve before = curve(keyframes(data));
  for (const std::size_t moved : {0u, 4u, 6u, 11u}) {
    KeyframeData other = data;
    other.orientations[moved] = other.orientations[moved] * exp<double>(Eigen::Vector3d(0.3, -0.2, 0.4));
    const AnyCurve after = curve(keyframes(other));
    for (std::size_t segment = 0; segment < segment_count; ++segment) {
      const std::size_t keys_between = segment >= moved ? segment - moved : moved - segment - 1;
      const double change = change_on(before, after, segment);
      EXPECT_LT(change, 1.2 * std::pow(0.5, keys_between)) << "key " << moved << ", segment " << segment;
      EXPECT_GT(change, keys_between < 4 ? tolerance::visible_jump : tolerance::rates)
          << "key " << moved << ", segment " << segment;
    }
  }
}

std::vector<FamilyInfo> solved_families() {
  std::vector<FamilyInfo> families(families_info().begin(), families_info().end());
  std::erase_if(families, [](const FamilyInfo& family) { return !family.is_global() || family.keys_beside; });
  return families;
}

INSTANTIATE_TEST_SUITE_P(Family, InfluenceContract, testing::ValuesIn(solved_families()), test_name);

}}  // namespace orispline::contract
