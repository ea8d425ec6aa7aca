// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/compressed_views.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/key_compression.hpp>
#include <orispline/scenes/gltf/meshopt.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// In the mode ATTRIBUTES: two bits at least say how each sixteen bytes are packed.
constexpr std::size_t most_from_a_byte = 64;
constexpr std::size_t widest_stride = 256;

/// What the extension says of a view, with the name of the view for messages.
struct Compression {
  Object object;
  std::string_view extension;
};

Expected<std::optional<Compression>> compression_of(const Document& document, std::size_t index) {
  const auto view = document.root().entry("bufferViews", "bufferView", index);
  if (!view) return tl::unexpected(view.error());
  const Json* const extensions = view->find("extensions");
  if (extensions == nullptr || !extensions->is_object()) return std::nullopt;
  for (const std::string_view name : meshopt_extensions) {
    const auto found = extensions->find(name);
    if (found == extensions->end()) continue;
    return Object::of(*found, formatted("{} of bufferView {}", name, index)).map([&](Object object) {
      return std::optional(Compression{std::move(object), name});
    });
  }
  return std::nullopt;
}

Expected<CompressedView> compressed_place(const Document& document, const Compression& compression) {
  const Object& object = compression.object;
  const auto buffer = object.index("buffer", document.buffers.size());
  if (!buffer) return tl::unexpected(buffer.error());
  const auto offset = object.count_or("byteOffset", 0), length = object.count("byteLength");
  if (!offset) return tl::unexpected(offset.error());
  if (!length) return tl::unexpected(length.error());
  const BufferPlace& place = document.buffers[*buffer];
  if (!place.has_data)
    return object.fault(formatted("found buffer {}, which has no data, wanted one that has", *buffer));
  if (*offset + *length > place.length)
    return object.fault(formatted("found {} bytes from byte {}, wanted them within the {} bytes of buffer {}", *length,
                                  *offset, place.length, *buffer));
  return CompressedView{compression.extension, place.offset + *offset, *length};
}

Expected<MeshoptFilter> filter_of(const Object& object) {
  return object.text_or("filter", "NONE").and_then([&](const std::string& word) -> Expected<MeshoptFilter> {
    if (word == "NONE") return MeshoptFilter::none;
    if (word == "OCTAHEDRAL") return MeshoptFilter::octahedral;
    if (word == "QUATERNION") return MeshoptFilter::quaternion;
    if (word == "EXPONENTIAL") return MeshoptFilter::exponential;
    return object.fault(
        formatted("found filter {}, wanted NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL", in_quotes(word)));
  });
}

bool fits(const MeshoptElements& elements) {
  switch (elements.filter) {
    case MeshoptFilter::octahedral:
      return elements.stride == 4 || elements.stride == 8;
    case MeshoptFilter::quaternion:
      return elements.stride == 8;
    case MeshoptFilter::none:
    case MeshoptFilter::exponential:
      break;
  }
  return true;
}

/// Of a view of that many bytes.
Expected<MeshoptElements> elements_of(const Object& object, std::size_t bytes) {
  const auto mode = object.text("mode");
  if (!mode) return tl::unexpected(mode.error());
  if (*mode != "ATTRIBUTES")
    return object.fault(formatted("found mode {} for data of animations, wanted ATTRIBUTES", in_quotes(*mode)));
  const auto count = object.count("count"), stride = object.count("byteStride");
  if (!count) return tl::unexpected(count.error());
  if (!stride) return tl::unexpected(stride.error());
  const auto filter = filter_of(object);
  if (!filter) return tl::unexpected(filter.error());
  if (*stride == 0 || *stride % 4 != 0 || *stride > widest_stride)
    return object.fault(formatted("found a byteStride of {}, wanted a multiple of 4 up to {}", *stride, widest_stride));
  const MeshoptElements elements{*count, *stride, *filter};
  if (!fits(elements))
    return object.fault(formatted("found a byteStride of {} for filter {}, wanted {}", *stride,
                                  in_quotes(object.text_or("filter", "").value()),
                                  *filter == MeshoptFilter::quaternion ? "8" : "4 or 8"));
  if (*count * *stride != bytes)
    return object.fault(
        formatted("found {} elements of {} bytes, wanted the {} bytes of the bufferView", *count, *stride, bytes));
  return elements;
}

/// The views of the accessors that the samplers of animations refer to, as far as the document is sound: what is not is
/// found where it is read.
class AnimationViews {
 public:
  explicit AnimationViews(const Document& document) : document_(document) {
    const std::size_t animations = document.root().list("animations").value()->size();
    for (std::size_t i = 0; i < animations; ++i)
      if (const auto animation = animation_of(document, i)) add(*animation);
  }
  [[nodiscard]] const std::set<std::size_t>& all() const { return views_; }

