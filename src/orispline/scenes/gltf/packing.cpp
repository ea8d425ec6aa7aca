// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/packing.hpp>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/scenes/gltf/compressed_keys.hpp>
#include <orispline/scenes/gltf/compressed_views.hpp>
#include <orispline/scenes/gltf/document.hpp>
#include <orispline/scenes/gltf/integers.hpp>
#include <orispline/scenes/gltf/meshopt.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// Nothing for what is no number of an entry of a list.
std::optional<std::size_t> entry_of(const Json& value, std::size_t size) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  if (!(number >= 0.0 && number < static_cast<double>(size))) return std::nullopt;
  return static_cast<std::size_t>(number);
}

/// Walks a document and marks what it refers to, also by the words of the specification within extensions.
class Marks {
 public:
  Marks(std::size_t accessors, std::size_t views) : accessors_(accessors), views_(views) {}

  void walk(const Json& value) {
    if (value.is_array())
      for (const Json& entry : value) walk(entry);
    if (!value.is_object()) return;
    for (auto member = value.begin(); member != value.end(); ++member) {
      mark_by(member.key(), *member);
      walk(*member);
    }
  }

  void mark_accessor(const Json& value) {
    if (const auto entry = entry_of(value, accessors_.size())) accessors_[*entry] = true;
  }

  [[nodiscard]] bool has_accessor(std::size_t accessor) const { return accessors_[accessor]; }
  [[nodiscard]] bool has_view(std::size_t view) const { return views_[view]; }

 private:
  void mark_by(std::string_view key, const Json& value) {
    if (key == "bufferView") {
      if (const auto entry = entry_of(value, views_.size())) views_[*entry] = true;
    } else if (key == "indices" || key == "inverseBindMatrices") {
      mark_accessor(value);
    } else if (key == "attributes") {
      mark_members(value);
    } else if (key == "targets" && value.is_array()) {
      for (const Json& target : value) mark_members(target);
    }
  }

  void mark_members(const Json& value) {
    if (value.is_object())
      for (const Json& member : value) mark_accessor(member);
  }

  std::vector<bool> accessors_, views_;
};

/// The accessors that samplers refer to, kept ones or those that go.
class SamplerAccessors {
 public:
  explicit SamplerAccessors(const Json& animations) : animations_(animations) {}

  [[nodiscard]] Marks marked(Marks marks, const KeptSamplers& chosen) const {
    for (std::size_t a = 0; a < animations_.size(); ++a) {
      const auto samplers = animations_[a].find("samplers");
      if (samplers == animations_[a].end() || !samplers->is_array()) continue;
      for (std::size_t s = 0; s < samplers->size(); ++s) {
        if (!chosen.empty() && !chosen[a][s]) continue;
        for (const char* key : {"input", "output"})
          if (const Json& sampler = (*samplers)[s]; sampler.is_object() && sampler.contains(key))
            marks.mark_accessor(sampler[key]);
      }
    }
    return marks;
  }

 private:
  const Json& animations_;
};

/// Marks what the accessors that stay refer to beside their own view, and notes each in that one.
std::vector<ViewUse> view_uses(const Document& document, const std::vector<bool>& goes, Marks marks) {
  const std::size_t count = document.views.size();
  std::vector<ViewUse> uses(count);
  const Json& accessors = *document.root().list("accessors").value();
  std::vector<bool> holds_what_goes(count);
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    if (!accessors[i].is_object()) continue;
    for (auto member = accessors[i].begin(); member != accessors[i].end(); ++member)
      if (!goes[i]) marks.walk(*member);
    const auto view = accessors[i].find("bufferView");
    const auto entry = view == accessors[i].end() ? std::nullopt : entry_of(*view, count);
    if (entry && goes[i]) holds_what_goes[*entry] = true;
    if (entry && !goes[i]) uses[*entry].accessors.push_back(i);
    const auto sparse = accessors[i].find("sparse");
    if (!goes[i] || sparse == accessors[i].end() || !sparse->is_object()) continue;
    for (const Json& part : *sparse)
      if (part.is_object() && part.contains("bufferView"))
        if (const auto part_view = entry_of(part["bufferView"], count)) holds_what_goes[*part_view] = true;
  }
  for (std::size_t v = 0; v < count; ++v) uses[v].is_whole = marks.has_view(v) || !holds_what_goes[v];
  return uses;
}

