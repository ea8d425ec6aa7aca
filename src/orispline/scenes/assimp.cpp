// SPDX-License-Identifier: Apache-2.0
// FBX and Collada, read through assimp (ORISPLINE_ASSIMP). Its numbers are floats.
#include <orispline/scenes/assimp.hpp>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <assimp/config.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

namespace { namespace guest {

constexpr std::array<std::string_view, 1> fbx_extensions{".fbx"}, collada_extensions{".dae"};
constexpr std::size_t most_joints = 1'000'000;

Eigen::Vector3d vector_of(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Eigen::Quaterniond quaternion_of(const aiQuaternion& q) { return {q.w, q.x, q.y, q.z}; }

/// A pose in parts. Error (bad_data): a matrix that is none, as one that shears.
Expected<JointPose> pose_of(const aiNode& node) {
  aiVector3D scale, translation;
  aiQuaternion rotation;
  node.mTransformation.Decompose(scale, rotation, translation);
  const JointPose pose{vector_of(translation), quaternion_of(rotation).normalized(), vector_of(scale)};
  const Eigen::Matrix3d made = pose.rotation.toRotationMatrix() * pose.scale.asDiagonal();
  double error = 0.0, size = 0.0;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned k = 0; k < 3; ++k) {
      const double found = node.mTransformation[i][k];
      error = std::max(error, std::abs(found - made(i, k)));
      size = std::max(size, std::abs(found));
    }
  constexpr double rounding = 1e-4;  // of floats, after several products
  if (error <= rounding * size) return pose;
  return failure(ErrorCode::bad_data,
                 formatted("joint {}: found a matrix that shears, wanted translation, rotation and scale",
                           in_quotes(node.mName.C_Str())));
}

/// The nodes of a file as joints, and which is which by name.
struct Tree {
  std::vector<Joint> joints{};
  std::map<std::string, std::size_t, std::less<>> places{};
};

Expected<Tree> tree_of(const aiNode* root) {
  Tree tree;
  std::vector<std::pair<const aiNode*, std::size_t>> open{{root, no_parent}};
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    if (tree.joints.size() == most_joints)
      return failure(ErrorCode::bad_data, formatted("found more than {} nodes, wanted fewer", most_joints));
    auto pose = pose_of(*node);
    if (!pose) return tl::unexpected(std::move(pose.error()));
    const std::string name = node->mName.C_Str();
    tree.places.emplace(name, tree.joints.size());
    for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], tree.joints.size());
    tree.joints.push_back({.name = name, .parent = parent, .rest = *pose});
  }
  return tree;
}

/// What keys of one kind become in a channel.
Eigen::Vector3d value_of_key(const aiVectorKey& key) { return vector_of(key.mValue); }
Eigen::Quaterniond value_of_key(const aiQuatKey& key) { return quaternion_of(key.mValue).normalized(); }

/// How the keys of an animation are read.
struct Clock {
  double ticks_per_second;
  const SceneReading& reading;
};

template <CurvePoint P, class Key>
Expected<Channel<P>> channel_of(std::size_t joint, std::span<const Key> keys, const Clock& clock) {
  Channel<P> channel{.joint = joint};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double time = keys[i].mTime / clock.ticks_per_second;
    const bool is_twice = !channel.times.empty() && time == channel.times.back();
    if (is_twice && clock.reading.drop_duplicates) continue;
    if (is_twice)
      return mended_by("drop_duplicates",
                       formatted("key {}: found time {} after {}, wanted increasing times", i, time, time));
    channel.times.push_back(time);
    channel.values.push_back(value_of_key(keys[i]));
  }
  return channel;
}

/// Adds the keys of one kind of a joint to a list of channels, if there are any.
template <CurvePoint P, class Key>
Expected<std::vector<Channel<P>>> with_channel(std::vector<Channel<P>> channels, std::size_t joint,
                                               std::span<const Key> keys, const Clock& clock) {
  if (keys.empty()) return channels;
  return channel_of<P, Key>(joint, keys, clock).map([&](Channel<P> channel) {
    channels.push_back(std::move(channel));
    return std::move(channels);
  });
}

