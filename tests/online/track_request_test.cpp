// SPDX-License-Identifier: Apache-2.0
// The grids that a request asks for, and where samples go: in one piece or many the same, to the last bit.
#include <orispline/online/track_sampler.hpp>

#include <gtest/gtest.h>

#include <online/track_stream.hpp>

namespace orispline { namespace {

using namespace testing_support;

constexpr double request_step = 0.037;  // [s]

class EveryMethodOfRequests : public testing::TestWithParam<FamilyInfo> {
 protected:
  [[nodiscard]] static KeyframeData walk(std::uint64_t seed, std::size_t count) {
    return posed_walk(seed, GetParam().key_use.cut(count), Spacing::uneven,
                      std::min(1.5, GetParam().key_use.widest_turn));
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethodOfRequests, testing::ValuesIn(families_info()), [](const auto& test) {
  std::string name(test.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
});

/// What sample() takes of the whole curve at all times of a closed grid.
TrackSamples of_grid(const PoseCurve& curve, const SampleGrid& grid) {
  TrackSamples samples;
  const Samples<double> room = samples.grow(static_cast<std::size_t>(*grid.size()), curve.position.has_value());
  for (std::size_t k = 0; k < samples.times.size(); ++k) samples.times[k] = grid[k].t;
  const auto sampled = sample<double>(curve, samples.times, room);
  return sampled ? samples : TrackSamples{};
}

TEST_P(EveryMethodOfRequests, HasAllSamplesOfARequestHeldAtTheEndsWhereThereIsNoCurve) {
  const KeyframeData data = walk(830, GetParam().is_global() ? 16 : 90);
  const PoseCurve whole = make_pose_curve(GetParam().name, keyframes(data, Signs::shortest)).value();
  const Domain domain = whole.orientation.domain();
  const auto at = [&](double share) {
    return Decimal::from_double(domain.start + share * (domain.end - domain.start));
  };
  const SampleGrid::Rate fast{27.0}, slow{0.3}, meets_end{64.0 / (domain.end - domain.start)};
  for (const SampleGrid::Request& request : std::initializer_list<SampleGrid::Request>{
           {.spacing = fast},
           {.spacing = slow},
           {.spacing = meets_end},
           {.spacing = fast, .start = at(-0.2), .end = at(1.3)},
           {.spacing = slow, .start = at(0.5)},
           {.spacing = fast, .end = at(0.4)},
           {.spacing = fast, .start = at(1.1), .end = at(1.2)},
           {.spacing = SampleGrid::Count{50}},
           {.spacing = SampleGrid::Count{50}, .start = at(0.1), .end = at(0.7)}}) {
    const TrackSamples wanted = of_grid(whole, SampleGrid::make(request, domain.start, domain.end).value());
    for (const std::uint64_t cuts : {1u, 2u, 3u})
      EXPECT_TRUE(streamed(TrackSampler::make(GetParam().name, {.request = request}).value(), data, {}, 831 + cuts) ==
                  wanted)
          << cuts;
  }
}

TEST(TrackSampler, ForgetsTheKeysBehindTheEndOfARequest) {
  const KeyframeData data = raw_walk(836, 400);
  TrackSampler sampler =
      TrackSampler::make("auto", {.request = SampleGrid::Request{.spacing = SampleGrid::Rate{10.0},
                                                                 .end = Decimal::from_double(data.times[20])}})
          .value();
  TrackSamples samples;
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    ASSERT_TRUE(sampler.append(key_of(data, i)));
    ASSERT_TRUE(take(sampler, samples, static_cast<std::size_t>(sampler.ready()), true));
    EXPECT_LE(sampler.kept(), 16u);
  }
  EXPECT_EQ(samples.times.back(), sampler.grid()->time(*sampler.grid()->size() - 1));
}

TEST(TrackSampler, ReportsWhatItNoticesOfTheKeysAsKeyframesDo) {
  KeyframeData data = raw_walk(837, 300);
  Dice dice(838);
  data.orientations[171] = data.orientations[170] * Eigen::Quaterniond(0.0, 0.0, 0.0, 1.0);
  data.orientations[172] = data.orientations[171];
  for (Eigen::Quaterniond& q : data.orientations)
    q.coeffs() *= (dice() < 0.3 ? -1.0 : 1.0) * (dice() < 0.5 ? 1.0 : dice.between(0.9995, 1.0005));
  for (const Signs signs : {Signs::shortest, Signs::as_given}) {
    TrackSampler sampler = TrackSampler::make("timed-c2", {.step = request_step}, {.signs = signs}).value();
    for (std::size_t first = 0; first < 300; first += 50) {
      ASSERT_TRUE(sampler.append(part_of(data, first, first + 50)));
      sampler = TrackSampler::from_state(sampler.state()).value();
    }
    const KeyframeReport wanted = keyframes(data, signs).report();
    EXPECT_EQ(sampler.report(), wanted);
    EXPECT_EQ(wanted.near_half_turns, signs == Signs::shortest ? 1u : 0u);
    EXPECT_EQ(wanted.first_near_half_turn, signs == Signs::shortest ? 170u : 0u);
  }
}

TEST(TrackSampler, FillsPlanesOnAnyNumberOfThreads) {
  const KeyframeData data = raw_walk(839, 200);
  TrackSampler sampler = TrackSampler::make("auto", {.step = 1e-3}).value();
  ASSERT_TRUE(sampler.append(data));
  TrackSampler other = sampler;
  const auto size = static_cast<std::size_t>(sampler.ready());
  ASSERT_GT(size, 10000u);
  std::vector<double> rows(4 * size), jerks(3 * size), times(size);
  ASSERT_TRUE(sampler.take({.orientations = rows, .angular_jerks = jerks}, times));
  const std::size_t plane = size + 7, half = size / 2;
  std::vector<double> planes(4 * plane), jerk_planes(3 * plane), planar_times(size);
  for (const std::size_t first : {std::size_t{0}, half}) {
    const std::size_t count = first == 0 ? half : size - half;
    const auto part = [&](std::vector<double>& all, std::size_t components) {
      return std::span(all).subspan(first, plane * (components - 1) + count);
    };
    ASSERT_TRUE(other.take({.orientations = part(planes, 4),
                            .angular_jerks = part(jerk_planes, 3),
                            .layout = Layout::planar,
                            .plane = plane},
                           std::span(planar_times).subspan(first, count), {.threads = 3}));
  }
  EXPECT_EQ(planar_times, times);
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(planes[c * plane + k], rows[4 * k + c]);
    for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(jerk_planes[c * plane + k], jerks[3 * k + c]);
  }
}

}}  // namespace orispline
