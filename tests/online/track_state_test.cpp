// SPDX-License-Identifier: Apache-2.0
// The bytes of a state written by hand, field by field: they are those of the track, and with any one field changed and
// the checksum of the changed bytes they are refused for that field.
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <online/sealed_state.hpp>
#include <online/track_stream.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <support/not_finite.hpp>

namespace orispline { namespace {

using namespace testing_support;

struct MaybeReal {
  std::uint64_t there = 0;
  double number = 0.0;
};

MaybeReal known(double number) { return {1, number}; }

struct OwnFamilyFields {
  BlendingData data{};
  std::uint64_t first = 0, basis = 0;
};

struct GridFields {
  double step = 0.1;
  MaybeReal start{};
  std::uint64_t kind = 0;  // steps, rate, count, rate as a fraction, steps in parts
  double parts = 1.0, hertz = 10.0, seconds = 1.0;
  std::uint64_t count = 5, last = 0;
  std::string from{}, to{};
};

struct StretchFields {
  std::uint64_t finished = 0, first_key = 0;
  MaybeReal start{};
  std::uint64_t first_kept = 0;
  std::vector<double> times{};
  std::vector<Eigen::Quaterniond> orientations{};
  std::array<std::uint64_t, 6> has_part{};
  std::vector<Eigen::Vector3d> positions{};
  std::vector<std::vector<double>> settings{};
};

struct StateFields {
  std::uint64_t mark = 0x344b434152545249u;
  std::string family{};
  std::optional<OwnFamilyFields> own{};
  std::vector<std::pair<std::string, std::vector<double>>> parameters{};
  std::vector<std::pair<std::string, std::string>> choices{};
  std::array<std::uint64_t, 2> end_rules{};
  std::uint64_t signs = 0;
  MaybeReal gap{};
  GridFields grid{};
  std::uint64_t keys = 0, next_sample = 0;
  MaybeReal newest{}, start{}, end{};
  KeyframeReport report{};
  std::uint64_t negated = 0;
  std::array<std::uint64_t, 6> has_part{};
  std::uint64_t finished = 0;
  std::vector<StretchFields> stretches{};
};

void write(StateWriter& out, const MaybeReal& real) {
  out.whole(real.there);
  out.real(real.number);
}

void write(StateWriter& out, const OwnFamilyFields& own) {
  out.text(own.data.name);
  out.text(own.data.title);
  out.whole(own.data.parameters.size());
  for (const BlendingParameter& parameter : own.data.parameters) {
    out.text(parameter.name);
    for (const double number : {parameter.initial, parameter.lowest, parameter.highest}) out.real(number);
  }
  out.whole(own.data.rows.size());
  for (const auto& row : own.data.rows) {
    out.whole(row.size());
    for (const std::string& entry : row) out.text(entry);
  }
  out.whole(own.first);
  out.text(own.data.ends);
  out.whole(own.basis);
}

void write(StateWriter& out, const GridFields& grid) {
  out.real(grid.step);
  write(out, grid.start);
  out.whole(grid.kind);
  if (grid.kind == 4) out.real(grid.parts);
  if (grid.kind == 0 || grid.kind > 3) return;
  if (grid.kind == 2) out.whole(grid.count);
  else out.real(grid.hertz);
  if (grid.kind == 3) {
    out.real(grid.seconds);
    out.whole(grid.last);
  }
  out.text(grid.from);
  out.text(grid.to);
}

void write(StateWriter& out, const StretchFields& stretch) {
  out.whole(stretch.finished);
  out.whole(stretch.first_key);
  write(out, stretch.start);
  out.whole(stretch.first_kept);
  out.reals(stretch.times);
  for (const Eigen::Quaterniond& q : stretch.orientations)
    for (const double component : q.coeffs()) out.real(component);
  for (std::size_t part = 0; part < stretch.has_part.size(); ++part) {
    out.whole(stretch.has_part[part]);
    if (part == 0)
      for (const Eigen::Vector3d& position : stretch.positions) out.vector(position);
  }
  out.whole(stretch.settings.size());
  for (const auto& values : stretch.settings) out.reals(values);
}

StateBytes bytes_of(const StateFields& state) {
  StateWriter out;
  out.whole(state.mark);
  out.text(state.family);
  if (state.own) write(out, *state.own);
  out.whole(state.parameters.size());
  for (const auto& [name, values] : state.parameters) {
    out.text(name);
    out.reals(values);
  }
  out.whole(state.choices.size());
  for (const auto& [name, word] : state.choices) {
    out.text(name);
    out.text(word);
  }
  for (const std::uint64_t rule : state.end_rules) {
    out.whole(rule);
    out.vector(Eigen::Vector3d::Zero());
  }
  out.whole(state.signs);
  write(out, state.gap);
  write(out, state.grid);
  out.whole(state.keys);
  out.whole(state.next_sample);
  for (const MaybeReal& time : {state.newest, state.start, state.end}) write(out, time);
  for (const std::size_t count : {state.report.sign_flips, state.report.non_unit_keys}) out.whole(count);
  out.real(state.report.largest_norm_error);
  for (const std::size_t count : {state.report.near_half_turns, state.report.first_near_half_turn}) out.whole(count);
  out.whole(state.negated);
  for (const std::uint64_t is_there : state.has_part) out.whole(is_there);
  out.whole(state.finished);
  out.whole(state.stretches.size());
  for (const StretchFields& stretch : state.stretches) write(out, stretch);
  return std::move(out).sealed();
}

/// So many keys a second apart, which turn steadily.
KeyframeData turning(std::size_t count, double from = 0.0) {
  KeyframeData data;
  for (std::size_t i = 0; i < count; ++i) {
    data.times.push_back(from + static_cast<double>(i));
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, 0.3 * static_cast<double>(i))));
  }
  return data;
}

