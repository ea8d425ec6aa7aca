// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <orispline/curve/family.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Near the motion, local, C2 in time on any keys, nothing to tune: for whoever says nothing.
inline constexpr std::string_view default_method = "auto";

/// What a user names to get a curve: a method of the registry, or one of his own, with its settings, ends and, for a
/// loop, its period.
///
/// A name alone is a method, so that `make_curve("auto", keys)` reads as it should. Its text form is read by
/// method_from_text() and written by text_of(). The *family* of that name is the code that makes its curves.
struct ORISPLINE_EXPORT Method {
  std::string name{default_method};
  CurveOptions options{};
  std::shared_ptr<const OwnFamily> own{};  ///< null for a method of the registry

  Method() = default;
  template <std::convertible_to<std::string_view> Name>
  Method(const Name& method, CurveOptions given = {})  // NOLINT: a name is a method
      : name(std::string_view(method)), options(std::move(given)) {}
  /// The method of a family, which is kept where it is one of one's own.
  Method(const FamilyInfo& family, CurveOptions given = {});                 // NOLINT: a family is a method
  Method(std::shared_ptr<const OwnFamily> family, CurveOptions given = {});  // NOLINT: a family is a method

  /// The method for some of its keys, at these rising indices: a setting with a value for each of the `keys` keeps the
  /// values of these.
  [[nodiscard]] Method at(std::span<const std::size_t> indices, std::size_t keys) const;
};

}}  // namespace orispline
