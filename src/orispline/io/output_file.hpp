// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <orispline/base/abi.hpp>
#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

// Parts are locked while their process lives: one that nobody holds was left by a run that was killed. Where files
// cannot be locked, nothing is taken for left.

/// Removes a part that no living process holds.
ORISPLINE_EXPORT void remove_if_left(const std::string& part);

/// Locks a part that was just made. False: another process took it for left in that very moment.
[[nodiscard]] ORISPLINE_EXPORT bool lock_part(std::FILE* file, const std::string& part);

/// Holds the lock of a part whose file is closed. A few hundred at a time; more are not held.
class ORISPLINE_EXPORT PartLock {
 public:
  PartLock() = default;
  /// Of an open file, whose lock stays when that is closed.
  explicit PartLock(std::FILE* file);
  PartLock(PartLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, none)) {}
  PartLock& operator=(PartLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~PartLock();

 private:
  static constexpr int none = -1;
  int descriptor_ = none;
};

/// A file that appears complete or not at all, after a power cut too.
///
/// Text goes to `<path>.part` beside the target, or to a part of a short name where that name is too long for the file
/// system; `finish` renames it. Destroyed before that, the part is removed and the target untouched. A part that was
/// left by a process that was killed is removed by the next one that writes the same target; a lock tells it from one
/// that is being written. Standard output (`-`), devices and pipes are written directly. A symbolic link stays, and
/// what it leads to is the target, also where that is not there yet.
class ORISPLINE_EXPORT OutputFile {
 public:
  /// Error: bad_access.
  [[nodiscard]] static Expected<OutputFile> open(const std::string& path);
  /// A file in memory, of that name for messages.
  [[nodiscard]] static OutputFile in_memory(std::string name);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;
  ~OutputFile();

  /// Error: bad_access.
  [[nodiscard]] Expected<void> write(std::string_view text);
  /// Writes over the beginning of the file. Error: bad_access, also for pipes.
  [[nodiscard]] Expected<void> write_again(std::string_view beginning);
  /// Closes the file, once the disk has it; it stays beside the target until finish(): so several files appear all or
  /// none. Nothing may be written afterwards. Error: bad_access.
  [[nodiscard]] Expected<void> close();
  /// Closes the file, if it is still open, and puts it in its place. Error: bad_access.
  [[nodiscard]] Expected<void> finish();

  /// What was written, of a file in memory.
  [[nodiscard]] std::string bytes() && noexcept { return std::move(bytes_); }

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// The part beside the target while it is being written; empty when there is none.
  [[nodiscard]] const std::string& part() const noexcept { return part_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept;
  };

  OutputFile() = default;
  void open_part();
  void open_part(const std::string& start);
  void swap(OutputFile& other) noexcept;

  std::string path_;    // as the caller gave it, for messages
  std::string target_;  // behind symbolic links
  std::string part_;    // empty when written directly
  std::string bytes_;   // of a file in memory
  bool is_in_memory_ = false;
  std::unique_ptr<std::FILE, Close> file_;
  PartLock lock_;  // of the part once the file is closed
};

/// Whether that is standard output (`-`), a device or a pipe.
[[nodiscard]] ORISPLINE_EXPORT bool is_stream(const std::string& path);

/// Whether a file can be opened there, asked for before long work; leaves nothing behind. Devices and pipes are taken
/// at their word. Error (bad_access): what OutputFile::open() would say.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_output(const std::string& path);

}}}  // namespace orispline::io
