// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A vector whose copies share its entries until one of them is changed: a thousand channels with the same keys hold
/// them once. What can change it makes its entries its own first, and so does reading through a list that is not const.
///
/// Copies may be read and changed from different threads at once, as those of a vector.
template <class T>
class SharedList {
 public:
  using value_type = T;
  using iterator = typename std::vector<T>::iterator;
  using const_iterator = typename std::vector<T>::const_iterator;

  SharedList() noexcept = default;
  // Not explicit, nor is the way back: it is a vector in all but what copies cost.
  SharedList(std::vector<T> entries) : block_(entries.empty() ? nullptr : new Block{{1}, std::move(entries)}) {}
  SharedList(std::initializer_list<T> entries) : SharedList(std::vector<T>(entries)) {}
  template <std::input_iterator It>
  SharedList(It first, It last) : SharedList(std::vector<T>(first, last)) {}
  SharedList(const SharedList& other) noexcept : block_(other.block_) {
    if (block_) block_->owners.fetch_add(1, std::memory_order_relaxed);
  }
  SharedList(SharedList&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  // NOLINTNEXTLINE(bugprone-unhandled-self-assignment): by a copy
  SharedList& operator=(const SharedList& other) noexcept { return *this = SharedList(other); }
  SharedList& operator=(SharedList&& other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~SharedList() { leave(block_); }

  operator const std::vector<T>&() const noexcept { return entries(); }

  [[nodiscard]] std::size_t size() const noexcept { return entries().size(); }
  [[nodiscard]] bool empty() const noexcept { return entries().empty(); }
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return entries()[i]; }
  [[nodiscard]] const T& front() const noexcept { return entries().front(); }
  [[nodiscard]] const T& back() const noexcept { return entries().back(); }
  [[nodiscard]] const T* data() const noexcept { return entries().data(); }
  [[nodiscard]] const_iterator begin() const noexcept { return entries().begin(); }
  [[nodiscard]] const_iterator end() const noexcept { return entries().end(); }

  [[nodiscard]] T& operator[](std::size_t i) { return own()[i]; }
  [[nodiscard]] T& front() { return own().front(); }
  [[nodiscard]] T& back() { return own().back(); }
  [[nodiscard]] T* data() { return own().data(); }
  [[nodiscard]] iterator begin() { return own().begin(); }
  [[nodiscard]] iterator end() { return own().end(); }

  void push_back(T entry) { own().push_back(std::move(entry)); }
  template <class... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    return own().emplace_back(std::forward<Arguments>(arguments)...);
  }
  void pop_back() { own().pop_back(); }
  template <class... Arguments>
  iterator insert(Arguments&&... arguments) {
    return own().insert(std::forward<Arguments>(arguments)...);
  }
  template <class... Arguments>
  void assign(Arguments&&... arguments) {
    own().assign(std::forward<Arguments>(arguments)...);
  }
  void resize(std::size_t size) { own().resize(size); }
  void reserve(std::size_t size) { own().reserve(size); }

  /// Whether both have the same entries in memory: they are equal then, without a look at them.
  [[nodiscard]] bool shares_with(const SharedList& other) const noexcept { return block_ == other.block_; }
  friend bool operator==(const SharedList& a, const SharedList& b) {
    return a.shares_with(b) || a.entries() == b.entries();
  }

 private:
  /// In the place of std::shared_ptr, whose use_count() synchronises with nobody: an owner that finds itself the last
  /// one has to see what the others did.
  struct Block {
    std::atomic<std::size_t> owners;
    std::vector<T> entries;
  };

  static void leave(Block* block) noexcept {
    if (block && block->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete block;
  }

  [[nodiscard]] const std::vector<T>& entries() const noexcept {
    if (block_) return block_->entries;
    static const std::vector<T> none;  // behind the return, so that its guard is not asked for every entry
    return none;
  }

  [[nodiscard]] std::vector<T>& own() {
    if (!block_) block_ = new Block{{1}, {}};
    else if (block_->owners.load(std::memory_order_acquire) > 1)
      leave(std::exchange(block_, new Block{{1}, block_->entries}));
    return block_->entries;
  }

  Block* block_ = nullptr;
};

}}  // namespace orispline
