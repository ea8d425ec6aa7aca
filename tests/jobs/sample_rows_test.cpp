// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/sample_rows.hpp>
#include <orispline/jobs/sample_stream.hpp>

#include <gtest/gtest.h>

#include <cmath>

#include <orispline/jobs/curve_of_keys.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

/// A row as it would be written: its time, and its orientation if it has one.
struct Row {
  double time = 0.0;
  std::optional<Eigen::Quaterniond> orientation{};

  friend bool operator==(const Row& a, const Row& b) {
    return a.time == b.time && a.orientation.has_value() == b.orientation.has_value() &&
           (!a.orientation || a.orientation->coeffs() == b.orientation->coeffs());
  }
};

/// Gathers rows; refuses samples later than a time.
class Gathered final : public RowSink {
 public:
  explicit Gathered(double refused_from = 1e9) : refused_from_(refused_from) {}

  void clear(std::size_t rooms) override { rooms_.assign(rooms, {}); }
  [[nodiscard]] Expected<void> add(std::size_t room, const TimeOrigin& origin, const SampleBlock& samples,
                                   std::size_t k) override {
    if (samples.time(k) >= refused_from_) return failure(ErrorCode::bad_data, "refused");
    rooms_[room].push_back({origin.nearest_plus(samples.offset(k)), samples.motion(k).orientation});
    return {};
  }
  void add_empty(std::size_t room, const TimeOrigin& origin, double offset) override {
    rooms_[room].push_back({origin.nearest_plus(offset)});
  }
  [[nodiscard]] Expected<void> write(std::size_t room, const SampleSource&) override {
    rows.insert(rows.end(), rooms_[room].begin(), rooms_[room].end());
    return {};
  }
  void written(std::size_t samples) override { told = samples; }

  std::vector<Row> rows;
  std::size_t told = 0;

 private:
  double refused_from_;
  std::vector<std::vector<Row>> rooms_;
};

/// Keys at 0, 1, … s of an epoch.
Track keys() {
  Track track = turns_of({0.0, 0.5, 0.7, 1.5, 1.6, 2.0});
  track.epoch = Decimal::from_double(1700000000.0);
  return track;
}

TimeRequest rate(double hertz) { return {.spacing = SampleGrid::Rate{hertz}, .from = {}, .to = {}}; }

RowCounts rows_of(const Track& track, const TimeRequest& times, const RowPolicy& policy, Gathered& sink,
                  Extrapolation extrapolation = Extrapolation::hold) {
  const PoseCurve curve = shaped_curve("auto", track).value();
  const TimesOnCurve wanted = times_on_curve(times, track.epoch, curve.orientation.domain(), extrapolation).value();
  CurveSamples samples(curve, wanted.times, {extrapolation});
  return sample_rows(samples, {}, policy, sink).value();
}

TEST(SampleRows, AreTheSameOnAnyNumberOfThreads) {
  Gathered one, three;
  const TimeRequest dense = rate(20000.0);  // more than are made at a time
  EXPECT_EQ(rows_of(keys(), dense, {.threads = 1}, one).samples, 100001u);
  EXPECT_EQ(rows_of(keys(), dense, {.threads = 3}, three).samples, one.rows.size());
  EXPECT_TRUE(one.rows == three.rows);
  EXPECT_EQ(one.told, one.rows.size());
  EXPECT_EQ(one.rows.front().time, 1700000000.0);
}

TEST(SampleRows, OutsideTheCurveAreMadeOrLeftOut) {
  TimeRequest times = rate(1.0);
  times.from = TimeBound{Decimal::from_double(-2.0), true};
  Gathered made, left_out;
  const RowCounts counts = rows_of(keys(), times, {}, made);
  EXPECT_EQ(counts.outside, 2u);
  EXPECT_EQ(counts.rows({}), made.rows.size());
  const RowPolicy policy{.outside = OutsideRows::left_out};
  EXPECT_EQ(rows_of(keys(), times, policy, left_out).rows(policy), made.rows.size() - 2);
  EXPECT_EQ(left_out.rows.size(), made.rows.size() - 2);
}

