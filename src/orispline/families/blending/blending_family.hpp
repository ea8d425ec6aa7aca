// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/curve/method.hpp>
#include <orispline/curve/own_family.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace blending {
class Rows;
}

/// A promise that blending functions may keep, and what was found.
struct BlendingFinding {
  enum class Promise {
    interpolates,       ///< passes through every key
    sums_to_one,        ///< of blending functions of the control points: no point is special
    continuity_even,    ///< in time, on evenly spaced keys
    continuity_uneven,  ///< in time, on any keys
    shape,              ///< whatever the speed, on any keys
    steady_even,        ///< a constant rate stays constant on evenly spaced keys
    steady_uneven,      ///< and on any
    rests_at_zero,      ///< the body rests at a key where the first parameter is 0
  };
  Promise promise;
  int order = 0;        ///< of a continuity; of the others 1 where the promise is kept, else 0
  std::string why{};    ///< what fails, such as `β₂(1) = 0.95, wanted 1: the curve does not reach the key`
  std::string where{};  ///< a linear condition on the parameters under which more is kept, such as `tension = 1/2`
  /// What the promise wants of the parameters at the key, or of the lengths there, such as `1 − a ≠ 0`.
  std::string provided{};
  bool is_undefined = false;  ///< of a continuity: there is no such curve at all, since a coefficient divides by 0
};

/// The promise as documents name it, such as `continuity_uneven`.
[[nodiscard]] ORISPLINE_EXPORT std::string_view promise_name(BlendingFinding::Promise promise) noexcept;

/// What was found, as a sentence for people; empty where there is nothing to say.
[[nodiscard]] ORISPLINE_EXPORT std::string sentence_of(const BlendingFinding& found);

/// A family of curves that was stated as data. What it promises is found from its coefficients: exactly, in fractions,
/// for all values of its parameters.
class ORISPLINE_EXPORT BlendingFamily final : public OwnFamily {
 public:
  static constexpr std::size_t most_rows = 5, highest_degree = 9, most_characters = 65536;

  /// Errors (bad_argument), with row, entry and position where these are at fault: a name that a method of the registry
  /// has or that is none, a parameter that is none or of an empty range, no rows or more than five, rows of different
  /// lengths, a degree above nine, an expression that is none, no `first` where it is needed, an unknown end rule.
  [[nodiscard]] static Expected<std::shared_ptr<const BlendingFamily>> make(BlendingData data);

  ~BlendingFamily() override;
  [[nodiscard]] const BlendingData& data() const noexcept { return data_; }
  /// In the order of the promises; those that are of no matter here are left out.
  [[nodiscard]] const std::vector<BlendingFinding>& findings() const noexcept { return findings_; }

  [[nodiscard]] const FamilyInfo& info() const noexcept override { return info_; }
  /// Errors: bad_data where a coefficient is not finite for these parameters and key times.
  [[nodiscard]] Expected<AnyCurve> curve(const Keyframes& keys, const FamilySettings& settings) const override;
  [[nodiscard]] Expected<AnyPath> path(const Keyframes& keys, const FamilySettings& settings) const override;
  [[nodiscard]] const blending::Rows& rows() const noexcept { return *rows_; }

 private:
  BlendingFamily(BlendingData data, std::unique_ptr<const blending::Rows> rows, std::vector<EndRule> ends);

  BlendingData data_;
  std::unique_ptr<const blending::Rows> rows_;
  std::vector<BlendingFinding> findings_;
  std::vector<Parameter> parameters_;
  std::vector<EndRule> ends_;
  FamilyInfo info_;
};

/// The keys within a curve, and of a loop the first one, where the condition of the shape's promise fails: the body
/// rests or turns back there for these values of the parameters, and its path may have a corner.
[[nodiscard]] std::vector<std::size_t> possible_corners(const BlendingFamily& family, const Keyframes& keys,
                                                        const FamilySettings& settings);

/// What was found of a family of one's own; empty for all others.
[[nodiscard]] ORISPLINE_EXPORT std::span<const BlendingFinding> findings_of(const FamilyInfo& family) noexcept;

/// The rows of a family of one's own that a method is of; null for all other methods.
[[nodiscard]] ORISPLINE_EXPORT const BlendingData* blending_of(const Method& method) noexcept;

}}  // namespace orispline