KeyframeData joined(KeyframeData keys, const KeyframeData& more) {
  keys.times.insert(keys.times.end(), more.times.begin(), more.times.end());
  keys.orientations.insert(keys.orientations.end(), more.orientations.begin(), more.orientations.end());
  return keys;
}

StretchFields stretch_of(const KeyframeData& keys) {
  return {.start = known(keys.times.front()), .times = keys.times, .orientations = keys.orientations};
}

StateFields open_track(const std::string& family, std::size_t keys) {
  const KeyframeData data = turning(keys);
  return {.family = family,
          .keys = keys,
          .newest = known(data.times.back()),
          .start = known(0.0),
          .stretches = {stretch_of(data)}};
}

StateFields ended_track(const std::string& family, std::size_t keys) {
  StateFields state = open_track(family, keys);
  state.end = state.newest;
  state.finished = state.stretches[0].finished = 1;
  return state;
}

/// Of which no segment has begun: the curve begins at the second key.
StateFields first_key_of_beta() {
  StateFields state = open_track("beta", 1);
  state.start = state.stretches[0].start = {};
  return state;
}

StateFields two_stretches() {
  StateFields state = open_track("auto", 4);
  state.gap = known(5.0);
  state.keys = 7;
  state.newest = known(12.0);
  state.stretches[0].finished = 1;
  state.stretches.push_back(stretch_of(turning(3, 10.0)));
  state.stretches[1].first_key = 4;
  return state;
}

StateFields with_positions() {
  StateFields state = open_track("auto", 3);
  state.has_part[0] = state.stretches[0].has_part[0] = 1;
  state.stretches[0].positions = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, {7.0, 8.0, 9.0}};
  return state;
}

StateFields with_settings() {
  StateFields state = open_track("tcb", 3);
  state.parameters = {{"bias", {}}};
  state.stretches[0].settings = {{0.1, 0.2, 0.3}};
  return state;
}

StateFields with_request(std::uint64_t kind) {
  StateFields state = open_track("auto", 3);
  state.grid.kind = kind;
  state.grid.step = TrackGrid().step;
  if (kind != 4) state.grid.from = "0.5";
  return state;
}

OwnFamilyFields own_family_fields() {
  return {.data = {.name = "mine",
                   .title = "Typed in",
                   .parameters = {{.name = "tension", .initial = 0.5, .lowest = -2.0, .highest = 2.0}},
                   .rows = {{"1", "1+a/3", "1", "1"}, {"0", "a/3", "1-b/3", "1"}, {"0", "0", "-b/3", "0"}},
                   .first = -1,
                   .ends = "natural"},
          .first = 2};
}

