// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <orispline/scenes/gltf/document.hpp>
#include <orispline/scenes/gltf/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// The accessors of new animation data, equal ones once.
class KeyStore {
 public:
  enum class Kind { times, values, spline };  ///< splines: with a tangent before and after each value
  struct Entry {
    std::string_view type;
    std::size_t offset, count;  ///< in bytes(), as floats, and in elements
    float first, last;
    ComponentType component = ComponentType::f32;  ///< in the file; all numbers are such, to single precision
    Kind kind = Kind::values;
  };

  /// `free_slots`: numbers of accessors that are to be taken first, rising; then come those from `next_slot` on.
  KeyStore(std::vector<std::size_t> free_slots, std::size_t next_slot)
      : free_slots_(std::move(free_slots)), next_slot_(next_slot) {}

  /// The number of the accessor of rising times.
  [[nodiscard]] std::size_t times(const std::vector<float>& numbers) {
    return add({"SCALAR", 1}, numbers, Kind::times);
  }
  [[nodiscard]] std::size_t outputs(const std::vector<float>& numbers, const ValueType& type, bool is_spline) {
    return add(type, numbers, is_spline ? Kind::spline : Kind::values);
  }

  /// Lets the accessor of that number hold normalised integers, which bytes_in() finds its numbers to be.
  void write_in(ComponentType component, std::size_t slot);

  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }
  /// Of an entry, as the file holds it.
  [[nodiscard]] std::string bytes_of(std::size_t entry) const;
  [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }
  [[nodiscard]] const Entry& entry(std::size_t index) const noexcept { return entries_[index]; }
  [[nodiscard]] std::vector<float> numbers(std::size_t entry) const;
  /// The accessor of an entry in numbers of that type, whose bytes begin there in a bufferView that it does not name.
  [[nodiscard]] Json accessor(std::size_t entry, ComponentType component, std::size_t offset) const;
  [[nodiscard]] std::size_t slot(std::size_t entry) const noexcept {
    return entry < free_slots_.size() ? free_slots_[entry] : next_slot_ + entry - free_slots_.size();
  }

 private:
  [[nodiscard]] std::size_t add(const ValueType& type, const std::vector<float>& numbers, Kind kind);

  std::vector<std::size_t> free_slots_;
  std::size_t next_slot_;
  std::string bytes_{};
  std::vector<Entry> entries_{};
  std::unordered_map<std::string, std::size_t> entry_of_bytes_{};  ///< by the type and the bytes
};

/// Which samplers of each animation stay as they are.
using KeptSamplers = std::vector<std::vector<bool>>;

/// What becomes of a view when the keys of animations are taken out of a document.
struct ViewUse {
  bool is_whole = true;                  ///< else only what `accessors` refer to stays; nothing where there are none
  std::vector<std::size_t> accessors{};  ///< that lie in it and stay
};

/// What else a document refers to.
struct Uses {
  std::vector<std::size_t> free_accessors{};  ///< that nothing but samplers that go refers to, rising
  std::vector<ViewUse> views{};
};

[[nodiscard]] Uses uses_of(const Document& document, const KeptSamplers& kept);

/// The lists of a document and its only buffer with data.
struct Packed {
  Json accessors = Json::array(), views = Json::array();
  std::string bytes{};
  std::size_t decoded_bytes = 0;       ///< that compressed views stand for: of a second buffer, which has no data
  std::set<std::string> extensions{};  ///< by which they are compressed
};

/// What stays of a document, with the new keys. No accessor and no bufferView that stays gets another number, for
/// extensions may refer to them: their places are taken by new ones.
///
/// Errors (bad_data): a bufferView whose data only an extension knows; more than 2 GiB.
[[nodiscard]] Expected<Packed> packed(const Document& document, const Uses& uses, const KeyStore& store,
                                      KeyCompression compression);

}}}  // namespace orispline::scenes::gltf
