#include "atmosphere/refracted_shadow_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "shared/as_cpp.h"

namespace antumbra {
namespace {

constexpr double kBehindStep = 0.01, kSunStep = 0.004;  // of the logarithms
constexpr double kLeastLight = 1e-12;                   // darker than any medium leaves a shadow

}  // namespace

RefractedShadowTable::RefractedShadowTable(const Medium& medium, Length ground, Length sunRadius,
                                           const std::vector<Length>& wavelengths,
                                           LimbDarkeningLaw law)
    : shadow_(medium, ground, wavelengths, law), sunRadius_(sunRadius) {}

Length RefractedShadowTable::distance(int place, const ShadowStation& station) const {
  return Length(glsl::distanceOfPlace(double(place) / (kPlaces - 1), shadow_.rim(station).si,
                                      shadow_.reach(station).si));
}

const std::vector<double>& RefractedShadowTable::node(int behind, int sun) {
  auto [found, fresh] = nodes_.try_emplace({behind, sun});
  if (!fresh) return found->second;
  ShadowStation const station{sunRadius_, Length(std::exp(kSunStep * sun)),
                              Length(std::exp(kBehindStep * behind))};
  std::size_t const bands = shadow_.wavelengths().size();
  std::vector<double>& table = found->second;
  table.resize(kPlaces * bands);
  auto const fill = [&](int first, int step) {
    for (int place = first; place < kPlaces; place += step) {
      auto const light = shadow_.lightAt(station, distance(place, station));
      for (std::size_t band = 0; band < bands; ++band)
        table[static_cast<std::size_t>(place) * bands + band] =
            std::log2(std::max(light[band], kLeastLight));
    }
  };
  int const threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
  std::vector<std::jthread> pool;
  for (int t = 1; t < threads; ++t) pool.emplace_back(fill, t, threads);
  fill(0, threads);
  return table;
}

std::vector<double> RefractedShadowTable::row(const ShadowStation& station) {
  double const b = std::log(station.behind.si) / kBehindStep;
  double const s = std::log(station.sunDistance.si) / kSunStep;
  double const fb = b - std::floor(b), fs = s - std::floor(s);
  int const ib = static_cast<int>(std::floor(b)), is = static_cast<int>(std::floor(s));
  std::vector<double> row;
  for (auto const& [db, ds] : {std::array{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
    double const weight = (db ? fb : 1.0 - fb) * (ds ? fs : 1.0 - fs);
    auto const& table = node(ib + db, is + ds);
    if (row.empty()) row.assign(table.size(), 0.0);
    for (std::size_t i = 0; i < table.size(); ++i) row[i] += weight * table[i];
  }
  return row;
}

}  // namespace antumbra
