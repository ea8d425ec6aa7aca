// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/clip_difference.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Hash = std::uint64_t;

Hash mixed(Hash hash, Hash more) noexcept {
  return (hash ^ (more + 0x9e3779b97f4a7c15U + (hash << 6) + (hash >> 2))) * 0xbf58476d1ce4e5b9U;
}

Hash hash_of(const Joint& joint) {
  Hash hash = std::hash<std::string_view>()(joint.name);
  const auto add = [&](double number) { hash = mixed(hash, std::hash<double>()(number)); };
  for (const double number : joint.rest.translation) add(number);
  for (const double number : joint.rest.rotation.coeffs()) add(number);
  for (const double number : joint.rest.scale) add(number);
  return hash;
}

/// A skeleton from its roots down.
struct Tree {
  const Skeleton& skeleton;
  std::vector<std::size_t> roots{};
  std::vector<std::vector<std::size_t>> children{};
  std::vector<Hash> looks{};  ///< of each joint and all that is below it, whatever their order
  std::vector<bool> taken{};  ///< has its counterpart

  explicit Tree(const Skeleton& of) : skeleton(of), children(of.size()), looks(of.size()), taken(of.size()) {
    for (std::size_t i = 0; i < of.size(); ++i)
      (of[i].parent == no_parent ? roots : children[of[i].parent]).push_back(i);
    std::vector<Hash> below(of.size());
    for (std::size_t i = of.size(); i-- > 0;) {
      looks[i] = mixed(hash_of(of[i]), below[i]);
      if (of[i].parent != no_parent) below[of[i].parent] += looks[i];
    }
  }
};

/// Joints of both skeletons that may be the same.
struct Candidates {
  std::vector<std::size_t> first{}, second{};

  [[nodiscard]] bool is_one_of_each() const noexcept { return first.size() == 1 && second.size() == 1; }
};

enum class Found { by_path, by_name };

class Matcher {
 public:
  Matcher(const Skeleton& first, const Skeleton& second) : first_(first), second_(second) {
    found_.joints.assign(first.size(), no_parent);
  }

  [[nodiscard]] Counterparts all() && {
    match_all(by_names(first_.roots, second_.roots));
    match_below();
    match_elsewhere([](const Candidates& named, const Candidates&) { return named.is_one_of_each(); });
    match_elsewhere([](const Candidates&, const Candidates& left) { return left.is_one_of_each(); });
    match_elsewhere([](const Candidates&, const Candidates&) { return true; });
    found_.only_in_first = static_cast<std::size_t>(std::ranges::count(first_.taken, false));
    found_.only_in_second = static_cast<std::size_t>(std::ranges::count(second_.taken, false));
    std::ranges::sort(found_.by_name);
    std::ranges::sort(found_.guessed);
    return std::move(found_);
  }

 private:
  using Names = std::map<std::string_view, Candidates>;

  /// Those that have no counterpart yet.
  [[nodiscard]] Candidates without_counterpart(const Candidates& candidates) const {
    Candidates left;
    std::ranges::copy_if(candidates.first, std::back_inserter(left.first), [&](auto i) { return !first_.taken[i]; });
    std::ranges::copy_if(candidates.second, std::back_inserter(left.second), [&](auto i) { return !second_.taken[i]; });
    return left;
  }

  [[nodiscard]] Names by_names(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second) const {
    const auto [of_first, of_second] = without_counterpart({first, second});
    Names names;
    for (const std::size_t i : of_first) names[first_.skeleton[i].name].first.push_back(i);
    for (const std::size_t i : of_second) names[second_.skeleton[i].name].second.push_back(i);
    return names;
  }

  void match_all(const Names& names) {
    for (const auto& [name, candidates] : names) match(candidates, Found::by_path);
  }

  /// Of one name: those that look alike, then by their order.
  void match(const Candidates& candidates, Found how) {
    if (candidates.is_one_of_each()) return pair(candidates.first[0], candidates.second[0], how);
    std::map<Hash, Candidates> alike;
    for (const std::size_t i : candidates.first) alike[first_.looks[i]].first.push_back(i);
    for (const std::size_t i : candidates.second) alike[second_.looks[i]].second.push_back(i);
    for (const auto& [looks, group] : alike) {
      if (group.is_one_of_each()) pair(group.first[0], group.second[0], how);
      else guess(group);
    }
    guess(without_counterpart(candidates));
  }

  void guess(const Candidates& candidates) {
    for (std::size_t k = 0; k < std::min(candidates.first.size(), candidates.second.size()); ++k) {
      pair(candidates.first[k], candidates.second[k], Found::by_path);
      found_.guessed.push_back(candidates.first[k]);
    }
  }

  void pair(std::size_t first, std::size_t second, Found how) {
    found_.joints[first] = second;
    first_.taken[first] = second_.taken[second] = true;
    if (how == Found::by_name) found_.by_name.push_back(first);
    to_go_.emplace_back(first, second);
  }

  /// What is below counterparts, and below those found there.
  void match_below() {
    while (!to_go_.empty()) {
      const auto [first, second] = to_go_.back();
      to_go_.pop_back();
      match_all(by_names(first_.children[first], second_.children[second]));
    }
  }

  /// Name by name what has no counterpart by its path, and what is below it: if they will do, those of the name that
  /// had none at first, and those that are left of them.
  template <class WillDo>
  void match_elsewhere(WillDo will_do) {
    const Names names = by_names(all_of(first_), all_of(second_));
    for (std::size_t i = 0; i < first_.skeleton.size(); ++i) {
      const auto named = names.find(first_.skeleton[i].name);
      if (named == names.end() || named->second.first.empty() || named->second.first.front() != i) continue;
      const Candidates left = without_counterpart(named->second);
      if (left.first.empty() || left.second.empty() || !will_do(named->second, left)) continue;
      match(left, Found::by_name);
      match_below();
    }
  }

  static std::vector<std::size_t> all_of(const Tree& tree) {
    std::vector<std::size_t> all(tree.skeleton.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }

  Tree first_, second_;
  Counterparts found_{};
  std::vector<std::pair<std::size_t, std::size_t>> to_go_{};  ///< counterparts whose children are still to be matched
};

}  // namespace

Counterparts counterparts_of(const Skeleton& first, const Skeleton& second) { return Matcher(first, second).all(); }

}}  // namespace orispline
