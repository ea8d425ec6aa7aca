// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/formatted.hpp>
#include <orispline/scenes/bvh_plan.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

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

HierarchyText text_of(const Plan& plan, std::string_view line_end) {
  HierarchyWriter writer(line_end);
  for (const PlannedJoint& joint : plan) writer.add(joint);
  return writer.finish();
}

}}}  // namespace orispline::scenes::bvh
