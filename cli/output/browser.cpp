// SPDX-License-Identifier: Apache-2.0
#include "output/browser.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#ifdef __APPLE__
extern char** environ;
#endif

namespace orispline::cli {

namespace {

#ifdef __APPLE__
constexpr auto opener = "open";
bool has_display() { return true; }
#else
constexpr auto opener = "xdg-open";
bool is_stated(const char* variable) {
  const char* const value = std::getenv(variable);
  return value && *value;
}
bool has_display() { return is_stated("DISPLAY") || is_stated("WAYLAND_DISPLAY"); }
#endif

/// A program on its own: it neither writes on our terminal nor ends with it, and hears all signals as usual.
class Detached {
 public:
  Detached() {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&files_, output, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_init(&attributes_);
    sigset_t ignored;
    sigemptyset(&ignored);
#ifdef SIGXFSZ
    sigaddset(&ignored, SIGXFSZ);
#endif
    posix_spawnattr_setsigdefault(&attributes_, &ignored);
#ifdef POSIX_SPAWN_SETSID
    constexpr auto flags = POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSID;
#else
    constexpr auto flags = POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP;
#endif
    posix_spawnattr_setflags(&attributes_, static_cast<short>(flags));
  }
  ~Detached() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  Detached(const Detached&) = delete;
  Detached& operator=(const Detached&) = delete;

  /// Whatever becomes of it.
  void start(std::string program, std::string argument) const {
    const std::array<char*, 3> words{program.data(), argument.data(), nullptr};
    pid_t process = 0;
    static_cast<void>(posix_spawnp(&process, program.c_str(), &files_, &attributes_, words.data(), environ));
  }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

}  // namespace

void open_in_browser(const std::string& path) {
  if (!has_display()) return;
  std::error_code unknown;  // an absolute path is never taken for an option
  const auto whole = std::filesystem::absolute(path, unknown);
  if (!unknown) Detached().start(opener, whole.string());
}

}  // namespace orispline::cli