/// Bytes of the binary.
struct Stretch {
  std::size_t begin = 0, end = 0;
};

std::vector<Stretch> merged(std::vector<Stretch> stretches) {
  std::ranges::sort(stretches, {}, &Stretch::begin);
  std::vector<Stretch> all;
  for (const Stretch& stretch : stretches)
    if (all.empty() || stretch.begin > all.back().end) all.push_back(stretch);
    else all.back().end = std::max(all.back().end, stretch.end);
  return all;
}

/// Stretches that stay, one behind the other in a new binary, each byte on the boundaries of 8 that it was on.
class Moves {
 public:
  Moves(const std::vector<Stretch>& stretches, std::size_t start) : end_(start) {
    for (const Stretch& stretch : stretches) {
      moved_.push_back({stretch, end_ + (stretch.begin + 8 - end_ % 8) % 8});
      end_ = moved_.back().to + (stretch.end - stretch.begin);
    }
  }

  [[nodiscard]] std::size_t end() const noexcept { return end_; }
  /// Where the byte went that is within one of the stretches, or at its end.
  [[nodiscard]] std::size_t operator()(std::size_t byte) const {
    const auto after = std::ranges::upper_bound(moved_, byte, {}, [](const Move& move) { return move.from.begin; });
    const Move& move = *std::prev(after);
    return move.to + (byte - move.from.begin);
  }
  [[nodiscard]] std::string appended(std::string bytes, std::string_view binary) const {
    for (const Move& move : moved_) {
      bytes.resize(move.to);
      bytes.append(binary.substr(move.from.begin, move.from.end - move.from.begin));
    }
    return bytes;
  }

 private:
  struct Move {
    Stretch from;
    std::size_t to;
  };
  std::vector<Move> moved_{};
  std::size_t end_;
};

bool names_a_buffer(const Json& value) {
  if (value.is_object() && value.contains("buffer")) return true;
  return value.is_structured() && std::ranges::any_of(value, names_a_buffer);
}

/// An extension that is not known here.
bool names_another_buffer(const Json& extensions) {
  if (!extensions.is_object()) return names_a_buffer(extensions);
  for (auto extension = extensions.begin(); extension != extensions.end(); ++extension)
    if (!is_meshopt(extension.key()) && names_a_buffer(*extension)) return true;
  return false;
}

Expected<void> check_views(const Document& document) {
  for (std::size_t i = 0; i < document.views.size(); ++i) {
    const auto view = document.root().entry("bufferViews", "bufferView", i);
    if (!view) return tl::unexpected(view.error());
    const auto compressed = compressed_view(document, i);
    if (!compressed) return tl::unexpected(compressed.error());
    const Json* extensions = view->find("extensions");
    if ((*compressed || document.views[i]) && (extensions == nullptr || !names_another_buffer(*extensions))) continue;
    return view->fault("found data that only an extension can read, wanted an uncompressed bufferView");
  }
  return {};
}

/// A number that is left out where it is 0 and was left out before.
void set_number(Json& object, const char* key, std::size_t number) {
  if (number != 0 || object.contains(key)) object[key] = number;
}

class Packing {
 public:
  Packing(const Document& document, const Uses& uses)
      : document_(document),
        uses_(uses.views),
        lists_{*document.root().list("accessors").value(), *document.root().list("bufferViews").value(), {}} {}