StateFields of_own_family() {
  StateFields state = open_track("", 3);
  state.own = own_family_fields();
  return state;
}

/// Of samples that were taken: the first keys are forgotten.
StateFields without_the_first_keys(std::uint64_t forgotten, std::uint64_t next_sample) {
  StateFields state = open_track("auto", 20);
  state.next_sample = next_sample;
  StretchFields& stretch = state.stretches[0];
  stretch.first_kept = forgotten;
  const auto count = static_cast<std::ptrdiff_t>(forgotten);
  stretch.times.erase(stretch.times.begin(), stretch.times.begin() + count);
  stretch.orientations.erase(stretch.orientations.begin(), stretch.orientations.begin() + count);
  return state;
}

TrackSampler sampler_of(const Method& method, const KeyframeData& keys, const TrackGrid& grid = {.step = 0.1},
                        const TrackOptions& options = {}) {
  TrackSampler sampler = TrackSampler::make(method, grid, options).value();
  EXPECT_TRUE(sampler.append(keys));
  return sampler;
}

void expect_state(const TrackSampler& sampler, StateFields fields, const char* what) {
  fields.report = sampler.report();
  const StateBytes bytes = bytes_of(fields);
  EXPECT_EQ(sampler.state(), bytes) << what;
  const auto read = TrackSampler::from_state(bytes);
  ASSERT_TRUE(read) << what << ": " << describe(read.error());
  EXPECT_EQ(read->state(), bytes) << what;
}

TEST(TrackState, IsWhatIsWrittenByHand) {
  expect_state(sampler_of("auto", turning(3)), open_track("auto", 3), "open");
  TrackSampler ended = sampler_of("auto", turning(3));
  ASSERT_TRUE(ended.finish());
  expect_state(ended, ended_track("auto", 3), "ended");
  TrackSampler single = sampler_of("beta", turning(1));
  expect_state(single, first_key_of_beta(), "before its start");
  ASSERT_TRUE(single.finish());
  expect_state(single, ended_track("beta", 1), "ended before its start");
  expect_state(sampler_of("auto", joined(turning(4), turning(3, 10.0)), {.step = 0.1}, {.gap = 5.0}), two_stretches(),
               "two stretches");
  expect_state(sampler_of("bezier", turning(4)), open_track("bezier", 4), "bezier");
  KeyframeData posed = turning(3);
  posed.positions = with_positions().stretches[0].positions;
  expect_state(sampler_of("auto", posed), with_positions(), "positions");
  TrackSampler settings = TrackSampler::make({"tcb", {.parameters = {{"bias", {}}}}}, {.step = 0.1}).value();
  ASSERT_TRUE(settings.append(turning(3), {{"bias", {0.1, 0.2, 0.3}}}));
  expect_state(settings, with_settings(), "settings");
  const Method own(BlendingFamily::make(own_family_fields().data).value());
  expect_state(sampler_of(own, turning(3)), of_own_family(), "own family");
}

TEST(TrackState, HasAllKindsOfGrids) {
  const auto from = Decimal::parse("0.5").value();
  expect_state(sampler_of("auto", turning(3), {.request = {{.spacing = SampleGrid::Rate{10.0}, .start = from}}}),
               with_request(1), "rate");
  expect_state(sampler_of("auto", turning(3), {.request = {{.spacing = SampleGrid::Count{5}, .start = from}}}),
               with_request(2), "count");
  StateFields fraction = with_request(3);
  fraction.grid.seconds = 3.0;
  fraction.grid.last = 1;
  fraction.grid.to = "1.75";
  expect_state(sampler_of("auto", turning(3),
                          {.request = {{.spacing = SampleGrid::Rate{10.0, 3.0},
                                        .start = from,
                                        .end = Decimal::parse("1.75").value(),
                                        .last = SampleGrid::LastSample::at_end}}}),
               fraction, "fraction");
  StateFields parts = with_request(4);
  parts.grid.parts = 30.0;
  parts.grid.start = known(-0.25);
  expect_state(sampler_of("auto", turning(3), {.parts = 30.0, .start = -0.25}), parts, "parts");
}

