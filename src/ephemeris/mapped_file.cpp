#include "ephemeris/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>

#include "document/input_error.h"

namespace antumbra {

MappedFile::MappedFile(const std::filesystem::path& file) : name_(file.string()) {
  int const descriptor = ::open(name_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    throw InputError(name_ + ": cannot be read (" + std::strerror(errno) +
                     "); allowed: the project's own catalogue");
  struct stat status {};
  ::fstat(descriptor, &status);
  size_ = static_cast<std::size_t>(status.st_size);
  void* const at =
      size_ == 0 ? MAP_FAILED : ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
  ::close(descriptor);
  if (at == MAP_FAILED) throw InputError(name_ + ": is empty or cannot be mapped");
  data_ = static_cast<const std::byte*>(at);
}

MappedFile::~MappedFile() { ::munmap(const_cast<std::byte*>(data_), size_); }

}  // namespace antumbra