  [[nodiscard]] Expected<Packed> with(const KeyStore& store, const std::vector<std::size_t>& free_accessors,
                                      KeyCompression compression) && {
    keep_whole_views();
    for (std::size_t v = 0; v < uses_.size(); ++v) {
      if (!uses_[v].is_whole && !uses_[v].accessors.empty()) keep_parts_of(v);
      if (lists_.bytes.size() > largest_scene_file) return too_large();
    }
    std::vector<std::size_t> free_views;
    for (std::size_t v = 0; v < uses_.size(); ++v)
      if (!uses_[v].is_whole && uses_[v].accessors.empty()) free_views.push_back(v);
    const std::size_t new_views =
        compression == KeyCompression::meshopt ? add_compressed(store, free_views) : add_new(store, free_views);
    fill_or_drop(lists_.accessors, free_accessors, store.size(), unused_accessor());
    fill_or_drop(lists_.views, free_views, new_views, unused_view());
    if (lists_.views.size() > 0 && lists_.bytes.size() < unused_length) lists_.bytes.resize(unused_length);
    if (lists_.bytes.size() > largest_scene_file) return too_large();
    return std::move(lists_);
  }

 private:
  static tl::unexpected<Error> too_large() {
    return failure(ErrorCode::bad_data, "found more than 2 GiB of data to write, wanted less");
  }

  void keep_whole_views() {
    std::vector<Stretch> stretches;
    std::vector<std::optional<CompressedView>> compressed(uses_.size());
    for (std::size_t v = 0; v < uses_.size(); ++v) {
      if (!uses_[v].is_whole && !all_accessors_are_known(v)) uses_[v].is_whole = true;
      if (!uses_[v].is_whole) continue;
      compressed[v] = compressed_view(document_, v).value();
      if (compressed[v]) stretches.push_back({compressed[v]->offset, compressed[v]->offset + compressed[v]->length});
      if (const auto& view = document_.views[v]; view && !is_decoded(v))
        stretches.push_back({view->offset, view->offset + view->length});
    }
    const Moves moves(merged(std::move(stretches)), 0);
    lists_.bytes = moves.appended(std::move(lists_.bytes), document_.binary);
    for (std::size_t v = 0; v < uses_.size(); ++v) {
      if (!uses_[v].is_whole) continue;
      if (const auto& view = document_.views[v]; view && !is_decoded(v))
        place_view(v, moves(view->offset), view->length);
      if (compressed[v]) keep_compressed(v, *compressed[v], moves(compressed[v]->offset));
    }
  }

  /// Whether its data were compressed in the file, without others there: they are beyond those of all buffers.
  [[nodiscard]] bool is_decoded(std::size_t v) const {
    const auto& buffers = document_.buffers;
    return document_.views[v] && !buffers.empty() &&
           document_.views[v]->offset >= buffers.back().offset + (buffers.back().has_data ? buffers.back().length : 0);
  }

  /// As it was in the file; where that has no other data of it, they have their place in the buffer without data.
  void keep_compressed(std::size_t v, const CompressedView& compressed, std::size_t offset) {
    Json& view = lists_.views[v];
    Json& extension = view["extensions"][std::string(compressed.extension)];
    extension["buffer"] = 0;
    set_number(extension, "byteOffset", offset);
    lists_.extensions.insert(std::string(compressed.extension));
    if (!document_.views[v] || is_decoded(v)) place_decoded(view, view["byteLength"].get<std::size_t>());
  }
  void place_decoded(Json& view, std::size_t length) {
    lists_.decoded_bytes = (lists_.decoded_bytes + 7) / 8 * 8;
    view["buffer"] = 1;
    view["byteOffset"] = lists_.decoded_bytes;
    lists_.decoded_bytes += length;
  }

  [[nodiscard]] bool all_accessors_are_known(std::size_t v) const {
    return std::ranges::all_of(uses_[v].accessors,
                               [&](std::size_t index) { return accessor_of(document_, index).has_value(); });
  }

  void keep_parts_of(std::size_t v) {
    std::vector<Stretch> stretches;
    for (const std::size_t index : uses_[v].accessors) {
      const Accessor accessor = accessor_of(document_, index).value();
      stretches.push_back({*accessor.offset, *accessor.offset + accessor.extent()});
    }
    const std::size_t start = (lists_.bytes.size() + 7) / 8 * 8;
    const Moves moves(merged(stretches), start);
    lists_.bytes = moves.appended(std::move(lists_.bytes), document_.binary);
    for (std::size_t k = 0; k < stretches.size(); ++k)
      set_number(lists_.accessors[uses_[v].accessors[k]], "byteOffset", moves(stretches[k].begin) - start);
    place_view(v, start, moves.end() - start);
  }

