// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/output_file.hpp>

#include <atomic>
#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr int most_held = 256;  // descriptors, of which a process commonly has 1024
std::atomic<int> held{0};

/// Whether the path still leads to the open file, which is a regular one.
bool is_at(int descriptor, const std::string& path) {
  struct stat open {};
  struct stat there {};
  return fstat(descriptor, &open) == 0 && lstat(path.c_str(), &there) == 0 && S_ISREG(open.st_mode) &&
         open.st_dev == there.st_dev && open.st_ino == there.st_ino;
}

}  // namespace

// Whoever removes a part holds its lock and has seen that the path still leads to it; whoever makes one looks after
// locking it whether it is still there. So nobody removes the part of another that is being written.

void remove_if_left(const std::string& part) {
  const int descriptor = ::open(part.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_at(descriptor, part)) unlink(part.c_str());
  ::close(descriptor);
}

bool lock_part(std::FILE* file, const std::string& part) {
  if (flock(fileno(file), LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
  return is_at(fileno(file), part);
}

PartLock::PartLock(std::FILE* file) {
  if (held.fetch_add(1) < most_held) descriptor_ = fcntl(fileno(file), F_DUPFD_CLOEXEC, 0);
  if (descriptor_ == none) --held;
}

PartLock::~PartLock() {
  if (descriptor_ == none) return;
  ::close(descriptor_);
  --held;
}

}}}  // namespace orispline::io
