// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/contacts.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double near_ground = 0.04;      // leg lengths
constexpr double slow = 0.4;              // leg lengths [1/s]
constexpr double half_window = 0.1;       // of a speed [s]
constexpr double shortest_contact = 0.1;  // [s]
constexpr double coming = 0.1;            // before and behind a contact [s]
constexpr std::size_t most_turning = 3;   // joints of a leg
constexpr double usual_lowest = 0.05;     // share of frames that are below the ground's height
constexpr double stiffest = 10.0;  // of a hold beside the smallness of the turns; some seventh of a slide is left
constexpr double low = 0.1;        // heights of the figure, for ends of legs
constexpr double at_rest = 1e-6;   // [rad]
constexpr int iterations = 6;
constexpr double clearly_taller = 1.5;  // along z than along y, of a figure whose world has z up
constexpr int looks = 200;              // at a clip, for what is usual in it

/// From 0 to 1 with two derivatives that are 0 at both ends.
double eased(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

/// Joints that turn at the same key times, and what they carry.
struct Leg {
  std::vector<std::size_t> turning{};  ///< from above down
  std::vector<std::size_t> holds{};    ///< joints that stand
  double length = 0.0;
};

const RotationChannel* turning_channel(const Clip& clip, std::size_t joint) {
  const RotationChannel* const channel = channel_of(clip.rotations, joint);
  if (!channel || channel->interpolation != ChannelInterpolation::linear) return nullptr;
  const auto turns = [&](const Eigen::Quaterniond& q) {
    return angular_distance(q, channel->values.front()) > at_rest;
  };
  return std::ranges::any_of(channel->values, turns) ? channel : nullptr;
}

std::vector<std::size_t> above(const Skeleton& skeleton, std::size_t joint) {
  std::vector<std::size_t> joints;
  for (std::size_t j = skeleton[joint].parent; j != no_parent; j = skeleton[j].parent) joints.push_back(j);
  return joints;
}

/// The joints above one that turn at its key times, next to it first; none of `shared`.
std::vector<std::size_t> turning_above(const Skeleton& skeleton, const Clip& clip, std::size_t joint,
                                       const std::vector<std::size_t>& shared) {
  std::vector<std::size_t> found;
  const RotationChannel* first = nullptr;
  for (const std::size_t j : above(skeleton, joint)) {
    if (skeleton[j].parent == no_parent || std::ranges::find(shared, j) != shared.end()) break;
    const RotationChannel* const channel = turning_channel(clip, j);
    if (!channel || (first && channel->times != first->times)) continue;
    if (!first) first = channel;
    if (found.size() < most_turning) found.push_back(j);
  }
  return found;
}

double length_of(const Skeleton& skeleton, std::size_t from, std::size_t joint) {
  double length = 0.0;
  for (std::size_t j = joint; j != from && j != no_parent; j = skeleton[j].parent)
    length += skeleton[j].rest.translation.norm();
  return length;
}

/// Joints that stand, each leg with those of it.
std::vector<Leg> legs_of(const Skeleton& skeleton, const Clip& clip, const std::vector<std::size_t>& joints) {
  std::vector<Leg> legs;
  const auto is_above = [&](std::size_t joint, std::size_t other) {
    const auto joints_above = above(skeleton, other);
    return std::ranges::find(joints_above, joint) != joints_above.end();
  };
  for (const std::size_t joint : joints) {
    const auto same = std::ranges::find_if(legs, [&](const Leg& leg) { return is_above(leg.holds.front(), joint); });
    if (same != legs.end()) same->holds.push_back(joint);
    else legs.push_back({.holds = {joint}});
  }
  for (Leg& leg : legs) {
    std::vector<std::size_t> shared;
    for (const Leg& other : legs)
      if (&other != &leg)
        for (const std::size_t j : above(skeleton, other.holds.front())) shared.push_back(j);
    leg.turning = turning_above(skeleton, clip, leg.holds.back(), shared);
    std::ranges::reverse(leg.turning);
    if (!leg.turning.empty()) leg.length = length_of(skeleton, leg.turning.front(), leg.holds.back());
  }
  return legs;
}

/// Evenly over a clip.
std::vector<double> looks_at(const Clip& clip) {
  const Domain domain = clip.domain();
  std::vector<double> times;
  for (int i = 0; i <= looks; ++i) times.push_back(domain.start + (domain.end - domain.start) * i / looks);
  return times;
}

/// y, or z where the figure is usually far taller along z.
Eigen::Vector3d up_of(const Skeleton& skeleton, const Clip& clip) {
  const ClipMotion motion(skeleton, clip);
  Eigen::Vector3d extents = Eigen::Vector3d::Zero();
  for (const double t : looks_at(clip)) {
    Eigen::Vector3d lowest = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), highest = -lowest;
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      const Eigen::Vector3d place = motion.world_pose(j, t).translation();
      lowest = lowest.cwiseMin(place), highest = highest.cwiseMax(place);
    }
    extents += highest - lowest;
  }
  return extents.z() > clearly_taller * extents.y() ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
}

