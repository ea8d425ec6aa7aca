// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh/writer.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

std::string offset_of(const Eigen::Vector3d& offset) {
  std::string text;
  std::array<char, shortest_text_room> room;
  for (Eigen::Index i = 0; i < 3; ++i)
    text.append(i == 0 ? "" : " ").append(room.data(), write_shortest_text(room.data(), offset[i]));
  return text;
}

/// `hand_End`, `hand_End2`
bool is_name_of_end_site(std::string_view name) {
  while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.remove_suffix(1);
  return name.ends_with("_End");
}

/// Chooses joints of a skeleton and lists them depth first.
class Planner {
 public:
  Planner(const Skeleton& skeleton, const Clip& clip, const EulerOrder& order)
      : skeleton_(skeleton), order_(order), turns_(skeleton.size()), moves_(skeleton.size()) {
    for (const RotationChannel& channel : clip.rotations) turns_[channel.joint] = true;
    for (const VectorChannel& channel : clip.translations) moves_[channel.joint] = true;
    choose();
    children_.resize(skeleton.size());
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
      if (!chosen_[j]) continue;
      if (skeleton[j].parent == no_parent) roots_.push_back(j);
      else children_[skeleton[j].parent].push_back(j);
    }
  }

  [[nodiscard]] Expected<Plan> plan() {
    const bool is_wrapped = roots_.size() > 1;
    if (is_wrapped) plan_.push_back({.name = free_name(), .written = {.offset = "0 0 0"}});
    std::vector<std::pair<std::size_t, std::size_t>> open;  // joints to come, the next one last, with their depths
    const auto push = [&](const std::vector<std::size_t>& joints, std::size_t depth) {
      for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) open.emplace_back(*joint, depth);
    };
    push(roots_, is_wrapped ? 1 : 0);
    while (!open.empty()) {
      const auto [joint, depth] = open.back();
      open.pop_back();
      if (depth + 1 >= deepest_joint)
        return failure(ErrorCode::bad_data,
                       formatted("joint {}: found joints nested deeper than {}, wanted at most that",
                                 in_quotes(skeleton_[joint].name), deepest_joint));
      add(joint, depth);
      push(children_[joint], depth + 1);
    }
    return std::move(plan_);
  }

 private:
  void choose() {
    chosen_.resize(skeleton_.size());
    for (std::size_t j = skeleton_.size(); j-- > 0;) {
      if (turns_[j] || moves_[j]) chosen_[j] = true;
      if (chosen_[j] && skeleton_[j].parent != no_parent) chosen_[skeleton_[j].parent] = true;
    }
    if (std::ranges::find(chosen_, true) == chosen_.end()) chosen_.assign(skeleton_.size(), true);
    std::vector<bool> below(skeleton_.size());  // an animated joint, or it
    for (std::size_t j = 0; j < skeleton_.size(); ++j) {
      const std::size_t parent = skeleton_[j].parent;
      below[j] = turns_[j] || moves_[j] || (parent != no_parent && below[parent]);
      if (below[j]) chosen_[j] = true;
    }
  }

  void add(std::size_t joint, std::size_t depth) {
    const Joint& of_skeleton = skeleton_[joint];
    PlannedJoint planned{.name = of_skeleton.name, .depth = depth, .joint = joint};
    planned.written.offset = offset_of(of_skeleton.rest.translation);
    if (of_skeleton.parent == no_parent || moves_[joint]) planned.written.columns = position_columns();
    constexpr double off = 1e-12;  // [rad]
    const bool is_turned = angular_distance(of_skeleton.rest.rotation, Eigen::Quaterniond::Identity()) > off;
    if (turns_[joint] || is_turned)
      for (const Column& column : columns_of(order_)) planned.written.columns.push_back(column);
    const bool is_leaf = children_[joint].empty();
    planned.written.is_end_site = is_leaf && planned.written.columns.empty() && is_name_of_end_site(of_skeleton.name);
    plan_.push_back(std::move(planned));
    if (is_leaf && !plan_.back().written.is_end_site)
      plan_.push_back({.depth = depth + 1, .written = {.offset = "0 0 0", .is_end_site = true}});
  }

  [[nodiscard]] std::string free_name() const {
    std::string name = "root";
    while (skeleton_.find(name)) name += '_';
    return name;
  }

  const Skeleton& skeleton_;
  EulerOrder order_;
  std::vector<bool> turns_, moves_, chosen_{};  // by their joints
  std::vector<std::vector<std::size_t>> children_{};
  std::vector<std::size_t> roots_{};
  Plan plan_{};
};

/// A name without what ends names in BVH.
std::string written_name(std::string_view name) {
  std::string written(name);
  for (char& c : written)
    if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f' || c == '{' || c == '}') c = '_';
  return written.empty() ? "joint" : written;
}

/// Writes joint by joint, and closes those that have no more children.
class HierarchyWriter {
 public:
  explicit HierarchyWriter(std::string_view line_end) : line_end_(line_end) { line("HIERARCHY"); }

  void add(const PlannedJoint& joint) {
    close_to(joint.depth);
    line(joint.written.is_end_site ? "End Site" : formatted("{} {}", depth_ == 0 ? "ROOT" : "JOINT", name_of(joint)));
    line("{");
    ++depth_;
    line("OFFSET " + joint.written.offset);
    if (joint.written.is_end_site) return;
    std::string channels = formatted("CHANNELS {}", joint.written.columns.size());
    for (const auto& [kind, axis] : joint.written.columns)
      channels += formatted(" {}{}", "XYZ"[axis], kind == Column::Kind::position ? "position" : "rotation");
    line(channels);
  }

  [[nodiscard]] HierarchyText finish() {
    close_to(0);
    return std::move(written_);
  }

 private:
  void close_to(std::size_t depth) {
    while (depth_ > depth) {
      --depth_;
      line("}");
    }
  }

  [[nodiscard]] std::string name_of(const PlannedJoint& joint) {
    std::string name = written_name(joint.name);
    if (name != joint.name) ++written_.renamed;
    return name;
  }

  void line(std::string_view text) { written_.text.append(depth_, '\t').append(text).append(line_end_); }

  std::string_view line_end_;
  std::size_t depth_ = 0;
  HierarchyText written_;
};

}  // namespace

Plan plan_of(const Source& source) {
  Plan plan;
  for (std::size_t j = 0; j < source.joints.size(); ++j) {
    const std::size_t parent = source.skeleton[j].parent;
    plan.push_back({.name = source.skeleton[j].name,
                    .depth = parent == no_parent ? 0 : plan[parent].depth + 1,
                    .joint = j,
                    .written = source.joints[j]});
  }
  return plan;
}

Expected<Plan> plan_of(const Skeleton& skeleton, const Clip& clip, const EulerOrder& order) {
  return Planner(skeleton, clip, order).plan();
}

std::vector<Column> columns_of(const EulerOrder& order) {
  std::vector<Column> columns;
  for (const int turn : order.turns) columns.push_back({Column::Kind::rotation, turn});
  if (order.axes == EulerOrder::Axes::of_world) std::ranges::reverse(columns);
  return columns;
}

std::vector<Column> position_columns() {
  std::vector<Column> columns;
  for (const int axis : {0, 1, 2}) columns.push_back({Column::Kind::position, axis});
  return columns;
}

HierarchyText text_of(const Plan& plan, std::string_view line_end) {
  HierarchyWriter writer(line_end);
  for (const PlannedJoint& joint : plan) writer.add(joint);
  return writer.finish();
}

}}}  // namespace orispline::scenes::bvh
