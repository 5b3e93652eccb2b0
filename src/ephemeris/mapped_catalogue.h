// A catalogue of the project's own, mapped: eight letters that name its format, the number of its
// entries (32 bits), four bytes unused, the entries of one size, then the numbers they point to.
// Little-endian, written by the builders in tools/.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "document/input_error.h"
#include "ephemeris/mapped_file.h"

namespace antumbra {

class MappedCatalogue {
 public:
  // `builder`: who writes such files, for messages. Throws InputError if the file cannot be mapped
  // or does not begin with `format`.
  MappedCatalogue(const std::filesystem::path& file, std::string_view format, std::string builder);

  // Throws InputError if the file ends before its last entry.
  template <class Entry>
  std::vector<Entry> entries() const {
    static_assert(std::is_trivially_copyable_v<Entry>);
    std::vector<Entry> all(countOf(sizeof(Entry)));
    std::memcpy(all.data(), file_.data() + kHead, all.size() * sizeof(Entry));
    return all;
  }

  // The bytes an entry points to; throws InputError, naming the entry, if they leave the file.
  const std::byte* at(std::uint64_t offset, std::uint64_t bytes, std::string_view entry) const;

  // What to throw when the file is not what its builder writes.
  InputError broken(std::string_view what) const;
  const std::string& name() const { return file_.name(); }

 private:
  static constexpr std::size_t kHead = 16;
  std::size_t countOf(std::size_t entryBytes) const;

  MappedFile file_;
  std::string builder_;
};

// A name in a field of fixed size, padded with zeros.
template <std::size_t N>
std::string nameIn(const char (&field)[N]) {
  return std::string(field, strnlen(field, N));
}

}  // namespace antumbra
