// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/measured.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <orispline/families/auto.hpp>
#include <orispline/families/key_windows.hpp>
#include <orispline/math/median.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace families {
namespace {

constexpr std::size_t first_share = 1;  // among the parameters, in the order of the models

double value(const FamilySettings& settings, std::string_view name) { return settings.per_key(name)[0]; }

std::string_view share_name(std::size_t model) { return Measured::parameters[first_share + model].name; }

double given_shares(const FamilySettings& settings) {
  double sum = 0.0;
  for (std::size_t m = 0; m < model_count; ++m) sum += value(settings, share_name(m));
  return sum;
}

/// Shares as they are given, or as parts of their sum.
std::array<double, model_count> shares_in(const FamilySettings& settings) {
  constexpr double rounding = 1e-9;
  const double sum = given_shares(settings), unit = std::abs(sum - 1.0) <= rounding ? 1.0 : sum;
  std::array<double, model_count> shares;
  for (std::size_t m = 0; m < model_count; ++m) shares[m] = value(settings, share_name(m)) / unit;
  return shares;
}

bool all_given(const FamilySettings& settings) {
  return value(settings, "interval") > 0.0 && given_shares(settings) > 0.0 && value(settings, "polynomial") >= 0.0 &&
         value(settings, "polynomial9") >= 0.0;
}

/// Rates of `auto` at the keys, and what the models add to them.
class FittedRates {
 public:
  FittedRates(const Keyframes& keys, Through through, const KeyFindings& findings)
      : windows_(keys, through, findings.interval), interval_(findings.interval), belief_(findings.belief) {
    shares_ = Eigen::Map<const PerModel>(belief_.models.data());
    shares_[0] = 0.0;  // the plain spline's is that of `auto`
  }

  [[nodiscard]] AutoRates& along() { return windows_.along(); }

  [[nodiscard]] WindowRates at(std::size_t i) {
    windows_.go_to(i);
    WindowRates rates = with_nine(windows_.along().rates(i, belief_.polynomial));
    const double share = windows_.trust() * (1.0 - belief_.polynomial * windows_.smooth());
    const double sum = shares_.sum();
    if (!(share * sum > 0.0)) return rates;
    const ModelMaps& models = windows_.maps().models;
    std::array<double, window_keys> first, second;
    for (std::size_t j = 0; j < window_keys; ++j) {
      first[j] = (models.first[j] * shares_).sum();
      second[j] = (models.second[j] * shares_).sum();
    }
    const WindowRates fitted = applied(first, second);
    return {rates.first + share * (fitted.first - sum * rates.first),
            rates.second + share * (fitted.second - sum * rates.second)};
  }

 private:
  [[nodiscard]] WindowRates applied(const std::array<double, window_keys>& first,
                                    const std::array<double, window_keys>& second) const {
    return {windows_.applied(first) / interval_, windows_.applied(second) / (interval_ * interval_)};
  }
  [[nodiscard]] WindowRates with_nine(const WindowRates& rates) {
    const double share = belief_.polynomial * belief_.polynomial9 * windows_.smooth9();
    if (!(share > 0.0)) return rates;
    const WindowMaps& maps = windows_.maps();
    return blended(rates, applied(maps.first9, maps.second9), share);
  }

  KeyWindows windows_;
  double interval_;
  ModelBelief belief_;
  PerModel shares_;
};

}  // namespace

KeyFindings findings_of(const Keyframes& keys, Through through, const FamilySettings& settings) {
  KeyFindings findings;
  findings.interval = value(settings, "interval");
  if (!(findings.interval > 0.0)) findings.interval = median_interval(keys.times());
  findings.given = all_given(settings);
  KeyWindows windows(keys, through, findings.interval);
  ModelWeighing weighing(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    windows.go_to(i);
    findings.trust += windows.trust();
    if (!findings.given && i > 0 && i + 1 < keys.size()) weighing.add(i, windows.misses());
  }
  findings.trust /= static_cast<double>(keys.size());
  if (!findings.given) findings.belief = weighing.belief();
  if (keys.size() < least_weighed) findings.belief.models = ModelBelief{}.models;
  if (given_shares(settings) > 0.0) findings.belief.models = shares_in(settings);
  if (value(settings, "polynomial") >= 0.0) findings.belief.polynomial = value(settings, "polynomial");
  if (value(settings, "polynomial9") >= 0.0) findings.belief.polynomial9 = value(settings, "polynomial9");
  return findings;
}

std::optional<std::size_t> Measured::keys_beside(const FamilySettings& settings) {
  if (all_given(settings)) return window_keys / 2;
  return std::nullopt;
}

Expected<ChartCurve<5>> Measured::curve(const Keyframes& keys, const FamilySettings& settings) {
  if (keys.size() < least_window)
    return settle(Auto::info, {}, keys.size()).and_then([&](const FamilySettings& own) {
      return Auto::curve(keys, own);
    });
  FittedRates rates(keys, Through::orientations, findings_of(keys, Through::orientations, settings));
  return quintics_through(keys, rates.along(), [&](std::size_t i) { return rates.at(i); });
}

Expected<HermitePath<5>> Measured::path(const Keyframes& keys, const FamilySettings& settings) {
  if (keys.size() < least_window)
    return settle(Auto::info, {}, keys.size()).and_then([&](const FamilySettings& own) {
      return Auto::path(keys, own);
    });
  FittedRates rates(keys, Through::positions, findings_of(keys, Through::positions, settings));
  return quintic_path_through(keys, rates.along(), [&](std::size_t i) { return rates.at(i); });
}

}  // namespace families

Expected<std::optional<KeyFindings>> key_findings(const Method& method, const Keyframes& keys) {
  auto settings = settle(families::Measured::info, method.options, keys.size());
  if (!settings) return tl::unexpected(std::move(settings.error()));
  if (keys.size() < families::least_window) return std::nullopt;
  return families::findings_of(keys, families::Through::orientations, *settings);
}

Method with_findings(Method method, const KeyFindings& findings) {
  auto& given = method.options.parameters;
  given["interval"] = {findings.interval};
  for (std::size_t m = 0; m < families::model_count; ++m)
    given[std::string(families::share_name(m))] = {findings.belief.models[m]};
  given["polynomial"] = {findings.belief.polynomial};
  given["polynomial9"] = {findings.belief.polynomial9};
  return method;
}

}}  // namespace orispline
