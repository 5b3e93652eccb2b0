// Damaged catalogues are refused with the file's name, wherever they are cut; the intact ones open.
#include "ephemeris/mapped_catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <fstream>
#include <iterator>

#include "document/paths.h"
#include "ephemeris/chebyshev_table.h"
#include "ephemeris/satellite_series.h"
#include "ephemeris/term_series.h"

namespace antumbra {
namespace {

template <class Catalogue>
class Catalogues : public testing::Test {};

struct Table {
  using Reader = TableCatalogue;
  static constexpr const char* kFile = "de431.bin";
};
struct Moons {
  using Reader = SatelliteCatalogue;
  static constexpr const char* kFile = "moons.bin";
};
struct Series {
  using Reader = SeriesCatalogue;
  static constexpr const char* kFile = "vsop87b.bin";
};
using All = testing::Types<Table, Moons, Series>;
TYPED_TEST_SUITE(Catalogues, All);

TYPED_TEST(Catalogues, AreRefusedWhereverTheyAreCut) {
  auto const whole = catalogsFolder() / "ephemeris" / TypeParam::kFile;
  EXPECT_NO_THROW(typename TypeParam::Reader{whole});
  std::ifstream in(whole, std::ios::binary);
  std::string const bytes(std::istreambuf_iterator<char>(in), {});
  std::string const cut = testing::TempDir() + TypeParam::kFile;
  for (std::size_t const kept : {std::size_t{1}, std::size_t{15}, std::size_t{16}, std::size_t{70},
                                 std::size_t{500}, bytes.size() / 2, bytes.size() - 64}) {
    std::ofstream(cut, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(kept));
    try {
      typename TypeParam::Reader reader{cut};
      FAIL() << "opened after " << kept << " of " << bytes.size() << " bytes";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(cut)) << kept;
      EXPECT_THAT(error.what(), testing::HasSubstr("allowed: a file of tools/build_")) << kept;
    }
  }
}

TYPED_TEST(Catalogues, AreRefusedUnderAnotherFormat) {
  auto const other = catalogsFolder() / "ephemeris" /
                     (std::string(TypeParam::kFile) == "moons.bin" ? "de431.bin" : "moons.bin");
  EXPECT_THROW(typename TypeParam::Reader{other}, InputError);
}

}  // namespace
}  // namespace antumbra
