// SPDX-License-Identifier: Apache-2.0
// The loops over polynomials give the same bits by every instruction set.
#include <algorithm>

#include <gtest/gtest.h>

#include <batch/bits_of_samples.hpp>
#include <batch/every_kernel.hpp>
#include <orispline/batch/path_sampler.hpp>

namespace orispline { namespace {

using namespace testing_support;
using batch::Clock;
using batch::PolynomialKernels;

template <class T>
using Numbers = std::vector<T>;

template <class T>
batch::Target<T> baked_target(Numbers<T>& to) {
  return {.orientation = to.data(),
          .angular_velocity = to.data() + 4 * block_and_part,
          .angular_acceleration = to.data() + 7 * block_and_part,
          .angular_jerk = to.data() + 10 * block_and_part};
}
void run_polynomial(const PolynomialKernels& k, const batch::BakedRecord<double>& r, const Clock& clock,
                    Numbers<double>& to) {
  k.baked(r, clock, block_and_part, baked_target(to));
}
void run_polynomial(const PolynomialKernels& k, const batch::BakedRecord<float>& r, const Clock& clock,
                    Numbers<float>& to) {
  k.baked_float(r, clock, block_and_part, baked_target(to));
}
template <class T>
batch::PathTarget<T> path_target(Numbers<T>& to) {
  return {to.data(), to.data() + 3 * block_and_part, to.data() + 6 * block_and_part, to.data() + 9 * block_and_part, 0};
}
void run_polynomial(const PolynomialKernels& k, const batch::PathRecord<double>& r, const Clock& clock,
                    Numbers<double>& to) {
  k.path(r, clock, block_and_part, path_target(to));
}
void run_polynomial(const PolynomialKernels& k, const batch::PathRecord<float>& r, const Clock& clock,
                    Numbers<float>& to) {
  k.path_float(r, clock, block_and_part, path_target(to));
}

/// At even times and at given ones.
template <class T, class Record>
void expect_the_same_by_every_instruction_set(const Record& record, const KnotSpan& span) {
  std::vector<double> times;
  for (std::size_t k = 0; k < block_and_part; ++k)
    times.push_back(span.start() + span.step() * static_cast<double>(k) / static_cast<double>(block_and_part));
  for (const Clock& clock : {Clock{times.data(), 0.0, 0.0, 0.0},
                             Clock{nullptr, span.start() - 3.0 * span.step(), span.step() / 173.0, 519.0}}) {
    Numbers<T> first(13 * block_and_part);
    run_polynomial(*all_kernels().front()->polynomials, record, clock, first);
    for (const batch::Kernels* other : all_kernels()) {
      Numbers<T> numbers(13 * block_and_part);
      run_polynomial(*other->polynomials, record, clock, numbers);
      EXPECT_EQ(std::memcmp(numbers.data(), first.data(), sizeof(T) * numbers.size()), 0);
    }
  }
}

template <class T>
void expect_the_same(const PoseCurve& curve) {
  const BakedCurve<T> baked = bake<T>(curve.orientation, 1e-6).value();
  for (std::size_t i = 0; i < baked.knots().segments(); ++i)
    expect_the_same_by_every_instruction_set<T>(baked.piece(i), baked.knots().span(i));
  for (std::size_t i = 0; i < curve.position->knots().segments(); ++i)
    if (const auto record = batch::record_of<T>(*curve.position, i))
      expect_the_same_by_every_instruction_set<T>(*record, curve.position->knots().span(i));
}

TEST(PolynomialKernels, GiveTheSameBitsByEveryInstructionSet) {
  ASSERT_FALSE(all_kernels().empty());
  for (const PoseCurve& curve : specimen_pose_curves()) {
    expect_the_same<double>(curve);
    expect_the_same<float>(curve);
  }
}

TEST(PolynomialKernels, TakeThePathsOfTheseMethods) {
  for (const PoseCurve& curve : specimen_pose_curves())  // but for the blended one of barry-goldman
    EXPECT_EQ(batch::record_of<double>(*curve.position, 0).has_value(), curve.position->degree() > 0);
  EXPECT_GT(std::ranges::count_if(specimen_pose_curves(), [](const PoseCurve& c) { return c.position->degree() > 0; }),
            3);
}

}}  // namespace orispline
