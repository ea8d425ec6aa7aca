// SPDX-License-Identifier: Apache-2.0
// Keys of any kind one by one, refused ones between them: bit for bit the offline curve through those that were taken.
#include <cmath>
#include <limits>

#include <fuzz/claim.hpp>
#include <fuzz/fuzzed_method.hpp>
#include <online/online_stream.hpp>
#include <orispline/online/online_curve.hpp>

namespace orispline::fuzz { namespace {

using testing_support::FinalKeys;
using testing_support::key_of;

constexpr std::size_t most_keys = 24;

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }
bool same(const auto& a, const auto& b) {
  for (Eigen::Index k = 0; k < a.size(); ++k)
    if (!same(a[k], b[k])) return false;
  return true;
}

void claim_same(const Motion& found, const Motion& wanted, double t) {
  claim(same(found.orientation.coeffs(), wanted.orientation.coeffs()), "another orientation at t = {}", t);
  claim(same(found.angular_velocity, wanted.angular_velocity), "another angular velocity at t = {}", t);
  claim(same(found.angular_acceleration, wanted.angular_acceleration), "another angular acceleration at t = {}", t);
  claim(same(found.angular_jerk, wanted.angular_jerk), "another angular jerk at t = {}", t);
}

void claim_same(const LinearMotion& found, const LinearMotion& wanted, double t) {
  claim(same(found.position, wanted.position) && same(found.velocity, wanted.velocity) &&
            same(found.acceleration, wanted.acceleration) && same(found.jerk, wanted.jerk),
        "another position, or rates of it, at t = {}", t);
}

/// What is available of the online curve and lies on segments from `start` on, at four times of each.
void claim_same_from(double start, const OnlineCurve& online, const PoseCurve& offline) {
  const auto available = online.available();
  if (!available) return;
  const Knots& knots = offline.orientation.knots();
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const KnotSpan span = knots.span(i);
    if (span.start() < std::max(start, available->start) || span.end() > available->end) continue;
    for (int k = 0; k <= 4; ++k) {
      const double t = k == 4 ? span.end() : span.start() + span.step() * k / 4.0;
      const Side side = k == 4 ? Side::left : Side::right;
      claim_same(online.motion(t, side), offline.orientation.motion(t, side), t);
      const auto position = online.linear_motion(t, side);
      claim(position.has_value() == offline.position.has_value(), "a position that there is not");
      if (position) claim_same(*position, offline.position->linear_motion(t, side), t);
    }
  }
}

/// A key that cannot be taken after this one; which, the input decides.
StreamKey refused_key(FuzzInput& input, StreamKey key, bool is_first) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto fault = is_first ? input.below(4) : input.below(6);
  if (fault == 0) key.time = nan;
  if (fault == 1) key.time = infinity;
  if (fault == 2) key.orientation.coeffs() *= 1.01;
  if (fault == 3) key.orientation.x() = nan;
  if (fault == 5) key.time -= 1.0;
  if (fault == 4 || fault == 5) return key;  // the time of a key that was taken, or one before it
  if (std::isfinite(key.time)) key.time += 1.0;
  return key;
}

void claim_refused(OnlineCurve& online, const StreamKey& key) {
  const auto keys = online.keys();
  const auto available = online.available();
  const auto taken = online.append(key);
  claim(!taken, "a key that cannot be taken was taken");
  claim_plain(taken.error());
  const auto after = online.available();
  claim(online.keys() == keys && available.has_value() == after.has_value(), "a refused key counts");
  if (after) claim(after->start == available->start && after->end == available->end, "a refused key is available");
}

/// Keys whose curve cannot be made are refused by finish() with the same words.
void claim_finished(OnlineCurve& online, const Expected<PoseCurve>& offline) {
  const auto finished = online.finish();
  if (offline) return claim(finished.has_value(), "finish() refuses: {}", finished ? "" : describe(finished.error()));
  claim(!finished.has_value(), "finish() takes what make_curve refuses: {}", describe(offline.error()));
  claim(describe(finished.error()) == describe(offline.error()), "finish() says '{}', make_curve '{}'",
        describe(finished.error()), describe(offline.error()));
}

void try_stream(const Method& method, const FuzzedKeys& fuzzed, FuzzInput& input) {
  const std::size_t capacity = OnlineCurve::least_capacity + input.below(most_keys);
  auto online = OnlineCurve::make(method, capacity, fuzzed.signs);
  if (!online) return claim_plain(online.error());
  const auto keys = Keyframes::make(fuzzed.data, fuzzed.signs);
  if (!keys) return claim_plain(keys.error());
  const auto offline = make_pose_curve(method, *keys);
  double known = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < keys->size(); ++i) {
    const bool disturbed = input.below(4) == 1;
    if (disturbed) claim_refused(*online, refused_key(input, key_of(fuzzed.data, i == 0 ? 0 : i - 1), i == 0));
    const auto taken = online->append(key_of(fuzzed.data, i));
    if (!taken) return claim_plain(taken.error());
    if (offline) claim_same_from(known, *online, *offline);
    if (const auto available = online->available()) known = available->end;
  }
  claim_finished(*online, offline);
  if (offline) claim_same_from(-std::numeric_limits<double>::infinity(), *online, *offline);
  online->reset();
  claim(online->keys() == 0 && !online->available(), "reset() keeps keys");
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  FuzzInput input(data, size);
  const auto names = OnlineCurve::methods();
  const FamilyInfo& family = *find_family(names[input.below(names.size())]).value();
  FuzzInput of_method = input.part(32);
  FuzzInput of_stream = input.part(32);
  const FuzzedKeys fuzzed = fuzzed_keys(input, most_keys);
  const Method method = fuzzed_method(of_method, family, fuzzed, Given::for_all);
  const Situation situation([&] { return told(method, fuzzed); });
  try_stream(method, fuzzed, of_stream);
  return 0;
}
