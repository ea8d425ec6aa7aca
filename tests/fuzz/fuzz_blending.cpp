// SPDX-License-Identifier: Apache-2.0
// A text as a file of blending functions of one's own, and the curve that they make.
#include <cmath>

#include <fuzz/claim.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/io/blending_file.hpp>

namespace orispline::fuzz { namespace {

Keyframes some_keys() {
  KeyframeData data;
  for (const double t : {0.0, 1.0, 1.5, 4.0, 4.25, 5.0}) {
    data.times.push_back(t);
    data.orientations.push_back(exp<double>({0.3 * t, std::sin(t), 0.1 * t * t}));
  }
  return Keyframes::make(std::move(data)).value();
}

/// What a file says is the same when it is written and read again.
void claim_read_back(const BlendingData& data) {
  const auto again = io::blending_from_json(io::blending_json(data));
  claim(again.has_value() && *again == data, "the blending functions are not read back: {}", io::blending_json(data));
}

void claim_findings(const BlendingFamily& family) {
  for (const BlendingFinding& found : family.findings()) {
    const std::string sentence = sentence_of(found);
    claim(sentence.empty() || is_one_printable_line(sentence), "what was found is not one printable line: '{}'",
          sentence);
    claim(-1 <= found.order && found.order <= static_cast<int>(BlendingFamily::highest_degree), "order {}",
          found.order);
  }
}

void claim_sound(const AnyCurve& curve, const Keyframes& keys) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Motion motion = curve.motion(keys.times()[i]);
    claim(motion.orientation.coeffs().allFinite(), "the curve is not finite at key {}", i);
    claim(std::abs(motion.orientation.norm() - 1.0) < 1e-9, "the norm at key {} is {}", i, motion.orientation.norm());
  }
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const auto data = io::blending_from_json(text);
  if (!data) return claim_plain(data.error()), 0;
  claim_read_back(*data);
  const auto family = BlendingFamily::make(*data);
  if (!family) return claim_plain(family.error()), 0;
  claim_findings(**family);
  static const Keyframes keys = some_keys();
  const auto curve = make_curve(Method(*family), keys);
  if (!curve) return claim_plain(curve.error()), 0;
  claim_sound(*curve, keys);
  return 0;
}
