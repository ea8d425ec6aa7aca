// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/key_windows.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

constexpr std::size_t window_reach = window_keys / 2;

/// Where a window of so many keys around key i begins; at the ends it is shifted inwards.
std::size_t first_of_window(std::size_t i, std::size_t count, std::size_t keys) {
  return std::min(i - std::min(i, count / 2), keys - count);
}

/// One over the products of the distances of `count` keys from number `first` on to the others among them, as shares of
/// that of the centre.
std::array<double, window_keys> relative_weights(const WindowTimes& window, std::size_t first, std::size_t count) {
  const auto product = [&](std::size_t j) {
    double all = 1.0;
    for (std::size_t k = first; k < first + count; ++k)
      if (k != j) all *= window.x[j] - window.x[k];
    return all;
  };
  std::array<double, window_keys> weights{};
  const double centre = product(window.centre);
  for (std::size_t j = first; j < first + count; ++j) weights[j] = centre / product(j);
  return weights;
}

WindowMaps maps_of(const WindowTimes& window, std::size_t first7) {
  WindowMaps maps{.models = model_maps(window),
                  .miss7 = relative_weights(window, first7, 7),
                  .miss9 = relative_weights(window, 0, window_keys),
                  .first9 = {},
                  .second9 = {}};
  const std::size_t p = window.centre;
  double sum = 0.0;
  for (std::size_t j = 0; j < window_keys; ++j)
    if (j != p) sum += maps.first9[j] = -maps.miss9[j] / window.x[j];
  maps.first9[p] = -sum;
  for (std::size_t j = 0; j < window_keys; ++j)
    if (j != p) maps.second9[j] = 2.0 * maps.first9[j] * (maps.first9[p] + 1.0 / window.x[j]);
  return maps;
}

}  // namespace

WindowTimes window_times(std::span<const double> times, std::size_t first, std::size_t i, double interval) {
  WindowTimes window{.x = {}, .centre = i - first};
  WindowTimes even = window;
  const double size = std::max(std::abs(times[first]), std::abs(times[first + window_keys - 1]));
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * size / interval;
  bool is_even = true;
  for (std::size_t j = 0; j < window_keys; ++j) {
    window.x[j] = (times[first + j] - times[i]) / interval;
    even.x[j] = static_cast<double>(j) - static_cast<double>(window.centre);
    is_even = is_even && std::abs(window.x[j] - even.x[j]) <= rounding;
  }
  return is_even ? even : window;
}

KeyWindows::KeyWindows(const Keyframes& keys, Through through, double interval)
    : times_(keys.times()), along_(keys, through, 3, window_reach), interval_(interval) {}

void KeyWindows::go_to(std::size_t i) {
  along_.go_to(i);
  key_ = i;
  first_ = first_of_window(i, window_keys, times_.size());
  trust_ = trust_of_window();
  const AutoRates::Stretch nine{first_ + 2, first_ + 6};
  smooth_ = smooth_share(along_.roughness(along_.stretch_of(i), nine));
  smooth9_ = trust_ > 0.0 && smooth_ > 0.0 ? trust_ * smooth_share(along_.roughness(nine, nine)) : 0.0;
  has_maps_ = false;
  if (!(trust_ > 0.0)) return;
  for (std::size_t j = 0; j < window_keys; ++j) increments_[j] = along_.increment(i, first_ + j);
}

double KeyWindows::trust_of_window() const {
  double widest = 0.0;
  for (std::size_t k = first_; k + 1 < first_ + window_keys; ++k) widest = std::max(widest, times_[k + 1] - times_[k]);
  return window_share(along_.turn_beside(key_, window_reach)) * (1.0 - gap_of(widest / interval_));
}

const WindowMaps& KeyWindows::maps() {
  if (!has_maps_) {
    window_ = window_times(times_, first_, key_, interval_);
    is_even_ = window_.centre == window_reach;
    for (std::size_t j = 0; j < window_keys && is_even_; ++j)
      is_even_ = window_.x[j] == static_cast<double>(j) - static_cast<double>(window_reach);
    const std::size_t first7 = first_of_window(key_, 7, times_.size()) - first_;
    if (!is_even_) maps_ = maps_of(window_, first7);
    else if (!even_) even_ = maps_of(window_, first7);
    has_maps_ = true;
  }
  return is_even_ ? *even_ : maps_;
}

std::array<PerModel, 3> KeyWindows::model_misses() {
  const ModelMaps& models = maps().models;
  std::array<PerModel, 3> misses{PerModel::Zero(), PerModel::Zero(), PerModel::Zero()};
  for (std::size_t j = 0; j < window_keys; ++j)
    for (std::size_t axis = 0; axis < 3; ++axis)
      misses[axis] += models.miss[j] * increments_[j][static_cast<Eigen::Index>(axis)];
  return misses;
}

KeyMisses KeyWindows::misses() {
  KeyMisses found{
      .models = PerModel::Zero(), .trust = trust_, .seven = 0.0, .nine = 0.0, .smooth = 0.0, .smooth9 = 0.0};
  if (!(trust_ > 0.0)) return found;
  const auto by_model = model_misses();
  found.models = by_model[0].square() + by_model[1].square() + by_model[2].square();
  found.smooth = trust_ * smooth_;
  found.smooth9 = smooth9_;
  if (found.smooth > 0.0) found.seven = applied(maps().miss7).squaredNorm();
  if (found.smooth9 > 0.0) found.nine = applied(maps().miss9).squaredNorm();
  return found;
}

Eigen::Vector3d KeyWindows::applied(const std::array<double, window_keys>& factors) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t j = 0; j < window_keys; ++j) sum += factors[j] * increments_[j];
  return sum;
}

}}}  // namespace orispline::families
