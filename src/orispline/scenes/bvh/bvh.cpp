// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/bvh/source.hpp>
#include <orispline/scenes/bvh/text.hpp>
#include <orispline/scenes/bvh/writer.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr std::array<std::string_view, 1> file_extensions{".bvh"};

/// The joints of a file, in its order.
struct Hierarchy {
  std::vector<Joint> joints{};
  std::vector<WrittenJoint> written{};  ///< one per joint
  std::vector<std::size_t> lines{};     ///< where each begins
};

constexpr std::string_view first_word = "HIERARCHY";
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
    if (const auto word = text_.next(); !is_word(word, first_word)) return text_.refused(word, first_word);
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
    std::string unicode = text_of_unicode(name);
    if (printable(unicode) != unicode)
      return text_.fault(
          formatted("found the name {} with a control character, wanted a name without", in_quotes(unicode)));
    return open(std::move(unicode), {});
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

/// Reads up to the word MOTION, and that. Errors (bad_data) name the line.
Expected<Hierarchy> read_hierarchy(Text& text) { return HierarchyReader(text).read(); }

/// The frames of a file.
struct Motion {
  Decimal frame_time{};
  std::size_t frames = 0;
  std::vector<double> numbers{};
  std::vector<Warning> warnings{};
};

std::string_view stem_of(std::string_view path) {
  const std::string_view name = file_name_of(path);
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos || dot == 0 ? name : name.substr(0, dot);
}

std::vector<Column> columns_in_order(std::span<const WrittenJoint> joints) {
  std::vector<Column> columns;
  for (const WrittenJoint& joint : joints) columns.insert(columns.end(), joint.columns.begin(), joint.columns.end());
  return columns;
}

Expected<Decimal> read_frame_time(Text& text) {
  if (auto found = text.label("Frame", "Time"); !found) return tl::unexpected(std::move(found.error()));
  const std::string_view word = text.next();
  const auto time = Decimal::parse(word);
  if (!time) return text.fault(time.error().message);
  if (*time <= Decimal()) return text.refused(word, "a frame time above 0");
  return *time;
}

/// Reads frames, each of which is a line. Lines may have more numbers than there are channels if all have as many.
class FrameReader {
 public:
  /// `salvage`: of a file that was cut off the whole frames are enough.
  FrameReader(Text& text, std::span<const Column> columns, bool salvage)
      : text_(text), columns_(columns), salvage_(salvage) {}

  /// The numbers of the channels in `frames` frames, as many as line `line_of_frames` states, or in fewer.
  Expected<std::vector<double>> read(std::size_t frames, std::size_t line_of_frames) {
    // By what there is, not by what the file states: a number and its blank take two bytes.
    const std::size_t room = text_.bytes_left() / 2 + 1;
    numbers_.reserve(frames < room / columns_.size() ? frames * columns_.size() : room);
    for (std::size_t frame = 0; frame < frames; ++frame) {
      const auto found = text_.peek().empty() ? 0 : read_line();
      if (!found) return tl::unexpected(found.error());
      if (is_cut_off(*found, frame + 1 < frames)) {
        static_cast<void>(text_.next());  // the end of the file is what is wrong
        if (frame > 0 && salvage_) return first(frame);
        auto fault = text_.fault(formatted("found {}, wanted {}, the number in line {}", counted(frame, "whole frame"),
                                           frames, line_of_frames));
        if (frame > 0) fault.value().remedy = "salvage";
        return fault;
      }
      if (frame == 0) line_of_first_ = text_.line(), in_line_ = *found;
      if (*found != in_line_ || !fits(*found)) return wrong_count(*found);
    }
    return std::move(numbers_);
  }