  void place_view(std::size_t v, std::size_t offset, std::size_t length) {
    Json& view = lists_.views[v];
    view["buffer"] = 0;
    set_number(view, "byteOffset", offset);
    view["byteLength"] = length;
    if (!is_decoded(v)) return;
    for (const std::string_view name : meshopt_extensions) view["extensions"].erase(std::string(name));
    if (view["extensions"].empty()) view.erase("extensions");
  }

  /// The place of a new view, of which so many came before.
  [[nodiscard]] std::size_t view_place(std::size_t before, const std::vector<std::size_t>& free_views) const {
    return before < free_views.size() ? free_views[before] : uses_.size() + before - free_views.size();
  }

  /// The new keys in their own view. Returns how many views there are for them.
  std::size_t add_new(const KeyStore& store, const std::vector<std::size_t>& free_views) {
    if (store.size() == 0) return 0;
    const std::size_t place = view_place(0, free_views);
    lists_.bytes.resize((lists_.bytes.size() + 3) / 4 * 4);
    const std::size_t start = lists_.bytes.size();
    for (std::size_t entry = 0; entry < store.size(); ++entry) {
      const std::size_t offset = lists_.bytes.size() - start;
      put_accessor(store, entry, store.accessor(entry, store.entry(entry).component, offset), place);
      lists_.bytes += store.bytes_of(entry);
    }
    put(lists_.views, place, {{"buffer", 0}, {"byteOffset", start}, {"byteLength", lists_.bytes.size() - start}});
    return 1;
  }

  /// The same, in a compressed view for each kind of numbers.
  std::size_t add_compressed(const KeyStore& store, const std::vector<std::size_t>& free_views) {
    KeyStreams keys = streams_of(store);
    for (std::size_t i = 0; i < keys.streams.size(); ++i)
      put(lists_.views, view_place(i, free_views), compressed_stream(keys.streams[i]));
    for (std::size_t entry = 0; entry < store.size(); ++entry)
      put_accessor(store, entry, std::move(keys.accessors[entry]), view_place(keys.stream_of[entry], free_views));
    return keys.streams.size();
  }

  [[nodiscard]] Json compressed_stream(const KeyStream& stream) {
    const std::string compressed = to_meshopt(stream.bytes, stream.stride);
    lists_.bytes.resize((lists_.bytes.size() + 3) / 4 * 4);
    Json extension{{"buffer", 0},
                   {"byteOffset", lists_.bytes.size()},
                   {"byteLength", compressed.size()},
                   {"byteStride", stream.stride},
                   {"count", stream.bytes.size() / stream.stride},
                   {"mode", "ATTRIBUTES"}};
    if (!stream.filter.empty()) extension["filter"] = stream.filter;
    lists_.bytes += compressed;
    lists_.extensions.emplace(meshopt_extension);
    Json view{{"byteLength", stream.bytes.size()}};
    place_decoded(view, stream.bytes.size());
    view["extensions"][std::string(meshopt_extension)] = std::move(extension);
    return view;
  }

  void put_accessor(const KeyStore& store, std::size_t entry, Json accessor, std::size_t view) {
    accessor["bufferView"] = view;
    put(lists_.accessors, store.slot(entry), std::move(accessor));
  }

  static void put(Json& list, std::size_t place, Json value) {
    if (place < list.size()) list[place] = std::move(value);
    else list.push_back(std::move(value));
  }

  /// Drops free places at the end of a list and fills the others; the first `taken` of them are in use.
  static void fill_or_drop(Json& list, const std::vector<std::size_t>& free_places, std::size_t taken,
                           const Json& unused) {
    for (std::size_t k = free_places.size(); k > taken; --k) {
      if (free_places[k - 1] + 1 == list.size()) list.erase(list.size() - 1);
      else list[free_places[k - 1]] = unused;
    }
  }