/// Where a joint is at the frames.
std::vector<Eigen::Vector3d> places_of(const ClipMotion& motion, std::size_t joint, std::span<const double> times) {
  std::vector<Eigen::Vector3d> places;
  for (const double t : times) places.push_back(motion.world_pose(joint, t).translation());
  return places;
}

double ground_below(std::span<const Eigen::Vector3d> places, const Eigen::Vector3d& up) {
  std::vector<double> heights;
  for (const Eigen::Vector3d& place : places) heights.push_back(up.dot(place));
  const auto lowest = heights.begin() + static_cast<std::ptrdiff_t>(usual_lowest * static_cast<double>(heights.size()));
  std::ranges::nth_element(heights, lowest);
  return *lowest;
}

/// Mean speed from half a window before to half a window behind.
double speed_at(std::size_t k, std::span<const Eigen::Vector3d> places, std::span<const double> times) {
  std::size_t first = k, last = k;
  while (first > 0 && times[k] - times[first] < half_window) --first;
  while (last + 1 < times.size() && times[last] - times[k] < half_window) ++last;
  return (places[last] - places[first]).norm() / (times[last] - times[first]);
}

double slide_of(const Contact& contact, std::span<const Eigen::Vector3d> places) {
  double way = 0.0;
  for (std::size_t k = contact.first + 1; k < contact.first + contact.count; ++k)
    way += (places[k] - places[k - 1]).norm();
  return way / (contact.end - contact.start);
}

std::vector<Contact> contacts_of(std::size_t joint, double leg, std::span<const Eigen::Vector3d> places,
                                 std::span<const double> times, const Eigen::Vector3d& up) {
  std::vector<Contact> contacts;
  const double ground = ground_below(places, up);
  std::size_t first = times.size();  // of a contact that has begun
  for (std::size_t k = 0; k <= times.size(); ++k) {
    const bool stands =
        k < times.size() && up.dot(places[k]) - ground <= near_ground * leg && speed_at(k, places, times) <= slow * leg;
    if (stands) first = std::min(first, k);
    if (stands || first >= k) continue;
    if (times[k - 1] - times[first] >= shortest_contact) {
      contacts.push_back(
          {.joint = joint, .first = first, .count = k - first, .start = times[first], .end = times[k - 1]});
      contacts.back().slide_before = slide_of(contacts.back(), places);
    }
    first = times.size();
  }
  return contacts;
}

/// That a joint be at a place, so strictly.
struct Hold {
  std::size_t joint;
  Eigen::Vector3d place;
  double weight;  ///< 1 within a contact, 0 far from it
};

