// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/registry.hpp>

#include <array>

#include <orispline/base/suggestion.hpp>
#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/curve/one_axis.hpp>
#include <orispline/curve/own_family.hpp>
#include <orispline/families/families.hpp>
#include <orispline/families/handles.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

template <class F, CurvePoint P>
Expected<AnyCurveThrough<P>> build_any(const Keyframes& keys, const FamilySettings& settings) {
  return build<F, P>(keys, settings).map([](auto curve) { return AnyCurveThrough<P>(std::move(curve)); });
}

using WidestHandle = HandleTurn (*)(const Keyframes&, const FamilySettings&);

/// Null where the curves of a family have no handles.
template <class F>
constexpr WidestHandle widest_handle_of() {
  if constexpr (requires { WidestHandle{F::widest_handle}; }) return F::widest_handle;
  else return nullptr;
}

struct Entry {
  Expected<AnyCurve> (*curve)(const Keyframes&, const FamilySettings&);
  Expected<AnyPath> (*path)(const Keyframes&, const FamilySettings&);
  WidestHandle widest_handle;
};

constexpr auto infos = []<class... F>(std::tuple<F...>*) {
  return std::array{F::info...};
}(static_cast<Families*>(nullptr));
constexpr auto entries = []<class... F>(std::tuple<F...>*) {
  return std::array{Entry{build_any<F, Eigen::Quaterniond>, build_any<F, Eigen::Vector3d>, widest_handle_of<F>()}...};
}(static_cast<Families*>(nullptr));

Expected<std::size_t> index_of(std::string_view name) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < infos.size(); ++i) {
    if (name == infos[i].name || (!name.empty() && name == infos[i].alias)) return i;
    names.push_back(infos[i].name);
  }
  return failure(ErrorCode::bad_argument, unknown_word("method", name, names));
}

/// A family, in the list or one's own, with the options settled for the keys that its curve goes through.
struct Settled {
  std::size_t index;  ///< in the list
  const OwnFamily* own;
  Keyframes keys;
  FamilySettings settings;

  [[nodiscard]] Expected<AnyCurve> curve() const {
    if (keys.size() == 1) return AnyCurve(ConstantCurve(keys.times()[0], keys.orientations()[0]));
    return own ? own->curve(keys, settings) : entries[index].curve(keys, settings);
  }
  [[nodiscard]] Expected<AnyPath> path() const {
    if (keys.size() == 1) return AnyPath(ConstantCurve(keys.times()[0], keys.positions()[0]));
    return own ? own->path(keys, settings) : entries[index].path(keys, settings);
  }
  [[nodiscard]] WidestHandle widest_handle() const { return own ? nullptr : entries[index].widest_handle; }
};

/// Per-key values of a loop: those of the distinct keys, and the first once more for its return.
void wrap_around(FamilySettings& settings, std::size_t keys) {
  for (auto& [name, parameter] : settings.parameters) {
    if (parameter.values().size() == 1) continue;
    std::vector<double> around(parameter.values().begin(),
                               parameter.values().begin() + static_cast<std::ptrdiff_t>(keys));
    around.push_back(around.front());
    parameter = PerKey(std::move(around));
  }
}

Expected<Settled> choose(const Method& method, const Keyframes& keys) {
  const auto index = method.own ? Expected<std::size_t>(0) : index_of(method.name);
  if (!index) return tl::unexpected(index.error());
  auto settings = settle(method.own ? method.own->info() : infos[*index], method.options, keys.size());
  if (!settings) return tl::unexpected(std::move(settings.error()));
  if (keys.data().jumps)
    return bad_option("jumps", "found two orientations at one time, wanted one curve through all keys");
  // Keys that were left out of others may be more uneven than these.
  if (auto error = check_times(keys.times())) return tl::unexpected(std::move(*error));
  if (!method.options.loop) return Settled{*index, method.own.get(), keys, std::move(*settings)};
  return closed_keys(keys, *method.options.loop).map([&](const ClosedKeys& closed) {
    settings->closure = closed.closure;
    wrap_around(*settings, closed.keys.size());
    return Settled{*index, method.own.get(), closed.keys, std::move(*settings)};
  });
}

}  // namespace

std::span<const FamilyInfo> families_info() noexcept { return infos; }

Expected<const FamilyInfo*> find_family(std::string_view name) {
  return index_of(name).map([](std::size_t i) { return &infos[i]; });
}

Expected<const FamilyInfo*> family_of_method(const Method& method) {
  return method.own ? &method.own->info() : find_family(method.name);
}

Expected<AnyCurve> make_curve(const Method& method, const Keyframes& keys) {
  return choose(method, keys).and_then([](const Settled& settled) { return settled.curve(); });
}

bool can_overwind(const Method& method) {
  return !method.own && entries[index_of(method.name).value()].widest_handle != nullptr;
}

Expected<std::optional<HandleTurn>> overwound_tangent(const Method& method, const Keyframes& keys) {
  return choose(method, keys).map([](const Settled& settled) -> std::optional<HandleTurn> {
    const WidestHandle widest_handle = settled.widest_handle();
    if (!widest_handle || settled.keys.size() == 1) return std::nullopt;
    const HandleTurn widest = widest_handle(settled.keys, settled.settings);
    return widest.turn >= full_turn ? std::optional(widest) : std::nullopt;
  });
}

Expected<PoseCurve> make_pose_curve(const Method& method, const Keyframes& keys) {
  return choose(method, keys).and_then([](const Settled& settled) -> Expected<PoseCurve> {
    auto curve = settled.curve();
    if (!curve) return tl::unexpected(std::move(curve.error()));
    if (settled.keys.positions().empty()) return PoseCurve{std::move(*curve)};
    return settled.path().map([&](AnyPath path) { return PoseCurve{std::move(*curve), std::move(path)}; });
  });
}

}}  // namespace orispline
