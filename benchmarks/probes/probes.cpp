// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <probes/probes.hpp>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace orispline::bench {

#if defined(ORISPLINE_X86_PROBES)
extern const FmaProbe fma_v2, fma_v3, fma_v4;
const FmaProbe* const probes[] = {&fma_v2, &fma_v3, &fma_v4};
#else
extern const FmaProbe fma_native;
const FmaProbe* const probes[] = {&fma_native};
#endif

const FmaProbe* fma_probe(const char* isa) noexcept {
  for (const FmaProbe* probe : probes)
    if (std::strcmp(probe->name, isa) == 0) return probe;
  return nullptr;
}

double fma_expected(const FmaProbe& probe, const FmaWork& work, double start) noexcept {
  const auto chains = static_cast<double>(probe.chains);
  const double power = std::pow(work.factor, static_cast<double>(work.rounds));
  return power * (chains * start + 0.5 * chains * (chains - 1.0)) +
         chains * work.summand * (1.0 - power) / (1.0 - work.factor);
}

void write_plain(std::span<double> out, const double (&pattern)[4]) noexcept {
  double x = pattern[0], y = pattern[1], z = pattern[2], w = pattern[3];
  for (std::size_t i = 0; i + 4 <= out.size(); i += 4) {
    out[i] = x;
    out[i + 1] = y;
    out[i + 2] = z;
    out[i + 3] = w;
  }
}

void write_streaming(std::span<double> out, const double (&pattern)[4]) noexcept {
#if defined(__SSE2__)
  const __m128d low = _mm_loadu_pd(pattern), high = _mm_loadu_pd(pattern + 2);
  for (std::size_t i = 0; i + 4 <= out.size(); i += 4) {
    _mm_stream_pd(&out[i], low);
    _mm_stream_pd(&out[i + 2], high);
  }
  _mm_sfence();
#else
  write_plain(out, pattern);
#endif
}

}  // namespace orispline::bench
