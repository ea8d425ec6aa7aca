// SPDX-License-Identifier: Apache-2.0
// The command in this process, in a folder of its own. The first line of the input is its arguments, the rest the file
// keys.csv, which is also its standard input.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <regex>
#include <sstream>

#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>
#include <fuzz/json_text.hpp>
#include <fuzz/temporary_file.hpp>

int orispline_command(int argc, char** argv);  // cli/main.cpp under another name

extern "C" void __sanitizer_set_report_fd(void* fd) __attribute__((weak));  // NOLINT: the sanitizers' own name

namespace orispline::fuzz { namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

constexpr const char* old_output = "t,qw,qx,qy,qz\n0,1,0,0,0\n";  // of a run before
constexpr rlim_t most_bytes_of_a_file = 4u << 20;
constexpr double largest_number = 1e5;  // samples, threads, iterations: more only takes longer
constexpr std::size_t most_words = 30;

/// Words without folders: nothing outside the own one is written; and without numbers that ask for days of work.
/// `reproduce` reads nothing and takes long.
bool may_run(const Words& words) {
  if (words.empty() || words.size() > most_words || words.front() == "reproduce") return false;
  for (const std::string& word : words) {
    if (word.find('/') != word.npos || word.find("..") != word.npos || word.find('\0') != word.npos) return false;
    for (std::size_t at = word.find_first_of("0123456789"); at < word.size();) {
      char* end = nullptr;
      if (std::strtod(word.c_str() + at, &end) > largest_number) return false;
      at = word.find_first_of("0123456789", static_cast<std::size_t>(end - word.c_str()));
    }
  }
  return true;
}

/// A variable of the environment as it was, or absent.
std::optional<std::string> variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? std::optional<std::string>(value) : std::nullopt;
}

/// Sanitizers, where there are any, say what they find there.
void report_to(std::intptr_t fd) {
  if (__sanitizer_set_report_fd) __sanitizer_set_report_fd(reinterpret_cast<void*>(fd));  // NOLINT: so they want it
}

/// While it lives, the streams of the process are files, and its folder and that for temporary files another one.
class Surroundings {
 public:
  Surroundings(const fs::path& folder, const TemporaryFolder& streams, const std::string& input)
      : folder_before_(fs::current_path()), temporary_before_(variable("TMPDIR")) {
    fs::current_path(folder);
    setenv("TMPDIR", folder.c_str(), 1);
    replace(0, input, O_RDONLY);
    replace(1, streams.file("stdout"), O_WRONLY | O_CREAT | O_TRUNC);
    replace(2, streams.file("stderr"), O_WRONLY | O_CREAT | O_TRUNC);
    report_to(before_[2]);
  }
  ~Surroundings() {
    std::fflush(stdout);
    std::fflush(stderr);
    for (int fd = 0; fd < 3; ++fd) {
      dup2(before_[fd], fd);
      close(before_[fd]);
    }
    report_to(2);
    std::error_code ignored;  // nothing may leave a destructor
    fs::current_path(folder_before_, ignored);
    if (temporary_before_) setenv("TMPDIR", temporary_before_->c_str(), 1);
    else unsetenv("TMPDIR");
  }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

 private:
  void replace(int fd, const std::string& path, int how) {
    before_[fd] = dup(fd);
    const int opened = open(path.c_str(), how, 0600);
    claim(before_[fd] >= 0 && opened >= 0 && dup2(opened, fd) == fd, "cannot open {}", path);
    close(opened);
  }

  fs::path folder_before_;
  std::optional<std::string> temporary_before_;
  int before_[3] = {};
};

int run(Words words) {
  words.insert(words.begin(), "orispline");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return orispline_command(static_cast<int>(words.size()), arguments.data());
}

bool has(const Words& words, std::string_view word) { return std::ranges::find(words, word) != words.end(); }

