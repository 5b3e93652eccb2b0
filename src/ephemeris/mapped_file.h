// A catalogue file mapped read-only into memory: nothing is copied or parsed at start-up.
#pragma once

#include <cstddef>
#include <filesystem>

namespace antumbra {

class MappedFile {
 public:
  // Throws InputError if the file is missing or empty.
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  const std::byte* data() const { return data_; }
  std::size_t size() const { return size_; }
  const std::string& name() const { return name_; }

 private:
  const std::byte* data_ = nullptr;
  std::size_t size_ = 0;
  std::string name_;
};

}  // namespace antumbra
