// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/uniform.hpp>

#include <string>
#include <utility>

namespace orispline::families {
namespace {

template <std::size_t K>
UniformFamily::Basis<K> basis_of_order(const FamilySettings& settings) {
  return [&]<std::size_t... M>(std::index_sequence<M...>) {
    return UniformFamily::Basis<K>{{settings.per_key("tension" + std::to_string(M + 1))...}};
  }
  (std::make_index_sequence<K>{});
}

/// Calls `build` with the basis of the order that the settings ask for.
template <class Result, class Build>
Expected<Result> with_order(const FamilySettings& settings, Build build) {
  const auto order = settings.whole("order");
  if (!order) return tl::unexpected(order.error());
  const auto as_result = [](auto built) { return Result(std::move(built)); };
  switch (*order) {
    case 1:
      return build(basis_of_order<1>(settings)).map(as_result);
    case 2:
      return build(basis_of_order<2>(settings)).map(as_result);
    case 3:
      return build(basis_of_order<3>(settings)).map(as_result);
    case 4:
      return build(basis_of_order<4>(settings)).map(as_result);
    default:
      return build(basis_of_order<5>(settings)).map(as_result);
  }
}

}  // namespace

Expected<AnyCurve> UniformFamily::curve(const Keyframes& keys, const FamilySettings& settings) {
  return with_order<AnyCurve>(settings, [&](auto basis) { return four_key_curve(keys, settings, std::move(basis)); });
}

Expected<AnyPath> UniformFamily::path(const Keyframes& keys, const FamilySettings& settings) {
  return with_order<AnyPath>(settings, [&](auto basis) { return four_key_path(keys, settings, std::move(basis)); });
}

}  // namespace orispline::families
