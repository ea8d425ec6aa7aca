// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/packing.hpp>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/scenes/gltf/document.hpp>
#include <orispline/scenes/gltf/integers.hpp>
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

Expected<void> check_views(const Document& document) {
  for (std::size_t i = 0; i < document.views.size(); ++i) {
    const auto view = document.root().entry("bufferViews", "bufferView", i);
    if (!view) return tl::unexpected(view.error());
    const Json* extensions = view->find("extensions");
    if (!document.views[i] || (extensions != nullptr && names_a_buffer(*extensions)))
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

  [[nodiscard]] Expected<Packed> with(const KeyStore& store, const std::vector<std::size_t>& free_accessors) && {
    keep_whole_views();
    for (std::size_t v = 0; v < uses_.size(); ++v) {
      if (!uses_[v].is_whole && !uses_[v].accessors.empty()) keep_parts_of(v);
      if (lists_.bytes.size() > largest_scene_file) return too_large();
    }
    std::vector<std::size_t> free_views;
    for (std::size_t v = 0; v < uses_.size(); ++v)
      if (!uses_[v].is_whole && uses_[v].accessors.empty()) free_views.push_back(v);
    if (store.size() > 0) add_new(store, free_views.empty() ? lists_.views.size() : free_views.front());
    fill_or_drop(lists_.accessors, free_accessors, store.size(), unused_accessor());
    fill_or_drop(lists_.views, free_views, store.size() > 0 ? 1 : 0, unused_view());
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
    for (std::size_t v = 0; v < uses_.size(); ++v) {
      if (!uses_[v].is_whole && !all_accessors_are_known(v)) uses_[v].is_whole = true;
      const View& view = *document_.views[v];
      if (uses_[v].is_whole) stretches.push_back({view.offset, view.offset + view.length});
    }
    const Moves moves(merged(std::move(stretches)), 0);
    lists_.bytes = moves.appended(std::move(lists_.bytes), document_.binary);
    for (std::size_t v = 0; v < uses_.size(); ++v)
      if (uses_[v].is_whole) place_view(v, moves(document_.views[v]->offset), document_.views[v]->length);
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
  }

  /// The new keys in their own view.
  void add_new(const KeyStore& store, std::size_t place) {
    lists_.bytes.resize((lists_.bytes.size() + 3) / 4 * 4);
    const std::size_t start = lists_.bytes.size();
    for (std::size_t entry = 0; entry < store.size(); ++entry) {
      put(lists_.accessors, store.slot(entry), store.accessor(entry, place, lists_.bytes.size() - start));
      lists_.bytes += store.bytes_of(entry);
    }
    put(lists_.views, place, {{"buffer", 0}, {"byteOffset", start}, {"byteLength", lists_.bytes.size() - start}});
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

std::size_t KeyStore::add(std::string_view type, std::size_t components, const std::vector<float>& numbers) {
  std::string key(type);
  const std::size_t head = key.size();
  key.resize(head + numbers.size() * sizeof(float));
  std::memcpy(key.data() + head, numbers.data(), numbers.size() * sizeof(float));
  const auto [found, is_new] = entry_of_bytes_.try_emplace(std::move(key), entries_.size());
  if (is_new) {
    entries_.push_back({type, bytes_.size(), numbers.size() / components, numbers.front(), numbers.back()});
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

std::string KeyStore::bytes_of(std::size_t entry) const {
  const Entry& data = entries_[entry];
  const std::size_t end = entry + 1 < entries_.size() ? entries_[entry + 1].offset : bytes_.size();
  std::string bytes = bytes_.substr(data.offset, end - data.offset);
  if (data.component == ComponentType::f32) return bytes;
  std::vector<float> numbers(bytes.size() / sizeof(float));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return bytes_in(data.component, numbers).value();
}

Json KeyStore::accessor(std::size_t entry, std::size_t view, std::size_t offset) const {
  const Entry& data = entries_[entry];
  Json json{{"bufferView", view},
            {"componentType", static_cast<int>(data.component)},
            {"count", data.count},
            {"type", data.type}};
  if (offset > 0) json["byteOffset"] = offset;
  if (data.component != ComponentType::f32) json["normalized"] = true;
  if (data.type != "SCALAR") return json;
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

Expected<Packed> packed(const Document& document, const Uses& uses, const KeyStore& store) {
  return check_views(document).and_then([&] { return Packing(document, uses).with(store, uses.free_accessors); });
}

}}}  // namespace orispline::scenes::gltf