Expected<Clip> with_channels(Clip clip, std::size_t joint, const aiNodeAnim& found, const Clock& clock) {
  auto rotations = with_channel<Eigen::Quaterniond, aiQuatKey>(std::move(clip.rotations), joint,
                                                               {found.mRotationKeys, found.mNumRotationKeys}, clock);
  if (!rotations) return tl::unexpected(std::move(rotations.error()));
  auto translations = with_channel<Eigen::Vector3d, aiVectorKey>(std::move(clip.translations), joint,
                                                                 {found.mPositionKeys, found.mNumPositionKeys}, clock);
  if (!translations) return tl::unexpected(std::move(translations.error()));
  auto scales = with_channel<Eigen::Vector3d, aiVectorKey>(std::move(clip.scales), joint,
                                                           {found.mScalingKeys, found.mNumScalingKeys}, clock);
  if (!scales) return tl::unexpected(std::move(scales.error()));
  clip.rotations = *std::move(rotations);
  clip.translations = *std::move(translations);
  clip.scales = *std::move(scales);
  return clip;
}

Expected<Clip> clip_of(const aiAnimation& animation, std::size_t index, const Tree& tree, const SceneReading& reading) {
  Clip clip{.name = animation.mName.length > 0 ? animation.mName.C_Str() : formatted("animation {}", index)};
  const Clock clock{animation.mTicksPerSecond > 0.0 ? animation.mTicksPerSecond : 1.0, reading};
  for (const aiNodeAnim* channel : std::span(animation.mChannels, animation.mNumChannels)) {
    const auto place = tree.places.find(std::string_view(channel->mNodeName.C_Str()));
    if (place == tree.places.end()) continue;  // such as the target of a camera
    const std::string name = clip.name;
    auto more = with_channels(std::move(clip), place->second, *channel, clock);
    if (!more) {
      more.error().message =
          formatted("clip {}, joint {}: {}", in_quotes(name), in_quotes(place->first), more.error().message);
      return more;
    }
    clip = *std::move(more);
  }
  return clip;
}

Expected<Scene> read(std::string_view bytes, const io::Input& from, const SceneReading& reading) {
  const std::string& path = from.name();
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  const std::string hint = path.substr(path.rfind('.') + 1);
  const aiScene* const found = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, hint.c_str());
  if (!found || !found->mRootNode)
    return failure(ErrorCode::bad_data,
                   formatted("found what assimp cannot read: {}", printable(importer.GetErrorString())),
                   {.file = path});
  auto tree = tree_of(found->mRootNode);
  if (!tree) return tl::unexpected(std::move(tree.error()));
  Scene scene;
  for (unsigned i = 0; i < found->mNumAnimations; ++i) {
    auto clip = clip_of(*found->mAnimations[i], i, *tree, reading);
    if (!clip) return tl::unexpected(std::move(clip.error()));
    scene.clips.push_back(*std::move(clip));
  }
  return Skeleton::make(std::move(tree->joints)).map([&](Skeleton skeleton) {
    scene.skeleton = std::move(skeleton);
    return std::move(scene);
  });
}

constinit const SceneFormat fbx{
    {.title = "FBX", .file = "an FBX file"}, "fbx", "scenes of Autodesk's programs", fbx_extensions, nullptr, read};
constinit const SceneFormat collada{
    {.title = "Collada", .file = "a Collada file"}, "collada", "scenes as XML", collada_extensions, nullptr, read};
constexpr std::array formats{&fbx, &collada};

}  // namespace guest

}  // namespace

std::span<const SceneFormat* const> assimp_formats() noexcept { return guest::formats; }

}}}  // namespace orispline::scenes
