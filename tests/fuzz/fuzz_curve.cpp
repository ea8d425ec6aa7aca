// SPDX-License-Identifier: Apache-2.0
// Keys of any kind and a method with any settings: what is promised of every curve, or a refusal in plain words.
#include <fuzz/claim.hpp>
#include <fuzz/curve_claims.hpp>
#include <fuzz/fuzzed_method.hpp>

namespace orispline::fuzz { namespace {

constexpr std::size_t most_keys = 12;

void try_method(const FamilyInfo& family, const Method& method, const FuzzedKeys& fuzzed, const Keyframes& keys) {
  const auto curve = make_pose_curve(method, keys);
  if (!curve) return claim_plain(curve.error());
  const Specimen specimen{family, method, fuzzed, keys, *curve};
  claim_finite(specimen);
  claim_through_keys(specimen);
  claim_continuity(specimen);
  claim_same_bits(curve->orientation);
  claim_agreement(curve->orientation);
  claim_baked(curve->orientation);
  claim_symmetries(specimen);
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  FuzzInput input(data, size);
  const auto families = families_info();
  const FamilyInfo& family = families[input.below(families.size())];
  FuzzInput of_method = input.part(32);
  const FuzzedKeys fuzzed = fuzzed_keys(input, most_keys);
  const Method method = fuzzed_method(of_method, family, fuzzed);
  const Situation situation([&] { return told(method, fuzzed); });
  const auto keys = Keyframes::make(fuzzed.data, fuzzed.signs);
  if (!keys) return claim_plain(keys.error()), 0;
  try_method(family, method, fuzzed, *keys);
  return 0;
}
