// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/output_file.hpp>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <orispline/base/expect.hpp>
#include <orispline/io/file_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

namespace fs = std::filesystem;

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
  std::error_code reason;
  const fs::file_status status = fs::status(output.target_, reason);
  if (!fs::status_known(status)) return no_access(path, reason);  // such as links in a circle
  if (fs::is_directory(status)) return no_access(path, std::make_error_code(std::errc::is_a_directory));
  errno = 0;
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    output.file_.reset(std::fopen(output.target_.c_str(), "wb"));
  } else {
    if (fs::exists(status))
      if (const std::error_code protection = write_protection(output.target_)) return no_access(path, protection);
    output.open_part();
  }
  if (!output.file_) return no_access(path, last_error());
  return output;
}

void OutputFile::open_part() {
  const auto name = [this](int i) { return target_ + ".part" + (i == 0 ? "" : std::to_string(i)); };
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
  std::error_code ignored;
  fs::remove(part_, ignored);  // while it is locked
}

void OutputFile::swap(OutputFile& other) noexcept {
  path_.swap(other.path_);
  target_.swap(other.target_);
  part_.swap(other.part_);
  file_.swap(other.file_);
  std::swap(lock_, other.lock_);
}

Expected<void> OutputFile::write(std::string_view text) {
  ORISPLINE_EXPECT(file_ != nullptr);
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) return no_access(path_, last_error());
  return {};
}

Expected<void> OutputFile::write_again(std::string_view beginning) {
  ORISPLINE_EXPECT(file_ != nullptr);
  errno = 0;
  if (std::fseek(file_.get(), 0, SEEK_SET) != 0) return no_access(path_, last_error());
  auto written = write(beginning);
  if (written && std::fseek(file_.get(), 0, SEEK_END) != 0) return no_access(path_, last_error());
  return written;
}

Expected<void> OutputFile::close() {
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
  std::error_code reason;
  const fs::file_status old = fs::status(target_, reason);
  if (fs::exists(old)) fs::permissions(part_, old.permissions(), reason);
  fs::rename(part_, target_, reason);
  if (reason) return no_access(path_, reason);
  part_.clear();
  lock_ = {};
  return {};
}

std::string behind_links(const std::string& path) {
  constexpr int most_links = 40;  // as of Linux
  fs::path place = path;
  std::error_code unknown;
  for (int i = 0; i < most_links && !fs::exists(place, unknown) && fs::is_symlink(fs::symlink_status(place, unknown));
       ++i)
    place = place.parent_path() / fs::read_symlink(place, unknown);
  const fs::path target = fs::canonical(place, unknown);  // of links to pipes, which the system names, there is none
  return unknown ? place.string() : target.string();
}

bool is_stream(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return path == standard_stream || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

Expected<void> check_output(const std::string& path) {
  if (is_stream(path)) return {};
  return OutputFile::open(path).map([](const OutputFile&) {});
}

}}}  // namespace orispline::io
