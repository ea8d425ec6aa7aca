// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/scenes/gltf/json.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// The parts of a file: a GLB has both, a .gltf is all document.
struct Container {
  std::string_view json{};
  std::optional<std::string_view> binary{};
};

/// Views of the bytes, told apart by their first four. Errors (bad_data): a header or a chunk that is not whole.
[[nodiscard]] Expected<Container> container_of(std::string_view bytes);

/// Whether a file of so many bytes that begins so can be a glTF file. Errors (bad_data): as of container_of(); text
/// that cannot be JSON.
[[nodiscard]] Expected<void> check_start(std::string_view start, std::size_t size, const std::string& path);

/// A GLB. Errors (bad_data): more bytes than it can state.
[[nodiscard]] Expected<std::string> glb_of(std::string_view json, std::string_view binary);

/// A stretch of the binary.
struct View {
  std::size_t offset = 0, length = 0;
  std::size_t stride = 0;  ///< from element to element; 0 where they follow each other
};

/// Where a buffer begins in the merged one. One without data is there for an extension to fill.
struct BufferPlace {
  std::size_t offset = 0, length = 0;
  bool has_data = true;
};

/// A document whose buffers are merged into one.
struct Document {
  Json json = Json::object();  ///< an object, whose lists of bufferViews, accessors, nodes and animations are lists
  std::string binary{};
  std::size_t bytes_beside = 0;  ///< of the files that buffers were in
  std::vector<BufferPlace> buffers{};
  std::vector<std::optional<View>> views{};  ///< each within the binary; none where the buffer has no data

  [[nodiscard]] Object root() const { return Object::of(json, "").value(); }
};

/// Reads the document of a file with its buffers, also those in files beside it.
///
/// Errors: bad_data; bad_access for a file beside it.
[[nodiscard]] Expected<Document> document_of(std::string_view bytes, const io::Input& from);

/// Required extensions that are not known to leave nodes, animations and buffers alone. Errors (bad_data): one that is
/// known not to.
[[nodiscard]] Expected<std::vector<Warning>> extension_warnings(const Document& document);

/// The nodes of a document as joints.
struct Nodes {
  Skeleton skeleton{};
  std::vector<std::size_t> node_of_joint{}, joint_of_node{};
};

/// Errors (bad_data): nodes in a circle or of two parents; a pose that is no translation, rotation and scale.
[[nodiscard]] Expected<Nodes> nodes_of(const Document& document);

/// A node with a pose in parts, without those that say nothing.
[[nodiscard]] Json with_pose(Json node, const JointPose& pose);

/// What is wrong with the norm of a quaternion of a file, where values are rounded to a few digits; empty if nothing
/// is.
[[nodiscard]] std::string norm_fault(double norm);

/// All that the file of a scene holds, with the node of each joint.
class Source final : public SceneSource {
 public:
  Source(Document document, Nodes nodes, SceneReading reading)
      : document_(std::move(document)), nodes_(std::move(nodes)), reading_(reading) {}

  [[nodiscard]] const Document& document() const noexcept { return document_; }
  [[nodiscard]] const Nodes& nodes() const noexcept { return nodes_; }
  [[nodiscard]] const SceneReading& reading() const noexcept { return reading_; }

 private:
  Document document_;
  Nodes nodes_;
  SceneReading reading_;
};

/// The file with one node more, above one without a parent, where that is what a skeleton has more than the source's:
/// its first joint. Nothing where it differs otherwise.
[[nodiscard]] std::optional<Source> with_new_root(const Source& source, const Skeleton& skeleton);

/// A document without animations for a skeleton that no glTF file had, one node per joint.
[[nodiscard]] Source made_source(const Skeleton& skeleton, const SceneWriting& writing);

enum class ComponentType { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

/// Elements that replace those of an accessor.
struct Sparse {
  std::size_t count = 0, indices = 0, values = 0;  ///< `indices` and `values` begin there in the binary
  ComponentType index_type = ComponentType::u32;

  friend auto operator<=>(const Sparse&, const Sparse&) = default;
};

/// Where the elements of an accessor lie. What one that accessor_of() gives refers to is within the binary.
struct Accessor {
  std::size_t count = 0, components = 1;
  ComponentType type = ComponentType::f32;
  bool is_normalised = false;
  bool is_strided = false;              ///< whether its view states a stride
  std::optional<std::size_t> offset{};  ///< of its first element in the binary; none where all are zero
  std::size_t element_size = 0, stride = 0;
  std::optional<Sparse> sparse{};

  [[nodiscard]] std::size_t extent() const noexcept { return count == 0 ? 0 : stride * (count - 1) + element_size; }
  friend auto operator<=>(const Accessor&, const Accessor&) = default;
};

/// Checked against its views. Errors (bad_data) name the accessor.
[[nodiscard]] Expected<Accessor> accessor_of(const Document& document, std::size_t index);

/// All components of all elements: integers as they are or, where they are normalised, within [-1, 1].
///
/// Errors (bad_data): the indices of sparse elements do not rise or are too large.
[[nodiscard]] Expected<std::vector<double>> values_of(const Document& document, const Accessor& accessor);

/// That of one element. Precondition: the accessor has an offset, and no sparse elements.
[[nodiscard]] double first_component(const Document& document, const Accessor& accessor, std::size_t element);

/// Where a sampler finds its keys.
struct SamplerPlaces {
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  Accessor input{}, output{};

