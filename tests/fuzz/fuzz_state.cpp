// SPDX-License-Identifier: Apache-2.0
// The state of a track, put away between two keys: as it was it goes on bit for bit. Changed and sealed anew, so that
// its checksum is right, it is refused in plain words or is the state of another track that can be used.
#include <cmath>
#include <limits>

#include <fuzz/claim.hpp>
#include <fuzz/fuzzed_method.hpp>
#include <online/online_stream.hpp>
#include <online/sealed_state.hpp>
#include <orispline/online/track_sampler.hpp>
#include <support/tolerance.hpp>

namespace orispline::fuzz { namespace {

using Bytes = testing_support::StateBytes;

constexpr std::size_t most_keys = 16, most_changes = 4, word = 8;
/// Grids of wild times have a sample for every atom: the first ones are looked at.
constexpr std::uint64_t most_samples = 64;

TrackGrid fuzzed_grid(FuzzInput& input) {
  constexpr std::array steps{0.01, 1.0 / 64.0, 0.25, 1.0, 1e-6, 1e5, 0.1, 7.0};  // [s]
  TrackGrid grid{.step = steps[input.below(steps.size())]};
  const std::size_t kind = input.below(6), part = input.below(8);
  if (kind == 1) grid.start = input.signed_unit();
  if (kind == 2) grid.parts = 30.0;
  if (kind < 3) return grid;
  SampleGrid::Request request{.spacing = SampleGrid::Count{2 + 5 * part}};
  if (kind == 4) request.spacing = SampleGrid::Rate{1.0 / grid.step};
  if (kind == 5) request = {.spacing = SampleGrid::Rate{30000.0, 1001.0}, .last = SampleGrid::LastSample::at_end};
  if (part % 2 == 1) request.start = Decimal::from_double(input.signed_unit());
  if (part % 4 > 1) request.end = Decimal::from_double(8.0 * input.signed_unit());
  grid.request = request;
  return grid;
}

TrackOptions fuzzed_options(FuzzInput& input, Signs signs) {
  constexpr std::array gaps{0.0, 0.3, 1.0, 100.0};  // [s], the first for none
  const double gap = gaps[input.below(gaps.size())];
  return {.signs = signs, .gap = gap > 0.0 ? std::optional(gap) : std::nullopt};
}

/// What a word of a state may become: numbers of things, of samples, and reals.
std::uint64_t hostile_word(FuzzInput& input) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::array reals{0.0,      -0.0,      1.0,   -1.0,   std::numeric_limits<double>::quiet_NaN(),
                             infinity, -infinity, 1e308, 5e-324, 1e-9,
                             9e15,     1.7e9};
  constexpr std::array<std::uint64_t, 8> wholes{
      0, 1, 2, 3, std::uint64_t{1} << 32, std::uint64_t{1} << 53, std::uint64_t{1} << 62, ~std::uint64_t{0}};
  const std::size_t k = input.below(reals.size() + wholes.size());
  return k < reals.size() ? std::bit_cast<std::uint64_t>(reals[k]) : wholes[k - reals.size()];
}

/// One change of bytes that are not sealed.
void change(Bytes& bytes, FuzzInput& input) {
  if (bytes.empty()) return;
  const std::size_t at = (input.byte() + 256u * input.byte()) % bytes.size();
  const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  const auto rest = static_cast<std::ptrdiff_t>(std::min(word, bytes.size() - at));
  const auto put = [&](std::uint64_t number) {
    for (std::ptrdiff_t k = 0; k < rest; ++k) place[k] = static_cast<std::byte>(number >> 8 * k & 0xffu);
  };
  switch (input.below(6)) {
    case 0:
      *place ^= static_cast<std::byte>(input.byte());
      break;
    case 1:
      *place = static_cast<std::byte>(std::to_integer<unsigned>(*place) + input.byte());
      break;
    case 2:
      put(hostile_word(input));
      break;
    case 3:
      bytes.erase(place, place + rest);
      break;
    case 4: {
      const Bytes again(place, place + rest);
      bytes.insert(place, again.begin(), again.end());
      break;
    }
    case 5:
      bytes.resize(at + 1);
      break;
  }
}

/// The first of the samples that are ready, each with its time.
struct Taken {
  Expected<void> done{};
  std::size_t count = 0;
  std::vector<double> times{}, orientations{}, angular_velocities{}, angular_jerks{}, positions{};
};

Taken take(TrackSampler& sampler, bool positions) {
  const auto count = static_cast<std::size_t>(std::min(sampler.ready(), most_samples));
  Taken taken{.count = count};
  for (auto* list : {&taken.angular_velocities, &taken.angular_jerks}) list->resize(3 * count);
  taken.times.resize(count);
  taken.orientations.resize(4 * count);
  if (positions) taken.positions.resize(3 * count);
  taken.done = sampler.take({.orientations = taken.orientations,
                             .angular_velocities = taken.angular_velocities,
                             .angular_jerks = taken.angular_jerks,
                             .positions = taken.positions},
                            taken.times);
  return taken;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

void claim_same(const Expected<void>& found, const Expected<void>& wanted, const char* what) {
  claim(found.has_value() == wanted.has_value(), "{}: one is refused: {}", what,
        describe(found ? wanted.error() : found.error()));
  if (!found) claim(describe(found.error()) == describe(wanted.error()), "{}: another refusal", what);
}

/// Takes what is ready of both, appends the other keys, ends them.
void claim_goes_on_alike(TrackSampler& found, TrackSampler& wanted, const KeyframeData& data, std::size_t next) {
  const auto claim_alike = [&] {
    claim(found.ready() == wanted.ready(), "{} samples are ready, wanted {}", found.ready(), wanted.ready());
    const Taken a = take(found, !data.positions.empty()), b = take(wanted, !data.positions.empty());
    claim_same(a.done, b.done, "taking");
    if (!a.done) return;
    claim(same(a.times, b.times) && same(a.orientations, b.orientations) &&
              same(a.angular_velocities, b.angular_velocities) && same(a.angular_jerks, b.angular_jerks) &&
              same(a.positions, b.positions),
          "a sample has other bits");
  };
  claim_alike();
  for (; next < data.times.size(); ++next) {
    const StreamKey key = testing_support::key_of(data, next);
    claim_same(found.append(key), wanted.append(key), "appending");
    claim_alike();
  }
  claim_same(found.finish(), wanted.finish(), "finishing");
  claim_alike();
  claim(found.state() == wanted.state(), "the last state is another");
}

void claim_sound(TrackSampler& sampler) {
  const Taken taken = take(sampler, false);
  if (!taken.done) return claim_plain(taken.done.error());
  for (std::size_t i = 0; i < taken.count; ++i) {
    const Eigen::Map<const Eigen::Vector4d> q(taken.orientations.data() + 4 * i);
    claim(std::abs(q.norm() - 1.0) <= tolerance::algebra, "sample {} has the norm {}", i, q.norm());
    claim(i == 0 || taken.times[i - 1] <= taken.times[i], "the time of sample {} is before that of the last", i);
  }
}

/// A track that nobody has made, if it is one.
void claim_lives(const Bytes& state, const KeyframeData& data, std::size_t next) {
  auto sampler = TrackSampler::from_state(state);
  if (!sampler) {
    claim(sampler.error().code == ErrorCode::bad_data, "another kind of error");
    return claim_plain(sampler.error());
  }
  const Bytes again = sampler->state();
  const auto copy = TrackSampler::from_state(again);
  claim(copy.has_value(), "its own state is refused: {}", copy ? "" : describe(copy.error()));
  claim(copy->state() == again, "a state is another when it is put away again");
  claim_sound(*sampler);
  for (; next < data.times.size(); ++next) {
    const auto taken = sampler->append(testing_support::key_of(data, next));
    if (!taken) claim_plain(taken.error());
    claim_sound(*sampler);
  }
  const auto finished = sampler->finish();
  if (!finished) claim_plain(finished.error());
  claim_sound(*sampler);
}

void try_state(FuzzInput& of_track, FuzzInput& of_changes, const Method& method, const FuzzedKeys& fuzzed) {
  const TrackGrid grid = fuzzed_grid(of_track);
  auto sampler = TrackSampler::make(method, grid, fuzzed_options(of_track, fuzzed.signs));
  if (!sampler) return claim_plain(sampler.error());
  const KeyframeData& data = fuzzed.data;
  const std::size_t put_away = of_track.below(data.times.size() + 1);
  const bool is_looked_at = of_track.below(2) == 1;
  for (std::size_t i = 0; i < put_away; ++i) {
    if (const auto taken = sampler->append(testing_support::key_of(data, i)); !taken) return claim_plain(taken.error());
    if (is_looked_at) claim_sound(*sampler);
  }
  Bytes state = sampler->state();
  auto restored = TrackSampler::from_state(state);
  claim(restored.has_value(), "a state is refused: {}", restored ? "" : describe(restored.error()));
  claim(restored->state() == state, "a state is another when it is put away again");
  claim_goes_on_alike(*restored, *sampler, data, put_away);
  const std::size_t changes = of_changes.below(most_changes + 1);
  if (changes == 0) return;
  state = testing_support::unsealed(std::move(state));
  for (std::size_t i = 0; i < changes; ++i) change(state, of_changes);
  claim_lives(testing_support::sealed(std::move(state)), data, put_away);
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  FuzzInput input(data, size);
  const auto families = families_info();
  const FamilyInfo& family = families[input.below(families.size())];
  FuzzInput of_method = input.part(32);
  FuzzInput of_track = input.part(16);
  FuzzInput of_changes = input.part(32);
  const FuzzedKeys fuzzed = fuzzed_keys(input, most_keys);
  const Method method = fuzzed_method(of_method, family, fuzzed, Given::for_all);
  const Situation situation([&] { return told(method, fuzzed); });
  try_state(of_track, of_changes, method, fuzzed);
  return 0;
}