/// Of a joint at every frame; between two contacts the place goes over from one to the other.
std::vector<std::optional<Hold>> holds_of(std::span<const Contact> contacts, std::span<const Eigen::Vector3d> places,
                                          std::span<const double> times) {
  std::vector<std::optional<Hold>> holds(times.size());
  std::vector<Eigen::Vector3d> sums(times.size(), Eigen::Vector3d::Zero());
  std::vector<double> all(times.size());
  for (const Contact& contact : contacts) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t k = contact.first; k < contact.first + contact.count; ++k)
      mean += places[k] / static_cast<double>(contact.count);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const bool is_within = k >= contact.first && k < contact.first + contact.count;
      const std::size_t edge = k < contact.first ? contact.first : contact.first + contact.count - 1;
      const double weight = is_within ? 1.0 : eased(1.0 - std::abs(times[k] - times[edge]) / coming);
      if (weight <= 0.0) continue;
      // What moves towards its contact is held as far off as it will be at its edge.
      sums[k] += weight * (is_within ? mean : Eigen::Vector3d(places[k] + mean - places[edge]));
      all[k] += weight;
    }
  }
  for (std::size_t k = 0; k < times.size(); ++k)
    if (all[k] > 0.0) holds[k] = Hold{contacts.front().joint, sums[k] / all[k], std::min(all[k], 1.0)};
  return holds;
}

/// A leg at one frame: what its turning joints have to turn by.
class Pose {
 public:
  Pose(const ClipMotion& motion, const Leg& leg, double t) : motion_(motion), leg_(leg), t_(t) {
    const std::size_t top = motion.skeleton()[leg.turning.front()].parent;
    above_ = motion.world_pose(top, t);
  }

  /// Turns of the joints, in their frames [rad], the smallest that hold what is to be held.
  [[nodiscard]] std::vector<Eigen::Vector3d> turns(std::span<const Hold> holds) const {
    std::vector<Eigen::Vector3d> turns(leg_.turning.size(), Eigen::Vector3d::Zero());
    const auto unknowns = static_cast<Eigen::Index>(3 * turns.size());
    for (int i = 0; i < iterations; ++i) {
      Eigen::MatrixXd normal = Eigen::MatrixXd::Identity(unknowns, unknowns);
      Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns), now(unknowns);
      for (std::size_t j = 0; j < turns.size(); ++j) now.segment<3>(static_cast<Eigen::Index>(3 * j)) = turns[j];
      for (const Hold& hold : holds) {
        const auto [place, jacobian] = place_of(hold.joint, turns);
        const double stiffness =
            stiffest * hold.weight / (1.0 + stiffest * (1.0 - hold.weight)) / (leg_.length * leg_.length);
        normal += stiffness * jacobian.transpose() * jacobian;
        right += stiffness * jacobian.transpose() * (hold.place - place + jacobian * now);
      }
      const Eigen::VectorXd solved = normal.ldlt().solve(right);
      for (std::size_t j = 0; j < turns.size(); ++j) turns[j] = solved.segment<3>(static_cast<Eigen::Index>(3 * j));
    }
    return turns;
  }

 private:
  struct Place {
    Eigen::Vector3d place;
    Eigen::MatrixXd by_turns;
  };

  [[nodiscard]] Place place_of(std::size_t joint, const std::vector<Eigen::Vector3d>& turns) const {
    // From the joint up: where it is in the frame of each joint above, until the leg ends.
    std::vector<std::size_t> way{joint};
    while (way.back() != leg_.turning.front()) way.push_back(motion_.skeleton()[way.back()].parent);
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    Eigen::MatrixXd by_turns = Eigen::MatrixXd::Zero(3, static_cast<Eigen::Index>(3 * turns.size()));
    for (const std::size_t j : way) {
      const JointPose pose = motion_.local_pose(j, t_);
      Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
      place = pose.scale.cwiseProduct(place);
      by_turns = pose.scale.asDiagonal() * by_turns;
      if (const auto found = std::ranges::find(leg_.turning, j); found != leg_.turning.end()) {
        const auto i = static_cast<std::size_t>(found - leg_.turning.begin());
        const Eigen::Matrix3d turned = exp<double>(turns[i]).toRotationMatrix();
        by_turns = turned * by_turns;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
          by_turns.col(static_cast<Eigen::Index>(3 * i) + axis) = turned * Eigen::Vector3d::Unit(axis).cross(place);
        place = turned * place;
      }
      by_turns = rotation * by_turns;
      place = pose.translation + rotation * place;
    }
    return {above_ * place, above_.linear() * by_turns};
  }

  const ClipMotion& motion_;
  const Leg& leg_;
  double t_;
  Eigen::Affine3d above_;
};

