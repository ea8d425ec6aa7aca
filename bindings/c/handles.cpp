// SPDX-License-Identifier: Apache-2.0
#include "handles.hpp"

#include <mutex>

#include <orispline/base/mutex.hpp>

namespace orispline::c {

namespace {

/// So many handles that were freed last are known for such.
constexpr std::size_t resting_shells = 64;

/// The shells that are free, the one that was freed first in front.
class FreeShells {
 public:
  [[nodiscard]] Shell* take() noexcept {
    const std::lock_guard lock(mutex_);
    if (count_ <= resting_shells) return nullptr;
    --count_;
    return std::exchange(first_, first_->next);
  }
  void* put(Shell* shell, Kind kind) noexcept {
    const std::lock_guard lock(mutex_);
    if (shell->kind != kind) return nullptr;  // another call was faster
    shell->kind = Kind::none;
    shell->next = nullptr;
    (count_++ == 0 ? first_ : last_->next) = shell;
    last_ = shell;
    return std::exchange(shell->body, nullptr);
  }

 private:
  Mutex mutex_;
  Shell* first_ = nullptr;
  Shell* last_ = nullptr;
  std::size_t count_ = 0;
};

FreeShells& free_shells() noexcept {
  static FreeShells shells;
  return shells;
}

}  // namespace

Shell* filled_shell(Kind kind, void* body) {
  Shell* shell = free_shells().take();
  if (!shell) shell = new Shell;
  *shell = {kind, body, nullptr};
  return shell;
}

void* emptied(Shell* shell, Kind kind) noexcept { return shell ? free_shells().put(shell, kind) : nullptr; }

tl::unexpected<Error> no_handle(const void* handle, std::string_view name) {
  return bad_option(name, handle ? "found a handle that was freed or is another one, wanted one that is in use"
                                 : "found null, wanted a handle");
}

Expected<void> check_pointer(const void* pointer, std::string_view name) {
  if (pointer) return {};
  return bad_option(name, "found null, wanted memory for it");
}

}  // namespace orispline::c