  /// Of numbers that no channel takes.
  [[nodiscard]] std::vector<Warning> warnings(const std::string& path) const {
    const std::size_t surplus = in_line_ - columns_.size();
    if (surplus == 0) return {};
    return {
        {.code = "numbers_left_out",
         .message = formatted("found {} numbers in every frame, read the first {}, one for each channel", in_line_,
                              columns_.size()),
         .where = {.file = path, .line = line_of_first_},
         .numbers = {{"found", static_cast<double>(in_line_)}, {"channels", static_cast<double>(columns_.size())}}}};
  }

 private:
  /// Whether the file ends within a number, such as `1e-`.
  [[nodiscard]] bool is_begun(std::string_view word) const {
    return text_.bytes_left() == 0 && word.find_first_not_of("+-.0123456789eE") == std::string_view::npos &&
           std::string_view("+-.eE").find(word.back()) != std::string_view::npos;
  }

  /// How many numbers there are in the line.
  Expected<std::size_t> read_line() {
    std::size_t count = 0;
    do {
      const std::string_view word = text_.next();
      const bool is_angle = count < columns_.size() && columns_[count].kind == Column::Kind::rotation;
      const auto number = is_angle ? number_of_degrees(text_, word) : number_of_length(text_, word);
      if (!number && is_begun(word)) return count;
      if (!number) return tl::unexpected(number.error());
      if (count++ < columns_.size()) numbers_.push_back(*number);
    } while (text_.goes_on_in_line());
    return count;
  }

  /// Whether the file ends within a frame of `found` numbers. Where more frames are stated, a line without an end may
  /// have lost digits of its last number.
  [[nodiscard]] bool is_cut_off(std::size_t found, bool has_more) const {
    return found < columns_.size() ? text_.peek().empty() : has_more && text_.bytes_left() == 0;
  }

  /// The numbers of so many frames, the last ones that are left being those of a frame that was cut off.
  [[nodiscard]] std::vector<double> first(std::size_t frames) {
    numbers_.resize(frames * columns_.size());
    return std::move(numbers_);
  }

  /// A line of twice as many numbers has two frames, and is no frame with a surplus.
  [[nodiscard]] bool fits(std::size_t count) const { return count >= columns_.size() && count < 2 * columns_.size(); }

  [[nodiscard]] tl::unexpected<Error> wrong_count(std::size_t found) const {
    const std::string before = in_line_ == columns_.size() || !fits(in_line_)
                                   ? ""
                                   : formatted(", or {} as in line {}", in_line_, line_of_first_);
    return text_.fault(formatted("found {} in the line, wanted a frame of {}, one for each channel{}",
                                 counted(found, "number"), columns_.size(), before));
  }

  Text& text_;
  std::span<const Column> columns_;
  bool salvage_;
  std::vector<double> numbers_{};
  std::size_t in_line_ = 0, line_of_first_ = 0;  ///< of the first frame
};

/// Of lines after the frames that the file states.
Expected<std::vector<Warning>> read_rest(Text& text, const Motion& motion, const std::string& path) {
  std::size_t more = 0, line = 0;
  for (std::string_view word = text.next(); !word.empty(); word = text.next(), ++more) {
    if (more == 0) {
      line = text.line();
      if (const auto number = number_of_length(text, word); !number) return tl::unexpected(number.error());
    }
    static_cast<void>(text.rest_of_line());
  }
  if (more == 0) return std::vector<Warning>{};
  const std::size_t frames = motion.frames + more;
  return std::vector{
      Warning{.code = "frames_left_out",
              .message = formatted("found {} frames, read the {} that the file states", frames, motion.frames),
              .where = {.file = path, .line = line},
              .numbers = {{"frames", static_cast<double>(frames)}, {"stated", static_cast<double>(motion.frames)}}}};
}

/// Of a file that was cut off.
Warning warning_of_missing(std::size_t stated, std::size_t found, const Text& text, const std::string& path) {
  return {
      .code = "frames_missing",
      .message = formatted("found {} of the {} that the file states, read them", counted(found, "whole frame"), stated),
      .where = {.file = path, .line = text.line()},
      .numbers = {{"frames", static_cast<double>(found)}, {"stated", static_cast<double>(stated)}}};
}

