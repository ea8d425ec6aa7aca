// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>

#include <fuzz/fuzzed_keys.hpp>

// What is claimed of every curve that is given out. A claim that does not hold ends the program.

namespace orispline::fuzz {

/// A curve with what it was made of.
struct Specimen {
  const FamilyInfo& family;
  const Method& method;
  const FuzzedKeys& fuzzed;
  const Keyframes& keys;
  const PoseCurve& curve;
};

/// Every motion on the domain and beside it is finite, every orientation a unit quaternion.
void claim_finite(const Specimen& specimen);
/// It passes through the keys that its family says.
void claim_through_keys(const Specimen& specimen);
/// At the knots it is as smooth as its family declares.
void claim_continuity(const Specimen& specimen);
/// Samples in bulk have the same bits in every layout, in any order, of the compiled curve and by every instruction
/// set.
void claim_same_bits(const AnyCurve& curve);
/// Samples in bulk, and those of the baked curve, are those of the scalar evaluator.
void claim_agreement(const AnyCurve& curve);
void claim_baked(const AnyCurve& curve);
/// No frame, no sign and no unit of time is special.
void claim_symmetries(const Specimen& specimen);

}  // namespace orispline::fuzz
