// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>

#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Lets values be read one after the other and keeps the first complaint.
class FirstError {
 public:
  /// The value, or after an error a default one that nobody gets to see.
  template <class T>
  [[nodiscard]] T operator()(Expected<T> result) {
    if (result) return std::move(*result);
    if (!error_) error_ = std::move(result.error());
    return T{};
  }

  /// What was read, unless there was a complaint.
  template <class T>
  [[nodiscard]] Expected<T> or_else(T value) && {
    if (error_) return tl::unexpected(std::move(*error_));
    return value;
  }

 private:
  std::optional<Error> error_;
};

}}  // namespace orispline