/// Holds the contacts of one leg.
void hold(const Skeleton& skeleton, Clip& clip, const Leg& leg, const Eigen::Vector3d& up, std::vector<Contact>& all) {
  const Clip before = clip;
  const ClipMotion motion(skeleton, before);
  const SharedList<double> times = turning_channel(before, leg.turning.back())->times;
  std::vector<std::vector<std::optional<Hold>>> holds;
  std::vector<Contact> found;
  for (const std::size_t joint : leg.holds) {
    const auto places = places_of(motion, joint, times);
    const auto contacts = contacts_of(joint, leg.length, places, times, up);
    if (!contacts.empty()) holds.push_back(holds_of(contacts, places, times));
    found.insert(found.end(), contacts.begin(), contacts.end());
  }
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::vector<Hold> now;
    for (const auto& of_joint : holds)
      if (of_joint[k]) now.push_back(*of_joint[k]);
    if (now.empty()) continue;
    const auto turns = Pose(motion, leg, times[k]).turns(now);
    for (std::size_t j = 0; j < turns.size(); ++j) {
      Eigen::Quaterniond& value = std::ranges::find(clip.rotations, leg.turning[j], &RotationChannel::joint)->values[k];
      value = (value * exp<double>(turns[j])).normalized();
    }
  }
  const ClipMotion after(skeleton, clip);
  for (Contact& contact : found) contact.slide_after = slide_of(contact, places_of(after, contact.joint, times));
  all.insert(all.end(), found.begin(), found.end());
}

tl::unexpected<Error> no_joint(std::string message) { return bad_option("keep_contacts", std::move(message)); }

Expected<std::vector<std::size_t>> joints_named(const Skeleton& skeleton, std::span<const std::string> names) {
  std::vector<std::size_t> joints;
  for (const std::string& name : names) {
    const auto joint = skeleton.find(name);
    if (!joint) return no_joint(formatted("found no joint {}, wanted names of the skeleton or auto", in_quotes(name)));
    if (above(skeleton, *joint).size() < 2)
      return no_joint(formatted("found joint {}, which has no leg above it, wanted the end of a leg", in_quotes(name)));
    joints.push_back(*joint);
  }
  std::ranges::sort(joints);
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

/// Those that turn, have two joints above them that turn, and come as low as any.
std::vector<std::size_t> ends_of_legs(const Skeleton& skeleton, const Clip& clip, const Eigen::Vector3d& up) {
  const ClipMotion motion(skeleton, clip);
  const std::vector<double> times = looks_at(clip);
  std::vector<double> grounds(skeleton.size());
  for (std::size_t j = 0; j < skeleton.size(); ++j) grounds[j] = ground_below(places_of(motion, j, times), up);
  const auto [lowest, highest] = std::ranges::minmax(grounds);
  std::vector<std::size_t> ends;
  for (std::size_t j = 0; j < skeleton.size(); ++j)
    if (grounds[j] - lowest <= low * (highest - lowest) && turning_channel(clip, j) &&
        turning_above(skeleton, clip, j, {}).size() > 1)
      ends.push_back(j);
  return ends;
}

}  // namespace

Expected<HeldContacts> held_contacts(const Skeleton& skeleton, const Clip& clip, std::span<const std::string> names) {
  const Eigen::Vector3d up = up_of(skeleton, clip);
  const bool are_all = names.size() == 1 && names.front() == all_legs && !skeleton.find(all_legs);
  const auto joints =
      are_all ? Expected<std::vector<std::size_t>>(ends_of_legs(skeleton, clip, up)) : joints_named(skeleton, names);
  if (!joints) return tl::unexpected(joints.error());
  HeldContacts held{.clip = clip};
  for (const Leg& leg : legs_of(skeleton, clip, *joints)) {
    if (!leg.turning.empty() && leg.length > 0.0) hold(skeleton, held.clip, leg, up, held.contacts);
  }
  return held;
}

}}  // namespace orispline
