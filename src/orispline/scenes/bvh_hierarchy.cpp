// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh_hierarchy.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/bvh_word.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr std::size_t most_columns = 6;  // of a joint

/// `Xposition`, `zrotation`; nothing for any other word.
std::optional<Column> column_of(std::string_view word) {
  if (word.empty()) return std::nullopt;
  const std::size_t axis = std::string_view("xyzXYZ").find(word.front());
  if (axis == std::string_view::npos) return std::nullopt;
  for (const auto& [name, kind] :
       {std::pair("position", Column::Kind::position), std::pair("rotation", Column::Kind::rotation)})
    if (is_word(word.substr(1), name)) return Column{kind, static_cast<int>(axis % 3)};
  return std::nullopt;
}

bool ends_columns(std::string_view word) {
  for (const std::string_view keyword : {"", "{", "}", "OFFSET", "CHANNELS", "JOINT", "End", "ROOT", "MOTION"})
    if (is_word(word, keyword)) return true;
  return false;
}

class HierarchyReader {
 public:
  explicit HierarchyReader(Text& text) : text_(text) {}

  Expected<Hierarchy> read() {
    if (const auto word = text_.next(); !is_word(word, "HIERARCHY")) return text_.refused(word, "HIERARCHY");
    while (true) {
      const std::string_view word = text_.next();
      if (open_.empty() && !found_.joints.empty() && is_word(word, "MOTION")) return std::move(found_);
      if (auto done = open_.empty() ? outside(word) : inside(word); !done)
        return tl::unexpected(std::move(done.error()));
    }
  }

 private:
  /// A joint whose closing brace is still to come.
  struct Open {
    std::size_t joint;
    bool has_offset = false, has_channels = false, has_children = false;
    std::size_t end_sites = 0;
  };

  Expected<void> outside(std::string_view word) {
    if (is_word(word, "ROOT")) return joint();
    return text_.refused(word, found_.joints.empty() ? "ROOT" : "ROOT or MOTION");
  }

  Expected<void> inside(std::string_view word) {
    const bool is_end_site = found_.written[open_.back().joint].is_end_site;
    if (is_word(word, "OFFSET")) return offset();
    if (word == "}") return close();
    if (!is_end_site && is_word(word, "CHANNELS")) return channels();
    if (!is_end_site && is_word(word, "JOINT")) return joint();
    if (!is_end_site && is_word(word, "End")) return end_site();
    return text_.refused(word, is_end_site ? "OFFSET or '}'" : "OFFSET, CHANNELS, JOINT, End Site or '}'");
  }

  Expected<void> joint() {
    const std::string_view name = text_.rest_of_line();
    if (name.empty()) return text_.fault("found a joint without a name, wanted its name on the line of its keyword");
    if (printable(name) != name)
      return text_.fault(
          formatted("found the name {} with a control character, wanted a name without", in_quotes(name)));
    return open(text_of_unicode(name), {});
  }

  Expected<void> end_site() {
    if (const auto word = text_.next(); !is_word(word, "Site")) return text_.refused(word, "Site");
    static_cast<void>(text_.rest_of_line());
    const std::size_t count = ++open_.back().end_sites;
    const std::string& parent = found_.joints[open_.back().joint].name;
    return open(formatted("{}_End{}", parent, count == 1 ? "" : std::to_string(count)), {.is_end_site = true});
  }

  Expected<void> open(std::string name, WrittenJoint written) {
    found_.lines.push_back(text_.line());
    if (const auto word = text_.next(); word != "{") return text_.refused(word, "'{'");
    if (open_.size() == deepest_joint)
      return text_.fault(formatted("found joints nested deeper than {}, wanted at most that", deepest_joint));
    if (!open_.empty()) open_.back().has_children = true;
    found_.joints.push_back({.name = std::move(name), .parent = open_.empty() ? no_parent : open_.back().joint});
    found_.written.push_back(std::move(written));
    open_.push_back({.joint = found_.joints.size() - 1});
    return {};
  }

  Expected<void> close() {
    if (!open_.back().has_offset)
      return text_.fault(formatted("found no OFFSET of the joint {}, wanted one", in_quotes(name())));
    open_.pop_back();
    return {};
  }

  Expected<void> offset() {
    if (std::exchange(open_.back().has_offset, true))
      return text_.fault(formatted("found a second OFFSET of the joint {}, wanted one", in_quotes(name())));
    for (Eigen::Index i = 0; i < 3; ++i) {
      const std::string_view word = text_.next();
      const auto number = number_of_length(text_, word);
      if (!number) return tl::unexpected(number.error());
      found_.joints[open_.back().joint].rest.translation[i] = *number;
      found_.written[open_.back().joint].offset.append(i == 0 ? "" : " ").append(word);
    }
    return {};
  }

  Expected<void> channels() {
    Open& joint = open_.back();
    if (std::exchange(joint.has_channels, true))
      return text_.fault(formatted("found a second CHANNELS of the joint {}, wanted one", in_quotes(name())));
    if (joint.has_children)
      return text_.fault(
          formatted("found CHANNELS of the joint {} behind its children, wanted them before", in_quotes(name())));
    const auto stated = whole_number(text_, text_.next(), formatted("a number of channels from 0 to {}", most_columns));
    if (!stated) return tl::unexpected(stated.error());
    std::vector<Column>& columns = found_.written[joint.joint].columns;
    for (; !ends_columns(text_.peek());) {
      const std::string_view word = text_.next();
      const auto column = column_of(word);
      if (!column) return text_.refused(word, "a channel such as Xposition or Zrotation");
      if (column->kind == Column::Kind::position && std::ranges::find(columns, *column) != columns.end())
        return text_.fault(
            formatted("found a second {} of the joint {}, wanted one", in_quotes(word), in_quotes(name())));
      columns.push_back(*column);
    }
    if (columns.size() != *stated)
      return text_.fault(formatted("found {} channels after CHANNELS {}, wanted {}", columns.size(), *stated, *stated));
    if (columns.size() > most_columns)
      return text_.fault(formatted("found {} channels, wanted at most {}", columns.size(), most_columns));
    return {};
  }

  [[nodiscard]] const std::string& name() const { return found_.joints[open_.back().joint].name; }

  Text& text_;
  Hierarchy found_;
  std::vector<Open> open_;
};

}  // namespace

Expected<Hierarchy> read_hierarchy(Text& text) { return HierarchyReader(text).read(); }

}}}  // namespace orispline::scenes::bvh