Expected<Motion> read_motion(Text& text, std::span<const WrittenJoint> joints, const std::string& path, bool salvage) {
  const std::vector<Column> columns = columns_in_order(joints);
  if (columns.empty()) return text.fault("found no channels, wanted one at least");
  if (auto found = text.label("Frames"); !found) return tl::unexpected(std::move(found.error()));
  const auto frames = whole_number(text, text.next(), "a number of frames");
  if (!frames) return tl::unexpected(frames.error());
  if (*frames == 0) return text.fault("found 0 frames, wanted one at least");
  if (*frames > most_numbers / columns.size())
    return text.fault(formatted("found {} frames of {}, wanted {} numbers at most in all", *frames,
                                counted(columns.size(), "channel"), most_numbers));
  const std::size_t line = text.line();
  auto frame_time = read_frame_time(text);
  if (!frame_time) return tl::unexpected(std::move(frame_time.error()));
  FrameReader reader(text, columns, salvage);
  auto numbers = reader.read(*frames, line);
  if (!numbers) return tl::unexpected(std::move(numbers.error()));
  Motion motion{*frame_time, numbers->size() / columns.size(), std::move(*numbers), reader.warnings(path)};
  if (motion.frames < *frames) {
    motion.warnings.push_back(warning_of_missing(*frames, motion.frames, text, path));
    return motion;
  }
  auto rest = read_rest(text, motion, path);
  if (!rest) return tl::unexpected(std::move(rest.error()));
  std::ranges::move(*rest, std::back_inserter(motion.warnings));
  return motion;
}

std::vector<double> times_of(const Decimal& frame_time, std::size_t frames) {
  std::vector<double> times(frames);
  for (std::size_t k = 0; k < frames; ++k)
    times[k] = (frame_time * Decimal::from_double(static_cast<double>(k))).to_double();
  return times;
}

/// The quaternions of a joint, each with the sign that is nearer to the one before.
std::vector<Eigen::Quaterniond> rotations_of(std::span<const Column> columns, const double* numbers, std::size_t frames,
                                             std::size_t stride) {
  std::vector<Eigen::Quaterniond> rotations(frames);
  for (std::size_t k = 0; k < frames; ++k) {
    Eigen::Quaterniond q = rotation_of(columns, numbers + k * stride);
    if (k > 0 && q.dot(rotations[k - 1]) < 0.0) q.coeffs() = -q.coeffs();
    rotations[k] = q;
  }
  return rotations;
}

Clip clip_of(const Source& source, std::string name) {
  Clip clip{.name = std::move(name)};
  const SharedList<double> times = times_of(source.frame_time, source.frames);
  const std::size_t stride = columns_of(source.joints);
  const double* numbers = source.numbers.data();
  for (std::size_t j = 0; j < source.joints.size(); ++j) {
    const std::vector<Column>& columns = source.joints[j].columns;
    if (count_of(columns, Column::Kind::rotation) > 0)
      clip.rotations.push_back(
          {.joint = j, .times = times, .values = rotations_of(columns, numbers, source.frames, stride)});
    if (count_of(columns, Column::Kind::position) > 0) {
      VectorChannel channel{.joint = j, .times = times, .values = std::vector<Eigen::Vector3d>(source.frames)};
      for (std::size_t k = 0; k < source.frames; ++k)
        channel.values[k] = translation_of(columns, numbers + k * stride, source.skeleton[j].rest.translation);
      clip.translations.push_back(std::move(channel));
    }
    numbers += columns.size();
  }
  return clip;
}