TEST(SampleRows, InGapsAreLeftOutOrHaveATimeAlone) {
  Track track = keys();
  std::vector<double> times(track.keys.times().begin(), track.keys.times().end());
  for (std::size_t k = 3; k < times.size(); ++k) times[k] += 5.0;
  track.keys = track.keys.with_times(times).value();
  track.recipe.gap = 2.0;
  Gathered left_out, empty;
  const RowCounts counts = rows_of(track, rate(2.0), {.gaps = GapRows::left_out}, left_out);
  EXPECT_GT(counts.in_gaps, 5u);
  EXPECT_EQ(left_out.rows.size(), counts.samples - counts.in_gaps);
  EXPECT_EQ(rows_of(track, rate(2.0), {.gaps = GapRows::empty}, empty).samples, counts.samples);
  EXPECT_EQ(empty.rows.size(), counts.samples);
  EXPECT_EQ(
      static_cast<std::size_t>(std::ranges::count_if(empty.rows, [](const Row& row) { return !row.orientation; })),
      counts.in_gaps);
}

TEST(SampleRows, BeforeABadOneAreWritten) {
  const PoseCurve curve = shaped_curve("auto", keys()).value();
  const TimesOnCurve wanted =
      times_on_curve(rate(2000.0), Decimal(), curve.orientation.domain(), Extrapolation::hold).value();
  CurveSamples samples(curve, wanted.times);
  Gathered sink(3.0);
  const auto counts = sample_rows(samples, {}, {.threads = 4}, sink);
  ASSERT_FALSE(counts);
  EXPECT_EQ(counts.error().message, "refused");
  EXPECT_EQ(sink.rows.size(), 6000u);
}

TEST(SampleRows, OfKeysThatComeInPiecesAreThoseOfTheCurve) {
  const Track track = keys();
  Gathered whole, stream;
  rows_of(track, rate(400.0), {}, whole);
  std::size_t next = 0, ended = 0;
  StreamRequest request{.source = track.name, .method = "auto", .times = rate(400.0)};
  request.next = [&]() -> Expected<KeyPiece> {
    const std::size_t count = std::min<std::size_t>(2, track.keys.size() - next);
    KeyPiece piece{.epoch = track.epoch};
    for (std::size_t k = next; k < next + count; ++k) {
      piece.keys.times.push_back(track.keys.times()[k]);
      piece.keys.orientations.push_back(track.keys.orientations()[k]);
    }
    next += count;
    piece.is_last = next == track.keys.size();
    return piece;
  };
  request.warn = [](const std::vector<Warning>&) {};
  request.ended = [&](std::size_t samples) { ended = samples; };
  ASSERT_TRUE(can_stream(request));
  StreamSamples samples(std::move(request));
  const RowCounts counts = sample_rows(samples, {}, {.threads = 2}, stream).value();
  EXPECT_TRUE(stream.rows == whole.rows);
  EXPECT_EQ(ended, counts.samples);
  EXPECT_EQ(samples.outcome().keys, track.keys.size());
  EXPECT_EQ(samples.outcome().start.to_string(), "1700000000");
}

TEST(SampleRows, OnlyThoseOfARateAndALocalMethodGoThroughInPieces) {
  StreamRequest request{.method = "auto", .times = rate(10.0)};
  EXPECT_TRUE(can_stream(request));
  request.method = "squad-timed";
  EXPECT_FALSE(can_stream(request));
  request = {.method = "auto", .times = {.spacing = SampleGrid::Count{5}, .from = {}, .to = {}}};
  EXPECT_FALSE(can_stream(request));
}

TEST(SampleTimes, SaysWhatLetsAnyNumberPass) {
  TimeRequest request = rate(1.0);
  request.cure = "ask for fewer";
  EXPECT_TRUE(check_number(request, 1e9));
  EXPECT_TRUE(check_number(request, 2e9).error().message.ends_with("the times; ask for fewer"));
  request.any_number = true;
  EXPECT_TRUE(check_number(request, 2e9));
}

TEST(CurveOfKeys, CountsFromTheFirstKeyWhenKeysAreReadAgain) {
  Track track = turns_of({0.0, 0.5, 0.7});
  track.epoch = Decimal::from_double(100.0);
  track.keys = track.keys.with_times({0.25, 1.0, 2.0}).value();
  track.exact_times = {Decimal::parse("100.25").value(), Decimal::parse("101").value(),
                       Decimal::parse("102.0000000000000001").value()};
  const Track read = as_read_again(track).value();
  EXPECT_EQ(read.epoch.to_string(), "100.25");
  EXPECT_EQ(read.keys.times()[0], 0.0);
  EXPECT_EQ(read.keys.times()[2], 1.75);
  EXPECT_EQ(read.time_of(2), track.time_of(2));
}

}}  // namespace orispline::jobs