TEST(TrackState, HasNoKeysOnWhichNoComingSampleDepends) {
  TrackSampler sampler = sampler_of("auto", turning(20));
  TrackSamples samples;
  ASSERT_TRUE(take(sampler, samples, 100, false));
  const std::size_t forgotten = 20 - sampler.kept();
  ASSERT_GT(forgotten, 5u);
  expect_state(sampler, without_the_first_keys(forgotten, 100), "as many as can be");
  for (const std::size_t more : {1u, 2u}) {
    const auto read = TrackSampler::from_state(bytes_of(without_the_first_keys(forgotten + more, 100)));
    ASSERT_FALSE(read) << more;
    EXPECT_EQ(read.error().message,
              "the bytes are no state of a track: a state lacks keys on which its samples depend");
  }
}

struct Forged {
  const char* field;
  StateFields state;
  std::function<void(StateFields&)> change;
  std::string why;
};

constexpr auto too_early = "they end too early", elsewhere = "they end elsewhere",
               bounds = "one of their curves has no start or no end",
               order = "their stretches do not follow each other",
               lacking = "a state lacks keys on which its samples depend";

void expect_refused(const std::vector<Forged>& all) {
  for (const Forged& forged : all) {
    StateFields state = forged.state;
    ASSERT_TRUE(TrackSampler::from_state(bytes_of(state))) << forged.field;
    forged.change(state);
    const auto read = TrackSampler::from_state(bytes_of(state));
    ASSERT_FALSE(read) << forged.field;
    EXPECT_EQ(read.error().code, ErrorCode::bad_data) << forged.field;
    EXPECT_EQ(describe(read.error()), "the bytes are no state of a track: " + forged.why) << forged.field;
  }
}

TEST(TrackState, IsRefusedForItsMethodAndOptions) {
  const StateFields open = open_track("auto", 3), own = of_own_family();
  expect_refused({
      {"mark", open, [](auto& s) { ++s.mark; }, "their mark or their checksum is wrong"},
      {"family", open, [](auto& s) { s.family = "otto"; }, find_family("otto").error().message},
      {"parameter", open,
       [](auto& s) {
         s.parameters = {{"hold", {0.5}}};
       },
       "auto: hold is 0.5, wanted a whole number"},
      {"choice", open,
       [](auto& s) {
         s.choices = {{"form", "none"}};
       },
       "auto: unknown parameter 'form', wanted one of hold, rest-angle"},
      {"start rule", open, [](auto& s) { s.end_rules[0] = 99; }, too_early},
      {"end rule", open, [](auto& s) { s.end_rules[1] = 99; }, too_early},
      {"signs", open, [](auto& s) { s.signs = 2; }, too_early},
      {"gap there", open, [](auto& s) { s.gap.there = 2; }, too_early},
      {"gap", open, [](auto& s) { s.gap = known(0.0); }, "the gap is 0 s, wanted more than 0"},
      {"rows of an own family", own, [](auto& s) { s.own->data.rows[1][2] = "1-c/3"; },
       "row 2, entry 3, position 3: unknown name 'c', wanted a or b for the parameter, a_1 or b_1 farther out, or h, "
       "h_1, h1"},
      {"first of an own family", own, [](auto& s) { s.own->first = 6; }, too_early},
      {"basis of an own family", own, [](auto& s) { s.own->basis = 99; }, too_early},
  });
}

