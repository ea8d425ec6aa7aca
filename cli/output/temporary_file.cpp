// SPDX-License-Identifier: Apache-2.0
#include "output/temporary_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include <unistd.h>

#include <orispline/base/formatted.hpp>

#include "output/interruption.hpp"

namespace orispline::cli {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> no_access(const std::string& path, int system_error) {
  return failure(ErrorCode::bad_access,
                 formatted("cannot write: {} (TMPDIR names the folder for temporary files, -o FILE another place)",
                           std::generic_category().message(system_error)),
                 {.file = path});
}

std::string stated_folder() {
  const char* const stated = std::getenv("TMPDIR");
  return stated ? stated : "the folder for temporary files";
}

struct Close {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};

/// A new file that an interruption removes until it is whole.
struct NewFile {
  std::string path;
  std::unique_ptr<RemovedWhenInterrupted> note;
  std::unique_ptr<std::FILE, Close> file;
};

Expected<NewFile> new_file(const fs::path& folder, std::string_view name, std::string_view extension) {
  std::string path = (folder / formatted("{}-XXXXXX{}", name, extension)).string();
  const InterruptionHeld held;
  errno = 0;
  const int descriptor = mkstemps(path.data(), static_cast<int>(extension.size()));
  if (descriptor < 0) return no_access(folder.string(), errno);
  std::unique_ptr<std::FILE, Close> file(fdopen(descriptor, "wb"));
  if (!file) {
    const int fault = errno;
    ::close(descriptor);
    unlink(path.c_str());
    return no_access(path, fault);
  }
  auto note = std::make_unique<RemovedWhenInterrupted>(path);
  return NewFile{std::move(path), std::move(note), std::move(file)};
}

}  // namespace

Expected<std::string> write_temporary_file(std::string_view name, std::string_view extension,
                                           std::string_view content) {
  std::error_code fault_of_folder;
  const fs::path folder = fs::temp_directory_path(fault_of_folder);
  if (fault_of_folder) return no_access(stated_folder(), fault_of_folder.value());
  auto made = new_file(fs::absolute(folder, fault_of_folder), name, extension);
  if (!made) return tl::unexpected(std::move(made.error()));
  errno = 0;
  const bool is_whole = std::fwrite(content.data(), 1, content.size(), made->file.get()) == content.size() &&
                        std::fflush(made->file.get()) == 0;
  const int fault = errno;
  made->file.reset();
  if (is_whole) return std::move(made->path);
  unlink(made->path.c_str());
  return no_access(made->path, fault);
}

}  // namespace orispline::cli
