#include "ephemeris/mapped_catalogue.h"

#include <fmt/format.h>

namespace antumbra {

MappedCatalogue::MappedCatalogue(const std::filesystem::path& file, std::string_view format,
                                 std::string builder)
    : file_(file), builder_(std::move(builder)) {
  if (file_.size() < kHead || std::memcmp(file_.data(), format.data(), format.size()) != 0)
    throw broken(fmt::format("does not begin with {}", format));
}

std::size_t MappedCatalogue::countOf(std::size_t entryBytes) const {
  std::uint32_t count;
  std::memcpy(&count, file_.data() + 8, sizeof count);
  if (kHead + entryBytes * count > file_.size()) throw broken("is cut short");
  return count;
}

const std::byte* MappedCatalogue::at(std::uint64_t offset, std::uint64_t bytes,
                                     std::string_view entry) const {
  if (offset > file_.size() || bytes > file_.size() - offset)
    throw broken(fmt::format("entry {} points outside the file", entry));
  return file_.data() + offset;
}

InputError MappedCatalogue::broken(std::string_view what) const {
  return InputError(fmt::format("{}: {}; allowed: a file of {}", name(), what, builder_));
}

}  // namespace antumbra
