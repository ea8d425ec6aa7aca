// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_uses.hpp>

#include <string_view>

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

}  // namespace

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

}}}  // namespace orispline::scenes::gltf
