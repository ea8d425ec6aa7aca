// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/inserted_keys.hpp>

#include <cmath>
#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// A pose, without a position where there are none.
struct Place {
  Eigen::Quaterniond orientation;
  Eigen::Vector3d position;
};

Place place_on(const PoseCurve& curve, double t) {
  return {curve.orientation(t), curve.position ? curve.position->linear_motion(t).position : Eigen::Vector3d::Zero()};
}

Place place_of(const Keyframes& keys, std::size_t i) {
  return {keys.orientations()[i], keys.positions().empty() ? Eigen::Vector3d::Zero().eval() : keys.positions()[i]};
}

bool are_apart(const Place& a, const Place& b) {
  return increment(a.orientation, b.orientation).norm() > least_moves * rest_angle ||
         (a.position - b.position).norm() > least_moves * rest_length;
}

/// Keys that are put one after the other.
class KeyList {
 public:
  explicit KeyList(bool has_positions) : has_positions_(has_positions) {}

  void add(double t, const Place& place) {
    data_.times.push_back(t);
    data_.orientations.push_back(place.orientation);
    if (has_positions_) data_.positions.push_back(place.position);
  }
  void insert(double t, const Place& place) {
    inserted_.push_back(data_.times.size());
    add(t, place);
  }
  [[nodiscard]] Expected<MoreKeys> all() && {
    return Keyframes::make(std::move(data_), Signs::as_given).map([this](Keyframes keys) {
      return MoreKeys{std::move(keys), std::move(inserted_)};
    });
  }

 private:
  bool has_positions_;
  KeyframeData data_;
  std::vector<std::size_t> inserted_;
};

}  // namespace

Expected<MoreKeys> with_more_keys(const Keyframes& keys, const PoseCurve& curve, const KeysPerInterval& count) {
  KeyList list(!keys.positions().empty());
  const std::size_t last = keys.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const Place from = place_of(keys, i), to = place_of(keys, i + 1);
    list.add(keys.times()[i], from);
    if (keys.rests_after(i)) continue;
    const bool starts = i == 0 || keys.rests_after(i - 1), stops = i + 1 == last || keys.rests_after(i + 1);
    const std::size_t pieces = 1 + (starts || stops ? count.at_ends : count.inside);
    Place before = from;
    for (std::size_t k = 1; k < pieces; ++k) {
      const double t =
          std::lerp(keys.times()[i], keys.times()[i + 1], static_cast<double>(k) / static_cast<double>(pieces));
      const Place place = place_on(curve, t);
      if (!are_apart(before, place) || !are_apart(place, to)) continue;
      list.insert(t, place);
      before = place;
    }
  }
  list.add(keys.times()[last], place_of(keys, last));
  return std::move(list).all();
}

}}  // namespace orispline
