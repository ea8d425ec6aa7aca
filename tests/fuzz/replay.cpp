// SPDX-License-Identifier: Apache-2.0
// Runs a fuzz target on files, and on all files of folders, where there is no fuzzing engine: FUZZ_TARGET PATH…
// A target with a mutator of its own is also run on what that makes of each file, change upon change.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" {
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
__attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                                          unsigned seed);

/// The engine's change of bytes, which a mutator may ask for: none.
std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) { return size; }
}

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_at(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

constexpr unsigned changes_of_a_file = 64;
constexpr std::size_t most_bytes = 16384;  // of a changed file

void run_changed(std::vector<std::uint8_t> bytes) {
  std::size_t size = bytes.size();
  bytes.resize(most_bytes);
  for (unsigned seed = 0; LLVMFuzzerCustomMutator && seed < changes_of_a_file; ++seed) {
    size = LLVMFuzzerCustomMutator(bytes.data(), size, bytes.size(), seed);
    LLVMFuzzerTestOneInput(bytes.data(), size);
  }
}

bool run(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::fprintf(stderr, "cannot open %s\n", path.c_str()), false;
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  std::fprintf(stderr, "%s\n", path.c_str());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  if (bytes.size() < most_bytes) run_changed(bytes);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t replayed = 0;
  for (int i = 1; i < argc; ++i)
    for (const fs::path& file : files_at(argv[i])) {
      if (!run(file)) return 1;
      ++replayed;
    }
  std::printf("%zu files replayed\n", replayed);
  return replayed > 0 ? 0 : 1;
}