 private:
  void add(const Object& animation) {
    const auto channels = animation_channels(document_, animation);
    if (!channels) return;
    for (const AnimationChannel& channel : *channels) {
      const auto sampler = animation.entry("samplers", "sampler", channel.sampler);
      if (!sampler) continue;
      add_accessor(*sampler, "input");
      if (channel.target) add_accessor(*sampler, "output");
    }
  }
  void add_accessor(const Object& sampler, const char* key) {
    const auto index = sampler.index(key, document_.root().list("accessors").value()->size());
    if (!index) return;
    const auto accessor = document_.root().entry("accessors", "accessor", *index);
    if (!accessor) return;
    add_view(*accessor);
    const auto sparse = accessor->object("sparse");
    if (!sparse) return;
    for (const char* part : {"indices", "values"})
      if (const auto object = sparse->object(part)) add_view(*object);
  }
  void add_view(const Object& object) {
    if (const auto view = object.index("bufferView", document_.views.size())) views_.insert(*view);
  }

  const Document& document_;
  std::set<std::size_t> views_{};
};

/// Decodes views one by one, to the end of the binary.
class Decoding {
 public:
  explicit Decoding(Document document) : document_(std::move(document)) {}

  [[nodiscard]] Expected<void> decode(std::size_t view) {
    if (document_.views[view]) return {};
    const auto compression = compression_of(document_, view);
    if (!compression) return tl::unexpected(compression.error());
    if (!*compression) return {};
    if (!has_meshopt())
      return (*compression)->object.fault(formatted("found compressed animations, but {}", without_meshopt()));
    const auto place = compressed_place(document_, **compression);
    if (!place) return tl::unexpected(place.error());
    const auto length = document_.root().entry("bufferViews", "bufferView", view)->count("byteLength");
    const auto elements = elements_of((*compression)->object, *length);
    if (!elements) return tl::unexpected(elements.error());
    return check_place((*compression)->object, *place, *length).and_then([&] {
      return append((*compression)->object, *place, *elements, view);
    });
  }
  [[nodiscard]] Document document() && { return std::move(document_); }

 private:
  /// Bytes that stand for more than there is room for are not decoded to see that they do not: nor are the same ones
  /// twice.
  [[nodiscard]] Expected<void> check_place(const Object& object, const CompressedView& place, std::size_t length) {
    if (length > place.length * most_from_a_byte)
      return object.fault(formatted("found {} compressed bytes for {}, wanted one for {} at least", place.length,
                                    length, most_from_a_byte));
    const auto next = decoded_.lower_bound(place.offset);
    const bool meets_next = next != decoded_.end() && next->first < place.offset + place.length;
    if (meets_next || (next != decoded_.begin() && std::prev(next)->second > place.offset))
      return object.fault("found data that are those of another bufferView too, wanted some of its own");
    if (document_.binary.size() + length > largest_scene_file)
      return object.fault("found more than 2 GiB of decoded data, wanted less");
    decoded_.emplace(place.offset, place.offset + place.length);
    return {};
  }

  [[nodiscard]] Expected<void> append(const Object& object, const CompressedView& place,
                                      const MeshoptElements& elements, std::size_t view) {
    const std::string_view compressed = std::string_view(document_.binary).substr(place.offset, place.length);
    const auto bytes = from_meshopt(compressed, elements);
    if (!bytes)
      return object.fault(
          "found data that are damaged or of a newer codec, wanted those of version 0; gltf-transform copy IN.glb "
          "OUT.glb decodes a sound file");
    const auto stride = document_.root().entry("bufferViews", "bufferView", view)->count_or("byteStride", 0);
    if (!stride) return tl::unexpected(stride.error());
    document_.binary.resize((document_.binary.size() + 7) / 8 * 8);
    document_.views[view] = View{document_.binary.size(), bytes->size(), *stride};
    document_.binary += *bytes;
    return {};
  }

  Document document_;
  std::map<std::size_t, std::size_t> decoded_{};  ///< where compressed bytes begin and end
};

}  // namespace

bool is_meshopt(std::string_view extension) noexcept {
  return std::ranges::find(meshopt_extensions, extension) != meshopt_extensions.end();
}

Expected<std::optional<CompressedView>> compressed_view(const Document& document, std::size_t view) {
  return compression_of(document, view).and_then([&](const auto& found) -> Expected<std::optional<CompressedView>> {
    if (!found) return std::nullopt;
    return compressed_place(document, *found).map([](const CompressedView& place) { return std::optional(place); });
  });
}

std::string compressing_tool(const Document& document) {
  const auto asset = document.root().object("asset");
  const auto generator = asset ? asset->text_or("generator", "") : Expected<std::string>();
  constexpr std::array tools{std::string_view("gltfpack"), std::string_view("glTF-Transform")};
  for (const std::string_view tool : tools)
    if (generator && generator->starts_with(tool)) return printable(*generator);
  const auto used = document.root().list("extensionsUsed");
  for (const Json& name : used ? **used : Json::array())
    if (const auto* const text = name.get_ptr<const Json::string_t*>(); text != nullptr && is_meshopt(*text))
      return *text;
  return {};
}

Expected<Document> with_animations_decoded(Document document) {
  const std::set<std::size_t> views = AnimationViews(document).all();
  Decoding decoding(std::move(document));
  for (const std::size_t view : views)
    if (auto done = decoding.decode(view); !done) return tl::unexpected(std::move(done.error()));
  return std::move(decoding).document();
}

}}}  // namespace orispline::scenes::gltf