  friend auto operator<=>(const SamplerPlaces&, const SamplerPlaces&) = default;
};

/// What the sampler of an animation holds: per key a value, of splines a tangent, a value and a tangent.
struct SamplerKeys {
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  std::vector<double> times{};
  std::vector<double> outputs{};

  [[nodiscard]] std::size_t size() const noexcept { return times.size(); }
};

/// How many numbers one value has, with the word of glTF.
struct ValueType {
  std::string_view word;
  std::size_t components;
};
inline constexpr ValueType quaternion_type{"VEC4", 4}, vector_type{"VEC3", 3};

/// Errors (bad_data): accessors that do not fit each other or the type.
[[nodiscard]] Expected<SamplerPlaces> sampler_places(const Document& document, const Object& sampler,
                                                     const ValueType& type);

/// The keys there. Errors (bad_data): times that do not rise.
[[nodiscard]] Expected<SamplerKeys> sampler_keys(const Document& document, const SamplerPlaces& places,
                                                 const SceneReading& reading);

/// From the first time of a sampler to the last, as far as that can be told without reading all [s].
[[nodiscard]] std::optional<Domain> sampler_domain(const Document& document, const Object& sampler);

enum class Norm { one, as_in_file };

/// The channel; rotations are normalised, with their tangents in proportion, unless they are to be as in the file.
///
/// Errors (bad_data): a number that is not finite, a quaternion far from norm 1.
template <CurvePoint P>
[[nodiscard]] Expected<Channel<P>> channel_of(const SamplerKeys& keys, std::size_t joint, Norm norm = Norm::one);

/// What a channel of ours moves, by the words of glTF.
enum class Property { rotation, translation, scale };
[[nodiscard]] std::string_view word_of(Property property) noexcept;
/// Of that word; absent for what is not ours, such as weights.
[[nodiscard]] std::optional<Property> property_of(std::string_view word) noexcept;

/// A node that is animated must not have a matrix, for then nothing says what of it moves.
void take_matrices_apart(Json& json, const Nodes& nodes);

/// A channel of an animation. One that moves something else, such as weights, has no target here and is passed on.
struct ChannelTarget {
  std::size_t node = 0;
  Property property = Property::rotation;
};
struct AnimationChannel {
  std::size_t sampler = 0;
  std::optional<ChannelTarget> target{};
  std::optional<std::size_t> weights_of{};  ///< the node whose morph targets it weighs; it has no target then
};

/// The object of an animation; it was read before, or its errors are bad_data.
[[nodiscard]] Expected<Object> animation_of(const Document& document, std::size_t animation);
/// `animation 3` where it has no name.
[[nodiscard]] Expected<std::string> animation_name(const Object& animation, std::size_t index);
[[nodiscard]] Expected<std::vector<AnimationChannel>> animation_channels(const Document& document,
                                                                         const Object& animation);

/// Reads the animations of a document one by one. Channels with the same keys of the file share them in memory.
class AnimationReader {
 public:
  AnimationReader(const Document& document, const Nodes& nodes, const SceneReading& reading)
      : document_(document),
        nodes_(nodes),
        reading_(reading),
        most_stored_(most_keys_of_nothing + document.binary.size()),
        stored_left_(most_stored_) {}

  /// Errors (bad_data) name the clip, and the joint and the key where there are any.
  [[nodiscard]] Expected<Clip> next();

  /// Of the animations that were read.
  [[nodiscard]] std::vector<Warning> warnings() const;
  /// Whether values of these are stored as integers.
  [[nodiscard]] bool found_integers() const noexcept { return found_integers_; }

 private:
  template <CurvePoint P>
  using KnownChannels = std::map<SamplerPlaces, Channel<P>>;

  [[nodiscard]] Expected<Clip> with(Clip clip, const Object& sampler, const ChannelTarget& target);
  [[nodiscard]] bool took_weights(Clip& clip, const Object& sampler, std::size_t node);
  template <CurvePoint P>
  [[nodiscard]] Expected<Channel<P>> channel(const Object& sampler, std::size_t joint, KnownChannels<P>& known);
  template <CurvePoint P>
  [[nodiscard]] Expected<Channel<P>> read(const SamplerPlaces& places);
  void note_strides(const Object& sampler, const SamplerPlaces& places);

  /// What takes no bytes of a file, such as zeros, and parts that overlap must not fill the memory.
  static constexpr std::size_t most_keys_of_nothing = std::size_t{1} << 22;

  const Document& document_;
  const Nodes& nodes_;
  const SceneReading& reading_;
  std::size_t animation_ = 0;
  std::size_t keys_left_ = std::size_t{1} << 26;  ///< of all channels, for what is done with each of them
  std::size_t most_stored_, stored_left_;         ///< of channels that share no keys with others
  KnownChannels<Eigen::Quaterniond> rotations_{};
  KnownChannels<Eigen::Vector3d> vectors_{};
  std::map<Accessor, SharedList<double>> times_{};
  std::vector<std::string> strided_{};
  bool found_integers_ = false;
};

}}}  // namespace orispline::scenes::gltf