TEST(TrackState, IsRefusedForItsGrid) {
  const StateFields open = open_track("auto", 3);
  expect_refused({
      {"step", open, [](auto& s) { s.grid.step = -0.1; },
       "the grid starts at 0 s with the step -0.1 s, wanted finite numbers and a step greater than 0"},
      {"start there", open, [](auto& s) { s.grid.start.there = 2; }, too_early},
      {"start", open, [](auto& s) { s.grid.start = known(nan); },
       "the grid starts at nan s with the step 0.1 s, wanted finite numbers and a step greater than 0"},
      {"kind", open, [](auto& s) { s.grid.kind = 5; }, too_early},
      {"parts", with_request(4), [](auto& s) { s.grid.parts = -1.0; },
       "the grid starts at 0 s with the step -0.01 s, wanted finite numbers and a step greater than 0"},
      {"rate", with_request(1), [](auto& s) { s.grid.hertz = 0.0; }, "the rate is 0 Hz, wanted more than 0"},
      {"seconds", with_request(3), [](auto& s) { s.grid.seconds = nan; }, "the rate is nan Hz, wanted more than 0"},
      {"last", with_request(3), [](auto& s) { s.grid.last = 2; }, too_early},
      {"from", with_request(1), [](auto& s) { s.grid.from = "soon"; }, "found 'soon', wanted a number such as -1.5e-3"},
      {"to", with_request(2), [](auto& s) { s.grid.to = "1e999"; },
       "found '1e999', wanted a number between 1e-150 and 1e150 in size"},
      {"next sample", open, [](auto& s) { s.next_sample = ~std::uint64_t{0}; }, elsewhere},
  });
  StateFields instant = ended_track("auto", 1);
  instant.grid.kind = 2;
  instant.grid.count = 1;
  expect_refused({{"count", instant, [](auto& s) { s.grid.count = 5; },
                   "found 5 and a range that is the single time 0, wanted 1"}});
}

TEST(TrackState, IsRefusedForItsStartAndItsEnd) {
  const StateFields open = open_track("auto", 3), ended = ended_track("auto", 3);
  StateFields with_rate = with_request(1);
  with_rate.grid.from = "";
  expect_refused({
      {"start there", open, [](auto& s) { s.start.there = 2; }, elsewhere},
      {"start", open, [](auto& s) { s.start = known(nan); }, bounds},
      {"start of an end", ended, [](auto& s) { s.start = {}; }, bounds},
      {"end of an open track", open, [](auto& s) { s.end = known(2.0); }, bounds},
      {"endless end of an open track", open, [](auto& s) { s.end = known(infinity); }, bounds},
      {"endless end of a range", with_rate, [](auto& s) { s.end = known(infinity); }, bounds},
      {"no end", ended, [](auto& s) { s.end = {}; }, bounds},
      {"endless end", ended, [](auto& s) { s.end = known(infinity); }, bounds},
      {"no number for an end", ended, [](auto& s) { s.end = known(nan); }, bounds},
      {"finished", ended, [](auto& s) { s.finished = 2; }, bounds},
      {"negated", open, [](auto& s) { s.negated = 2; }, elsewhere},
      {"part", open, [](auto& s) { s.has_part[3] = 2; }, elsewhere},
  });
}

TEST(TrackState, IsRefusedForTheKeysOfAStretch) {
  const StateFields open = open_track("auto", 3), settings = with_settings(), bezier = open_track("bezier", 4);
  const auto first = [](auto& s) -> StretchFields& { return s.stretches[0]; };
  expect_refused({
      {"finished", open, [=](auto& s) { first(s).finished = 2; }, too_early},
      {"start there", open, [=](auto& s) { first(s).start.there = 2; }, too_early},
      {"part there", open, [=](auto& s) { first(s).has_part[1] = 2; }, too_early},
      {"a part that is not there", open, [=](auto& s) { first(s).has_part[5] = 1; }, too_early},
      {"no keys", open,
       [=](auto& s) {
         first(s).times.clear();
         first(s).orientations.clear();
       },
       "empty: no keys"},
      {"time", open, [=](auto& s) { first(s).times[1] = nan; }, "time is nan, wanted a finite number"},
      {"order of times", open, [=](auto& s) { std::swap(first(s).times[0], first(s).times[1]); },
       "time 0 comes after 1, wanted strictly increasing times"},
      {"norm", open, [=](auto& s) { first(s).orientations[2].coeffs() *= 1.01; },
       "the quaternion has norm 1.01, wanted 1 within 0.001"},
      {"position", with_positions(), [=](auto& s) { first(s).positions[1].x() = infinity; },
       "the position has a component that is not finite, wanted finite numbers"},
      {"first key between two joints", bezier, [=](auto& s) { first(s).first_kept = 1; },
       "the keys of a state begin where none can"},
      {"first key beyond all counts", open, [=](auto& s) { first(s).first_kept = std::uint64_t{1} << 62; },
       "the keys of a state begin where none can"},
      {"another setting", settings,
       [=](auto& s) {
         first(s).settings.push_back({0.1, 0.2, 0.3});
       },
       "a state has settings of other parameters"},
      {"no settings", settings, [=](auto& s) { first(s).settings.clear(); },
       "a state has settings of other parameters"},
      {"a setting of one key more", settings, [=](auto& s) { first(s).settings[0].push_back(0.4); },
       "a state has settings for another number of keys"},
      {"a setting", settings, [=](auto& s) { first(s).settings[0][2] = 101.0; },
       "a state has a setting out of its range"},
  });
}