/// Short flags may be joined, -h among them.
bool is_answered_by_text(const Words& words) {
  const auto has_short_help = [](const std::string& word) {
    return word.starts_with('-') && !word.starts_with("--") && word.find('h') != word.npos;
  };
  return has(words, "--help") || has(words, "--version") || std::ranges::any_of(words, has_short_help);
}

/// Errors are one line, after which a hint may stand where the command line is at fault; warnings are lines too. Of
/// several inputs, and into a folder, each that failed has its line, and the last line says how many they are.
void claim_words(const std::string& text, int code) {
  static const std::regex count(R"(orispline: (\d+) of \d+ inputs? failed; .*)");
  std::istringstream lines(text);
  std::size_t errors = 0, wanted = code == 0 ? 0 : 1;
  for (std::string line; std::getline(lines, line);) {
    claim(is_one_printable_line(line), "a line for people is not printable: '{}'", line);
    const bool is_warning = line.starts_with("orispline: warning: ");
    errors += line.starts_with("orispline: ") && !is_warning ? 1 : 0;
    if (std::smatch found; std::regex_match(line, found, count)) wanted = std::stoul(found[1]) + 1;
  }
  claim(errors == wanted, "{} lines of error, wanted {}, code {}", errors, wanted, code);
}

/// Name and content of the files of a folder.
std::map<std::string, std::string> files_of(const TemporaryFolder& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    if (entry.is_regular_file()) {
      const std::string name = fs::relative(entry.path(), folder.path()).string();
      files[name] = folder.read(name);
    }
  return files;
}

/// Outputs are complete or absent. Of several inputs those that can be are written.
void claim_files(const TemporaryFolder& folder, const std::map<std::string, std::string>& before, int code,
                 bool into_folder) {
  const auto after = files_of(folder);
  for (const auto& [name, text] : after) {
    claim(!name.ends_with(".part"), "{} is left behind", name);
    const bool is_text = !text.starts_with("\x93NUMPY");
    if (is_text && !before.contains(name)) claim(text.ends_with('\n'), "{} is not complete", name);
  }
  if (code == 0) return;
  for (const auto& [name, text] : before) claim(after.contains(name) && after.at(name) == text, "{} is lost", name);
  if (!into_folder)
    claim(after.size() == before.size(), "{} files after code {}, before {}", after.size(), code, before.size());
}

void try_command(const Words& words, std::string_view keys) {
  static const TemporaryFolder streams;
  const TemporaryFolder folder;
  const std::string input = folder.write("keys.csv", keys);
  static_cast<void>(folder.write("old.csv", old_output));
  const auto before = files_of(folder);
  int code = -1;
  {
    const Surroundings surroundings(folder.path(), streams, input);
    code = run(words);
  }
  const std::string out = streams.read("stdout"), said = streams.read("stderr");
  const Situation situation(
      [&] { return fmt::format("code {}\nstdout:\n{}\nstderr:\n{}", code, out.substr(0, 2000), said); });
  claim(0 <= code && code <= 3, "the exit code is {}", code);
  claim_words(said, code);
  claim_files(folder, before, code, has(words, "--output-folder"));
  if (code == 0 && has(words, "--json") && !is_answered_by_text(words))
    claim(JsonText::is_whole(out), "this is no JSON");
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline::fuzz;
  for (const char* const display : {"DISPLAY", "WAYLAND_DISPLAY"}) unsetenv(display);  // no run opens a browser
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is a disk that is full
  const rlimit limit{most_bytes_of_a_file, most_bytes_of_a_file};
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string_view text = FuzzInput(data, size).rest();
  const std::string line(text.substr(0, text.find('\n')));
  std::istringstream stream(line);
  const Words words{std::istream_iterator<std::string>(stream), {}};
  if (!may_run(words)) return 0;
  const std::string_view keys = text.substr(std::min(text.size(), line.size() + 1));
  const Situation situation([&] { return fmt::format("orispline {}\nkeys.csv:\n{}", line, keys); });
  try_command(words, keys);
  return 0;
}
