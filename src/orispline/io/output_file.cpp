// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/output_file.hpp>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/io/file_format.hpp>
#include <orispline/io/file_system.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr int part_names = 100;   // tried one after the other: a part may be another process's
constexpr int cleared_names = 4;  // of them are looked at for parts that were left, and all those in use

tl::unexpected<Error> no_access(const std::string& path, const std::error_code& reason) {
  return failure(ErrorCode::bad_access, "cannot write: " + reason.message(), {.file = path});
}

std::error_code last_error() { return {errno, std::generic_category()}; }

/// Waits until the disk has the file: a name put in place before that could be of an empty file after a power cut.
bool reached_disk(std::FILE* file) {
#ifdef _WIN32
  return _commit(_fileno(file)) == 0;
#else
  return fsync(fileno(file)) == 0 || errno == EINVAL || errno == ENOTSUP;  // a file system that cannot be asked
#endif
}

/// The same for the same target, so that the next run finds what a killed one left.
std::string short_name_beside(const std::string& target) {
  const std::filesystem::path path = target;
  const std::size_t mark = std::hash<std::string>()(path.filename().string());
  return (path.parent_path() / formatted(".orispline-{:016x}", mark)).string();
}

/// Why an existing file may not be replaced, if so.
std::error_code write_protection(const std::string& path) {
  errno = 0;
  if (std::FILE* file = std::fopen(path.c_str(), "ab")) {
    std::fclose(file);
    return {};
  }
  return last_error();
}

}  // namespace

void OutputFile::Close::operator()(std::FILE* file) const noexcept {
  if (file != stdout) std::fclose(file);
}

Expected<OutputFile> OutputFile::open(const std::string& path) {
  OutputFile output;
  output.path_ = path;
  if (path == standard_stream) {
    output.file_.reset(stdout);
    return output;
  }
  output.target_ = behind_links(path);
  const Place place = place_at(output.target_);
  if (place.kind == PlaceKind::unknown) return no_access(path, place.fault);  // such as links in a circle
  if (place.kind == PlaceKind::folder) return no_access(path, std::make_error_code(std::errc::is_a_directory));
  errno = 0;
  if (place.kind == PlaceKind::other) {
    output.file_.reset(std::fopen(output.target_.c_str(), "wb"));
  } else {
    if (place.kind == PlaceKind::file)
      if (const std::error_code protection = write_protection(output.target_)) return no_access(path, protection);
    output.open_part();
  }
  if (!output.file_) return no_access(path, last_error());
  return output;
}

OutputFile OutputFile::in_memory(std::string name) {
  OutputFile output;
  output.path_ = std::move(name);
  output.is_in_memory_ = true;
  return output;
}

void OutputFile::open_part() {
  open_part(target_);
  if (!file_ && errno == ENAMETOOLONG) open_part(short_name_beside(target_));
}

void OutputFile::open_part(const std::string& start) {
  const auto name = [&](int i) { return start + ".part" + (i == 0 ? "" : std::to_string(i)); };
  for (int i = 0; i < cleared_names; ++i) remove_if_left(name(i));
  for (int i = 0; i < part_names && !file_; ++i) {
    part_ = name(i);
    if (i >= cleared_names) remove_if_left(part_);
    errno = 0;
    file_.reset(std::fopen(part_.c_str(), "wbx"));
    if (!file_ && errno != EEXIST) break;
    if (file_ && !lock_part(file_.get(), part_)) file_.reset();
  }
  if (!file_) part_.clear();
}

OutputFile::OutputFile(OutputFile&& other) noexcept { swap(other); }

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  OutputFile taken(std::move(other));
  swap(taken);
  return *this;
}

OutputFile::~OutputFile() {
  if (part_.empty()) return;
#ifdef _WIN32
  file_.reset();  // open files cannot be removed there
#endif
  std::remove(part_.c_str());  // while it is locked
}

void OutputFile::swap(OutputFile& other) noexcept {
  path_.swap(other.path_);
  target_.swap(other.target_);
  part_.swap(other.part_);
  bytes_.swap(other.bytes_);
  std::swap(is_in_memory_, other.is_in_memory_);
  file_.swap(other.file_);
  std::swap(lock_, other.lock_);
}

Expected<void> OutputFile::write(std::string_view text) {
  if (is_in_memory_) return bytes_.append(text), Expected<void>();
  ORISPLINE_EXPECT(file_ != nullptr);
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) return no_access(path_, last_error());
  return {};
}

Expected<void> OutputFile::write_again(std::string_view beginning) {
  if (is_in_memory_) return bytes_.replace(0, beginning.size(), beginning), Expected<void>();
  ORISPLINE_EXPECT(file_ != nullptr);
  errno = 0;
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) return no_access(path_, last_error());
  auto written = write(beginning);
  if (written && std::fseek(file_.get(), 0, SEEK_END) != 0) return no_access(path_, last_error());
  return written;
}

Expected<void> OutputFile::close() {
  if (is_in_memory_) return {};
  ORISPLINE_EXPECT(file_ != nullptr);
  errno = 0;
  if (std::fflush(file_.get()) != 0) return no_access(path_, last_error());
  if (!part_.empty() && !reached_disk(file_.get())) return no_access(path_, last_error());
  if (!part_.empty()) lock_ = PartLock(file_.get());
  std::FILE* file = file_.release();
  if (file != stdout && std::fclose(file) != 0) return no_access(path_, last_error());
  return {};
}

Expected<void> OutputFile::finish() {
  if (file_)
    if (auto closed = close(); !closed) return closed;
  if (part_.empty()) return {};
  if (const std::error_code fault = put_in_place(part_, target_)) return no_access(path_, fault);
  part_.clear();
  lock_ = {};
  return {};
}

bool is_stream(const std::string& path) { return path == standard_stream || place_at(path).kind == PlaceKind::other; }

Expected<void> check_output(const std::string& path) {
  if (is_stream(path)) return {};
  return OutputFile::open(path).map([](const OutputFile&) {});
}

}}}  // namespace orispline::io