TEST(TrackState, IsRefusedForWhatAStretchHasBegunOrEnded) {
  const StateFields open = open_track("auto", 3);
  const auto first = [](auto& s) -> StretchFields& { return s.stretches[0]; };
  expect_refused({
      {"a start before its key", first_key_of_beta(), [=](auto& s) { first(s).start = known(0.0); }, lacking},
      {"no start behind its key", open, [=](auto& s) { first(s).start = {}; }, lacking},
      {"an end without a start", ended_track("beta", 1), [=](auto& s) { first(s).start = {}; }, lacking},
      {"an end with too few keys", ended_track("beta", 4),
       [=](auto& s) {
         first(s).times.pop_back();
         first(s).orientations.pop_back();
         s.keys = 3;
         s.newest = s.end = known(2.0);
       },
       lacking},
      {"a first key that is not kept", open,
       [=](auto& s) {
         first(s).first_kept = 1;
         s.keys = 4;
       },
       lacking},
  });
}

TEST(TrackState, IsRefusedForTheOrderOfItsStretches) {
  const StateFields open = open_track("auto", 3), ended = ended_track("auto", 3), two = two_stretches(),
                    none{.family = "auto"};
  StateFields all_taken = ended;
  all_taken.stretches.clear();
  expect_refused({
      {"a newest key of none", none, [](auto& s) { s.newest = known(0.0); }, order},
      {"a stretch of no keys", open,
       [](auto& s) {
         s.keys = 0;
         s.newest = {};
       },
       order},
      {"keys without a newest one", open, [](auto& s) { s.newest = {}; }, order},
      {"all taken, without a newest key", all_taken, [](auto& s) { s.newest = {}; }, order},
      {"an open track without a stretch", open, [](auto& s) { s.stretches.clear(); }, order},
      {"a stretch that ended in an open track", open, [](auto& s) { s.stretches[0].finished = 1; }, order},
      {"an open stretch in a track that ended", ended, [](auto& s) { s.stretches[0].finished = 0; }, order},
      {"an open stretch before another", two, [](auto& s) { s.stretches[0].finished = 0; }, order},
      {"the first key of a stretch", two, [](auto& s) { ++s.stretches[1].first_key; }, order},
      {"times of two stretches", two, [](auto& s) { s.stretches[0].times.back() = 10.0; }, order},
      {"parts of no key", open, [](auto& s) { s.has_part[0] = 1; }, order},
      {"parts of keys", with_positions(), [](auto& s) { s.has_part[0] = 0; }, order},
      {"keys", open, [](auto& s) { ++s.keys; }, order},
      {"newest", open, [](auto& s) { s.newest = known(2.5); }, order},
      {"start", open, [](auto& s) { s.start = {}; }, order},
  });
}

TEST(TrackState, IsRefusedForItsLength) {
  const StateBytes bytes = unsealed(bytes_of(open_track("auto", 3)));
  const auto why = [](StateBytes forged) {
    const auto read = TrackSampler::from_state(sealed(std::move(forged)));
    return read ? "taken" : read.error().message;
  };
  StateBytes longer = bytes;
  longer.push_back(std::byte{0});
  EXPECT_EQ(why(longer), "the bytes are no state of a track: they end elsewhere");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string found = why(StateBytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
    EXPECT_TRUE(found.starts_with("the bytes are no state of a track: ")) << size << ": " << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << size;
  }
  EXPECT_TRUE(TrackSampler::from_state(sealed(bytes)));
}

}}  // namespace orispline