  /// What takes no bytes: a zero without a bufferView, and a view of what is there anyway.
  static Json unused_accessor() {
    return {{"componentType", static_cast<int>(ComponentType::f32)}, {"count", 1}, {"type", "SCALAR"}};
  }
  static Json unused_view() { return {{"buffer", 0}, {"byteLength", unused_length}}; }
  static constexpr std::size_t unused_length = 4;

  const Document& document_;
  std::vector<ViewUse> uses_;
  Packed lists_;
};

}  // namespace

std::size_t KeyStore::add(const ValueType& type, const std::vector<float>& numbers, Kind kind) {
  std::string key(type.word);
  key += static_cast<char>('0' + static_cast<int>(kind));
  const std::size_t head = key.size();
  key.resize(head + numbers.size() * sizeof(float));
  std::memcpy(key.data() + head, numbers.data(), numbers.size() * sizeof(float));
  const auto [found, is_new] = entry_of_bytes_.try_emplace(std::move(key), entries_.size());
  if (is_new) {
    entries_.push_back({.type = type.word,
                        .offset = bytes_.size(),
                        .count = numbers.size() / type.components,
                        .first = numbers.front(),
                        .last = numbers.back(),
                        .kind = kind});
    bytes_.append(found->first, head);
  }
  return slot(found->second);
}

void KeyStore::write_in(ComponentType component, std::size_t slot) {
  const auto free = std::ranges::lower_bound(free_slots_, slot);
  const bool was_free = free != free_slots_.end() && *free == slot;
  const auto entry =
      was_free ? static_cast<std::size_t>(free - free_slots_.begin()) : slot - next_slot_ + free_slots_.size();
  entries_[entry].component = component;
}

std::vector<float> KeyStore::numbers(std::size_t entry) const {
  const std::size_t begin = entries_[entry].offset;
  const std::size_t end = entry + 1 < entries_.size() ? entries_[entry + 1].offset : bytes_.size();
  std::vector<float> numbers((end - begin) / sizeof(float));
  std::memcpy(numbers.data(), bytes_.data() + begin, end - begin);
  return numbers;
}

std::string KeyStore::bytes_of(std::size_t entry) const {
  const std::vector<float> held = numbers(entry);
  const ComponentType component = entries_[entry].component;
  if (component != ComponentType::f32) return bytes_in(component, held).value();
  return {reinterpret_cast<const char*>(held.data()), held.size() * sizeof(float)};
}

Json KeyStore::accessor(std::size_t entry, ComponentType component, std::size_t offset) const {
  const Entry& data = entries_[entry];
  Json json{{"componentType", static_cast<int>(component)}, {"count", data.count}, {"type", data.type}};
  if (offset > 0) json["byteOffset"] = offset;
  if (component != ComponentType::f32) json["normalized"] = true;
  if (data.kind != Kind::times) return json;
  json["min"] = Json::array({static_cast<double>(data.first)});
  json["max"] = Json::array({static_cast<double>(data.last)});
  return json;
}

Uses uses_of(const Document& document, const KeptSamplers& kept) {
  const Object root = document.root();
  const std::size_t accessors = root.list("accessors").value()->size();
  const SamplerAccessors samplers(*root.list("animations").value());
  Marks others(accessors, document.views.size());
  for (auto member = document.json.begin(); member != document.json.end(); ++member)
    if (const auto& key = member.key(); key != "animations" && key != "accessors" && key != "bufferViews")
      others.walk(*member);
  others = samplers.marked(std::move(others), kept);
  const Marks of_samplers = samplers.marked(Marks(accessors, 0), {});
  Uses uses;
  std::vector<bool> goes(accessors);
  for (std::size_t i = 0; i < accessors; ++i) {
    goes[i] = of_samplers.has_accessor(i) && !others.has_accessor(i);
    if (goes[i]) uses.free_accessors.push_back(i);
  }
  uses.views = view_uses(document, goes, std::move(others));
  return uses;
}

Expected<Packed> packed(const Document& document, const Uses& uses, const KeyStore& store, KeyCompression compression) {
  return check_views(document).and_then(
      [&] { return Packing(document, uses).with(store, uses.free_accessors, compression); });
}

}}}  // namespace orispline::scenes::gltf