/// The skeleton with the pose of a frame as its rest pose. Error (bad_argument): there is no such frame.
Expected<Skeleton> resting_as_in_frame(const Skeleton& skeleton, const Clip& clip, std::size_t frame,
                                       std::size_t frames) {
  if (frame >= frames)
    return bad_option("rest_frame", formatted("found {}, wanted a frame of the file, from 0 to {}", frame, frames - 1));
  std::vector<Joint> joints(skeleton.joints().begin(), skeleton.joints().end());
  for (const RotationChannel& channel : clip.rotations) joints[channel.joint].rest.rotation = channel.values[frame];
  for (const VectorChannel& channel : clip.translations) joints[channel.joint].rest.translation = channel.values[frame];
  return Skeleton::make(std::move(joints));
}

/// Where several joints have one name.
std::vector<Warning> warnings_of_names(const Hierarchy& hierarchy, const std::string& path) {
  std::unordered_set<std::string_view> names;
  std::size_t repeated = 0, first = 0;
  for (std::size_t j = 0; j < hierarchy.joints.size(); ++j)
    if (!names.insert(hierarchy.joints[j].name).second && repeated++ == 0) first = j;
  if (repeated == 0) return {};
  return {Warning{.code = "duplicate_names",
                  .message = formatted("found {} with the name of an earlier one, the first being {}",
                                       counted(repeated, "joint"), in_quotes(hierarchy.joints[first].name)),
                  .where = {.file = path, .line = hierarchy.lines[first]},
                  .numbers = {{"joints", static_cast<double>(repeated)}}}};
}

}  // namespace

/// The first word, or as much of it as the beginning has. Errors (bad_data) name the file and the line.
Expected<void> check_start(std::string_view start, std::size_t size, const std::string& path) {
  Text text(start, path);
  const std::string_view word = text.next();
  const bool goes_on = text.bytes_left() == 0 && start.size() < size;
  if (is_word(word, goes_on ? first_word.substr(0, word.size()) : first_word)) return {};
  return text.refused(word, first_word);
}

/// A skeleton with one clip, named by the file, and a `Source`. Errors (bad_data) name the file and the line.
Expected<Scene> read(std::string_view bytes, const io::Input& from, const SceneReading& reading) {
  const std::string& path = from.name();
  Text text(bytes, path);
  auto hierarchy = read_hierarchy(text);
  if (!hierarchy) return tl::unexpected(std::move(hierarchy.error()));
  const std::string_view before_motion = text.before();
  auto motion = read_motion(text, hierarchy->written, path, reading.salvage);
  if (!motion) return tl::unexpected(std::move(motion.error()));
  Scene scene{.warnings = warnings_of_names(*hierarchy, path)};
  scene.warnings.insert(scene.warnings.end(), motion->warnings.begin(), motion->warnings.end());
  auto skeleton = Skeleton::make(std::move(hierarchy->joints));
  if (!skeleton) return tl::unexpected(std::move(skeleton.error()));
  auto source = std::make_shared<Source>();
  source->hierarchy = before_motion;
  source->skeleton = *skeleton;
  source->joints = std::move(hierarchy->written);
  source->frame_time = motion->frame_time;
  source->frames = motion->frames;
  source->numbers = std::move(motion->numbers);
  scene.skeleton = std::move(*skeleton);
  scene.clips.push_back(clip_of(*source, std::string(stem_of(path))));
  scene.source = std::move(source);
  if (!reading.rest_frame) return scene;
  return resting_as_in_frame(scene.skeleton, scene.clips.front(), *reading.rest_frame, motion->frames)
      .map([&](Skeleton resting) {
        scene.skeleton = std::move(resting);
        return std::move(scene);
      });
}

}}}  // namespace orispline::scenes::bvh

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

constinit const SceneFormat bvh_format{{.title = "BVH", .file = "a BVH file", .has_no_unit = true, .is_sampled = true},
                                       "bvh",
                                       "motion capture as a hierarchy and a table of angles",
                                       bvh::file_extensions,
                                       bvh::check_start,
                                       bvh::read,
                                       bvh::write};

}}}  // namespace orispline::scenes
