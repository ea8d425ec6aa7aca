// SPDX-License-Identifier: Apache-2.0
#include "blocks.hpp"
#include "curve.hpp"
#include "errors.hpp"

namespace orispline::c { namespace {

template <class T>
Expected<void> fill(const PoseSampler& sampler, const Times& times, orispline_order order, Extrapolation beyond,
                    Work work, Outputs outputs) {
  return fill_all<T>(outputs, order, times, work,
                     [&](std::span<const double> some, const Samples<T>& samples, RateFrame frame) {
                       return sampler.sample_at<T>(some, samples, beyond, frame, work);
                     });
}

Expected<void> sample(const orispline_curve* curve, const Times& times, orispline_order order, const char* beyond,
                      std::uint32_t threads, const orispline_output* outputs, std::size_t output_count) {
  const auto body = checked(curve);
  if (!body) return tl::unexpected(body.error());
  const auto wanted = outputs_in(outputs, output_count, order, times.size());
  if (!wanted) return tl::unexpected(wanted.error());
  return extrapolation_named(beyond).and_then([&](Extrapolation how) {
    const PoseSampler& sampler = (*body)->sampler;
    return fill<double>(sampler, times, order, how, {threads}, *wanted).and_then([&] {
      return fill<float>(sampler, times, order, how, {threads}, *wanted);
    });
  });
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_sample_even(const orispline_curve* curve, double start, double step, size_t count,
                                     orispline_order order, const char* beyond, uint32_t threads,
                                     const orispline_output* outputs, size_t output_count, orispline_error** error) {
  return guarded(error, [&] {
    return check_even(start, step).and_then([&] {
      return sample(curve, Times(start, step, count), order, beyond, threads, outputs, output_count);
    });
  });
}

orispline_code orispline_sample_at(const orispline_curve* curve, const double* times, size_t count,
                                   orispline_order order, const char* beyond, uint32_t threads,
                                   const orispline_output* outputs, size_t output_count, orispline_error** error) {
  return guarded(error, [&] {
    return (count == 0 ? Expected<void>() : check_pointer(times, "times")).and_then([&] {
      return sample(curve, Times(std::span(times, count)), order, beyond, threads, outputs, output_count);
    });
  });
}
