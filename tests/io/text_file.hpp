// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

#include <orispline/base/expected.hpp>

namespace orispline::test {

/// A directory of its own, removed with all that is in it at the end of the scope.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    static int count = 0;
    path_ = std::filesystem::path(::testing::TempDir()) /
            ("orispline_io_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] std::string file(std::string_view name) const { return (path_ / name).string(); }
  [[nodiscard]] std::size_t entries() const {
    const std::filesystem::directory_iterator begin(path_);
    return static_cast<std::size_t>(std::distance(begin, std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path path_;
};

/// A file with the given content, removed at the end of the scope.
class TextFile {
 public:
  explicit TextFile(std::string_view content, std::string_view name = "keys.csv") : path_(directory_.file(name)) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  ScratchDirectory directory_;
  std::string path_;
};

inline std::string content_of(const std::string& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

/// The one line for people, with the name of the file instead of its path, behind the option at fault: `[order] `.
inline std::string text_of(Error error) {
  error.where.file = std::filesystem::path(error.where.file).filename().string();
  const std::string option = std::exchange(error.option, {});
  return (option.empty() ? "" : "[" + option + "] ") + describe(error);
}

}  // namespace orispline::test
