// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <orispline/base/abi.hpp>

// Made by tools/make_golden.py elementary (mpmath, 60 digits): change that, not this.

namespace orispline { inline namespace ORISPLINE_ABI { namespace elementary {

// clang-format off
/// Of sin r = r + r³ P(r²) and cos r = 1 - r²/2 + r⁴ Q(r²), |r| ≤ π/4: P and Q side by side.
inline constexpr double sine_cosine_terms[6][2]{
  {-0x1.5555555555548p-3, 0x1.555555555554bp-5},
  {0x1.111111110f7d0p-7, -0x1.6c16c16c14f91p-10},
  {-0x1.a01a019bfded2p-13, 0x1.a01a019c844d7p-16},
  {0x1.71de3567d1c69p-19, -0x1.27e4f7eac3550p-22},
  {-0x1.ae5e5a9055b03p-26, 0x1.1ee9d7b3e7b3cp-29},
  {0x1.5d8fd152ceb5ep-33, -0x1.8fa49981582f3p-37},
};

/// atan t = t + t³ P(t²), |t| ≤ 1/16.
inline constexpr std::array<double, 5> arctangent_terms{
  -0x1.5555555555537p-2, 0x1.9999999963171p-3, -0x1.249248297a09fp-3, 0x1.c7187fd668ba6p-4, -0x1.70c229631feb0p-4,
};

/// 2 atanh s = 2 s + s³ P(s²), |s| ≤ (√2 - 1)/(√2 + 1).
inline constexpr std::array<double, 7> logarithm_terms{
  0x1.5555555555592p-1, 0x1.999999997fdb8p-2, 0x1.24924941f121fp-2, 0x1.c71c52095f030p-3, 0x1.74663ee81c0a3p-3,
  0x1.39a1babe2a084p-3, 0x1.2f05634bdc572p-3,
};

/// r coth(r/2) = 2 + r² P(r²), |r| ≤ ln(2)/2.
inline constexpr std::array<double, 5> exponential_terms{
  0x1.555555555552dp-3, -0x1.6c16c16bda082p-9, 0x1.1566aac0a1a67p-14, -0x1.bbd3aafba8ec7p-20, 0x1.634913f687637p-25,
};

/// π/2 in two parts of 33 bits and a rest.
inline constexpr std::array<double, 3> half_pi_parts{
  0x1.921fb54400000p+0, 0x1.0b4611a600000p-34, 0x1.3198a2e037073p-69,
};

/// π/2 as the nearest double and the rest.
inline constexpr std::array<double, 2> half_pi{
  0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
};

/// π as the nearest double and the rest.
inline constexpr std::array<double, 2> whole_pi{
  0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53,
};

/// ln 2 in a part of 41 bits and a rest.
inline constexpr std::array<double, 2> log_of_two{
  0x1.62e42fefa3000p-1, 0x1.3de6af278ece6p-42,
};

/// atan(i/32) as the nearest double.
inline constexpr std::array<double, 33> arctangents{
  0x0.0p+0, 0x1.ffd55bba97625p-6, 0x1.ff55bb72cfdeap-5, 0x1.7ee182602f10fp-4, 0x1.fd5ba9aac2f6ep-4,
  0x1.3d6eee8c6626cp-3, 0x1.7b97b4bce5b02p-3, 0x1.b90d7529260a2p-3, 0x1.f5b75f92c80ddp-3, 0x1.18bf5a30bf178p-2,
  0x1.362773707ebccp-2, 0x1.530ad9951cd4ap-2, 0x1.6f61941e4def1p-2, 0x1.8b24d394a1b25p-2, 0x1.a64eec3cc23fdp-2,
  0x1.c0db4c94ec9f0p-2, 0x1.dac670561bb4fp-2, 0x1.f40dd0b541418p-2, 0x1.0657e94db30d0p-1, 0x1.1255d9bfbd2a9p-1,
  0x1.1e00babdefeb4p-1, 0x1.2958e59308e31p-1, 0x1.345f01cce37bbp-1, 0x1.3f13fb89e96f4p-1, 0x1.4978fa3269ee1p-1,
  0x1.538f57b89061fp-1, 0x1.5d58987169b18p-1, 0x1.66d663923e087p-1, 0x1.700a7c5784634p-1, 0x1.78f6bbd5d315ep-1,
  0x1.819d0b7158a4dp-1, 0x1.89ff5ff57f1f8p-1, 0x1.921fb54442d18p-1,
};

/// What is missing there.
inline constexpr std::array<double, 33> arctangent_rests{
  0x0.0p+0, -0x1.5ec431444912cp-60, -0x1.c934d86d23f1dp-60, -0x1.cfb654c0c3d98p-58, -0x1.cd37686760c17p-59,
  0x1.61a3b0ce9281bp-57, 0x1.347b0b4f881cap-58, 0x1.17b10d2e0e5abp-61, 0x1.8ab6e3cf7afbdp-57, 0x1.30ca4748b1bf9p-57,
  -0x1.963a544b672d8p-57, -0x1.2566480884082p-57, -0x1.c63aae6f6e918p-56, 0x1.b6d0ba3748fa8p-56,
  -0x1.24dec1b50b7ffp-56, -0x1.cc1ce70934c34p-56, 0x1.a2b7f222f65e2p-56, -0x1.a3992dc382a23p-57,
  -0x1.d5b495f6349e6p-56, -0x1.2bdaee1c0ee35p-58, -0x1.928df287a668fp-58, -0x1.09e73b0c6c087p-56,
  0x1.1021137c71102p-55, 0x1.ecf8b492644f0p-56, 0x1.2419a87f2a458p-56, -0x1.1bb74abda520cp-55, 0x1.0028e4bc5e7cap-57,
  -0x1.6ea6febe8bbbap-56, -0x1.8c34d25aadef6p-56, 0x1.406a089803740p-55, -0x1.bf76229d3b917p-56,
  -0x1.55b9a5e177a1bp-55, 0x1.1a62633145c07p-55,
};

/// Bits of 2/π, 64 zeros before the point.
inline constexpr std::array<std::uint32_t, 39> two_over_pi{
  0x00000000, 0x00000000, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab,
  0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
  0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f, 0xef2f118b,
  0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea,
  0x6bfb5fb1, 0x1f8d5d08, 0x56033046,
};

// clang-format on
}}}  // namespace orispline::elementary
