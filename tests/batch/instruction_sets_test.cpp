// SPDX-License-Identifier: Apache-2.0
// The loops of every instruction set give the same bits, and the same as every compiler's: all the way from keys to
// samples.
#include <cstdint>

#include <gtest/gtest.h>

#include <batch/bits_of_samples.hpp>
#include <batch/every_kernel.hpp>
#include <batch/sampled.hpp>
#include <batch/specimen_curves.hpp>

namespace orispline { namespace {

using namespace testing_support;
using batch::Clock;
using batch::Kernels;
using batch::Target;

template <class T>
struct Results {
  std::vector<T> orientations = std::vector<T>(4 * block_and_part), velocities = std::vector<T>(3 * block_and_part),
                 accelerations = velocities, jerks = velocities;

  [[nodiscard]] Target<T> target(Wanted wanted, Layout layout) {
    return {.orientation = orientations.data(),
            .angular_velocity = wanted == Wanted::orientation ? nullptr : velocities.data(),
            .angular_acceleration = wanted >= Wanted::acceleration ? accelerations.data() : nullptr,
            .angular_jerk = wanted >= Wanted::jerk ? jerks.data() : nullptr,
            .planes = layout == Layout::planar ? static_cast<std::ptrdiff_t>(block_and_part) : 0};
  }
  [[nodiscard]] bool same_bits(const Results& other) const {
    const auto same = [](const std::vector<T>& a, const std::vector<T>& b) {
      return std::memcmp(a.data(), b.data(), sizeof(T) * a.size()) == 0;
    };
    return same(orientations, other.orientations) && same(velocities, other.velocities) &&
           same(accelerations, other.accelerations) && same(jerks, other.jerks);
  }
};

/// Every segment of a curve, at even times and at given ones, by every instruction set.
template <class T>
void expect_the_same_by_every_instruction_set(const AnyCurve& curve) {
  const auto kernels = all_kernels();
  for (std::size_t segment = 0; segment < curve.knots().segments(); ++segment) {
    const batch::SegmentRecord<T> record = batch::record_of<T>(curve, segment);
    const KnotSpan span = curve.knots().span(segment);
    std::vector<double> times;
    for (std::size_t k = 0; k < block_and_part; ++k)
      times.push_back(span.start() + span.step() * static_cast<double>(k) / static_cast<double>(block_and_part));
    for (const Wanted wanted : {Wanted::orientation, Wanted::velocity, Wanted::acceleration, Wanted::jerk})
      for (const Clock& clock : {Clock{.times = times.data(), .start = 0.0, .step = 0.0, .first = 0.0},
                                 Clock{nullptr, span.start() - 3.0 * span.step(), span.step() / 173.0, 519.0}}) {
        const Layout layout = clock.times ? Layout::interleaved : Layout::planar;
        Results<T> first;
        const auto into = [&](Results<T>& results, const Kernels& k) {
          run<T>(k, record, clock, block_and_part, results.target(wanted, layout));
        };
        into(first, *kernels.front());
        for (const Kernels* other : kernels) {
          Results<T> results;
          into(results, *other);
          EXPECT_TRUE(results.same_bits(first)) << other->name << " differs from " << kernels.front()->name;
        }
      }
  }
}

void expect_the_same(const std::string& name, const AnyCurve& curve) {
  SCOPED_TRACE(name);
  expect_the_same_by_every_instruction_set<double>(curve);
  expect_the_same_by_every_instruction_set<float>(curve);
}

TEST(InstructionSets, OfThisProcessorAreFound) {
  EXPECT_FALSE(all_kernels().empty());
  EXPECT_EQ(batch::kernels_named("v9"), nullptr);
  EXPECT_EQ(batch::kernels_named(batch::kernels().name), &batch::kernels());
}

TEST(InstructionSets, AreForcedByNameOrNotAtAll) {
  Kernels wide = batch::kernels(), narrow = wide;
  wide.name = "wide";
  narrow.name = "narrow";
  const std::array candidates{batch::Candidate{&wide, false}, batch::Candidate{&narrow, true}};
  const auto message = [&](const char* text) { return describe(batch::forced_kernels(candidates, text).error()); };
  EXPECT_EQ(batch::forced_kernels(candidates, nullptr).value(), nullptr);
  EXPECT_EQ(batch::forced_kernels(candidates, "").value(), nullptr);
  EXPECT_EQ(batch::forced_kernels(candidates, "narrow").value(), &narrow);
  EXPECT_EQ(message("wide"), "ORISPLINE_ISA: found 'wide', which this processor lacks, wanted one of narrow");
  EXPECT_EQ(message("Narrow"), "ORISPLINE_ISA: found 'Narrow', wanted one of narrow");
}

TEST(InstructionSets, FallBackToTheBestWhereAnUnknownOneIsForced) {
  // Chosen once in a process, so that a process of its own tries it.
  const auto choose = [](const char* name) {
    setenv("ORISPLINE_ISA", name, 1);
    std::fputs(batch::kernels().name, stderr);
    std::exit(batch::forced_kernels().has_value() ? 0 : 1);
  };
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(choose("v9"), testing::ExitedWithCode(1), all_kernels().back()->name);
  EXPECT_EXIT(choose(all_kernels().front()->name), testing::ExitedWithCode(0), all_kernels().front()->name);
}

TEST(InstructionSets, GiveTheSameBitsForEveryFamily) {
  for (std::uint64_t seed = 91; seed < 101; ++seed)
    for (const auto& [name, curve] : curve_of_every_family(seed)) expect_the_same(name, curve);
}

TEST(InstructionSets, GiveTheSameBitsForAnyAngle) {
  for (const double tension : {0.1, 0.5, 2.0, 20.0, -100.0})
    expect_the_same(std::to_string(tension), tense_curve(tension));
}

TEST(InstructionSets, AndCompilersGiveTheBitsThatAreWritten) {
  const auto note = [](const std::string& name, std::uint64_t hash) { RecordProperty(name, std::to_string(hash)); };
  const BitsOfSamples found = bits_of_samples(note);
  const auto expect = [](std::uint64_t bits, std::uint64_t wanted) {
    EXPECT_EQ(bits, wanted) << std::hex << "0x" << bits;
  };
  expect(found.local_samples, written_bits.local_samples);
  expect(found.local_jerks, written_bits.local_jerks);
  expect(found.solved_samples, written_bits.solved_samples);
  expect(found.solved_jerks, written_bits.solved_jerks);
  expect(found.path_samples, written_bits.path_samples);
  expect(found.path_rates, written_bits.path_rates);
}

}}  // namespace orispline
