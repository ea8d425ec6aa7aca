// SPDX-License-Identifier: Apache-2.0
// Where samples go: nothing beside the spans is touched, and spans that do not belong together are an error.
#include <numeric>

#include <batch/agreement.hpp>
#include <batch/refused_samples.hpp>
#include <batch/specimen_curves.hpp>
#include <support/not_finite.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr double untouched = 12345.0;

/// Spans in the middle of longer arrays of guards, each at its own offset from what is aligned.
template <class T>
class Guarded {
 public:
  Guarded(std::size_t samples, std::size_t offset, Layout layout)
      : samples_(samples), offset_(offset), layout_(layout) {
    for (std::size_t k = 0; k < 4; ++k) memory_[k].assign(components(k) * samples + 2 * guards, T(untouched));
  }
  [[nodiscard]] Samples<T> spans() {
    return {.orientations = span(0),
            .angular_velocities = span(1),
            .angular_accelerations = span(2),
            .angular_jerks = span(3),
            .layout = layout_};
  }

  [[nodiscard]] bool guards_are_untouched() {
    for (std::size_t k = 0; k < 4; ++k)
      for (const T& value : memory_[k]) {
        const bool inside = &value >= span(k).data() && &value < span(k).data() + span(k).size();
        if (!inside && value != T(untouched)) return false;
      }
    return true;
  }

 private:
  static constexpr std::size_t guards = 40;
  static std::size_t components(std::size_t k) { return k == 0 ? 4 : 3; }
  [[nodiscard]] std::span<T> span(std::size_t k) {
    return std::span(memory_[k]).subspan(guards - offset_ - k, components(k) * samples_);
  }

  std::size_t samples_, offset_;
  Layout layout_;
  std::vector<T> memory_[4];
};

template <class T>
void expect_the_same_anywhere(const AnyCurve& curve, std::size_t count, Layout layout) {
  const double dt = (curve.domain().end - curve.domain().start) / static_cast<double>(count);
  const auto fill = [&](const Samples<T>& spans) {
    ASSERT_TRUE(sample_uniform<T>(curve, curve.domain().start + 0.3 * dt, dt, spans));
  };
  Sampled<T> interleaved(count, Wanted::jerk);
  fill(interleaved.spans());
  for (const std::size_t offset : {0U, 1U, 3U, 7U, 13U}) {
    Guarded<T> guarded(count, offset, layout);
    fill(guarded.spans());
    EXPECT_TRUE(guarded.guards_are_untouched()) << count << " samples at offset " << offset;
    Sampled<T> read(count, Wanted::jerk, layout);
    std::ranges::copy(guarded.spans().orientations, read.spans().orientations.begin());
    std::ranges::copy(guarded.spans().angular_velocities, read.spans().angular_velocities.begin());
    std::ranges::copy(guarded.spans().angular_accelerations, read.spans().angular_accelerations.begin());
    std::ranges::copy(guarded.spans().angular_jerks, read.spans().angular_jerks.begin());
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(read.orientation(i), interleaved.orientation(i)) << i << " of " << count;
      ASSERT_EQ(read.velocity(i), interleaved.velocity(i)) << i << " of " << count;
      ASSERT_EQ(read.acceleration(i), interleaved.acceleration(i)) << i << " of " << count;
      ASSERT_EQ(read.jerk(i), interleaved.jerk(i)) << i << " of " << count;
    }
  }
}

TEST(BatchSpans, MayLieAnywhereInEitherLayout) {
  for (const char* kind : kinds_of_curves) {
    SCOPED_TRACE(kind);
    const AnyCurve curve = specimen_curve(kind);
    for (const std::size_t count : {1U, 2U, 7U, 9U, 127U, 128U, 129U, 1031U})
      for (const Layout layout : {Layout::interleaved, Layout::planar}) {
        expect_the_same_anywhere<double>(curve, count, layout);
        expect_the_same_anywhere<float>(curve, count, layout);
      }
  }
}

TEST(BatchSpans, MayBeEmpty) {
  const AnyCurve curve = specimen_curve("timed-c2");
  const CompiledCurve<> compiled(curve);
  EXPECT_TRUE(sample<double>(curve, {}, {}));
  EXPECT_TRUE(sample_uniform<double>(curve, 0.0, 1.0, {}));
  EXPECT_TRUE(sample_at<double>(compiled, {}, {}));
  EXPECT_TRUE(sample_many<double>({}, 0.0, {}));
}

TEST(BatchSpans, OfWrongSizesAreAnError) {
  const AnyCurve curve = specimen_curve("timed-c2");
  const std::vector<CompiledCurve<>> curves(2, CompiledCurve<>(curve));
  const std::vector<double> times{0.0, 0.5};
  std::vector<double> memory(8);
  const auto first = [&](std::size_t count) { return std::span(memory).first(count); };
  const std::string few = "found room for 7 numbers of orientations, wanted 8 numbers for 2 samples";
  expect_bad_argument(sample<double>(curve, times, {.orientations = first(7)}), few);
  expect_bad_argument(sample<double>(curves[0], times, {.orientations = first(7)}), few);
  expect_bad_argument(sample_at<double>(curves[0], times, {.orientations = first(7)}), few);
  expect_bad_argument(sample_many<double>(curves, 0.5, {.orientations = first(7)}), few);
  expect_bad_argument(sample<double>(curve, times, {}),
                      "found room for 0 numbers of orientations, wanted 8 numbers for 2 samples");
  expect_bad_argument(sample_uniform<double>(curve, 0.0, 0.1, {.orientations = first(7)}),
                      "found room for 7 numbers of orientations, wanted 4 numbers for 1 samples");
  expect_bad_argument(sample<double>(curve, times, {.orientations = first(8), .angular_velocities = first(8)}),
                      "found room for 8 numbers of angular velocities, wanted 6 numbers for 2 samples");
  expect_bad_argument(
      sample_uniform<double>(curve, 0.0, 0.1, {.orientations = first(8), .angular_accelerations = first(3)}),
      "found room for 3 numbers of angular accelerations, wanted 6 numbers for 2 samples");
}

TEST(BatchSpans, AreLeftAloneWhenTimesDecrease) {
  const AnyCurve curve = specimen_curve("timed-c2");
  const auto fails_at = [&](const std::vector<double>& times, std::size_t index) {
    std::vector<double> memory(4 * times.size(), untouched);
    const auto sampled = sample<double>(curve, times, {.orientations = memory});
    ASSERT_FALSE(sampled);
    EXPECT_EQ(sampled.error().code, ErrorCode::bad_argument);
    EXPECT_EQ(sampled.error().where.time_index, index);
    EXPECT_NE(sampled.error().message.find("wanted times that do not decrease"), std::string::npos);
    EXPECT_EQ(memory, std::vector(memory.size(), untouched));
  };
  fails_at({0.0, 1.0, 0.5}, 2);
  fails_at({1.0, 0.5, 0.75}, 1);
  fails_at({nan, 1.0, nan, nan, 0.5}, 4);
}

TEST(BatchSpans, AreLeftAloneWhenTheStepIsNone) {
  const AnyCurve curve = specimen_curve("timed-c2");
  std::vector<double> memory(8, untouched);
  for (const double dt : {-0.1, infinity, nan}) {
    const auto sampled = sample_uniform<double>(curve, 0.0, dt, {.orientations = memory});
    ASSERT_FALSE(sampled) << dt;
    EXPECT_EQ(sampled.error().code, ErrorCode::bad_argument);
    EXPECT_EQ(memory, std::vector(8, untouched));
  }
}

}}  // namespace orispline
