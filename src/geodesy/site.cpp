#include "geodesy/site.h"

#include <fmt/format.h>
#include <GeographicLib/Geocentric.hpp>
#include <cmath>

#include "document/document.h"
#include "quantity/constants.h"

namespace antumbra {

Position<Itrs> itrsFromSite(const Site& site) {
  Position<Itrs> p;
  GeographicLib::Geocentric::WGS84().Forward(site.latitude / degree, site.longitude / degree,
                                             site.height / metre, p.m.x, p.m.y, p.m.z);
  return p;
}

Site siteFromItrs(Position<Itrs> position) {
  double latitude, longitude, height;
  GeographicLib::Geocentric::WGS84().Reverse(position.m.x, position.m.y, position.m.z, latitude,
                                             longitude, height);
  return {latitude * degree, longitude * degree, height * metre};
}

Rotation<Enu, Itrs> enuFromItrs(const Site& site) {
  double const sp = sin(site.latitude), cp = cos(site.latitude);
  double const sl = sin(site.longitude), cl = cos(site.longitude);
  // Columns: where the Itrs axes point in east, north, up.
  return {glm::dmat3({-sl, -sp * cl, cp * cl}, {cl, -sp * sl, cp * sl}, {0.0, cp, sp})};
}

Site parseSite(std::string_view text, const std::string& where) {
  std::vector<double> v;
  for (std::size_t start = 0; start <= text.size();) {
    auto const end = std::min(text.find(',', start), text.size());
    v.push_back(parseNumber(text.substr(start, end - start), where));
    start = end + 1;
  }
  if (v.size() < 2 || v.size() > 3)
    throw InputError(
        fmt::format("{}: found \"{}\"; allowed: LAT,LON,HEIGHT (degrees, degrees east, "
                    "metres above the ellipsoid)",
                    where, text));
  auto const check = [&](const char* name, double value, double low, double high,
                         const char* unit) {
    if (!(value >= low && value <= high))
      throw InputError(fmt::format("{}: found {} {} {}; allowed: {} to {}", where, name, value,
                                   unit, low, high));
  };
  check("latitude", v[0], -90.0, 90.0, "degrees");
  check("longitude", v[1], -180.0, 360.0, "degrees");
  if (v.size() == 3) check("height", v[2], -12000.0, 1e9, "m");
  return {v[0] * degree, v[1] * degree, (v.size() == 3 ? v[2] : 0.0) * metre};
}

HorizontalDirection horizontalFromEnu(Direction<Enu> d) {
  double const azimuth = std::atan2(d.u.x, d.u.y);
  return {(azimuth < 0.0 ? azimuth + 360.0 * degree.si : azimuth) * radian,
          arcTangent(d.u.z, std::hypot(d.u.x, d.u.y))};
}

Direction<Enu> enuFromHorizontal(HorizontalDirection h) {
  return {{cos(h.altitude) * sin(h.azimuth), cos(h.altitude) * cos(h.azimuth), sin(h.altitude)}};
}

Angle horizonDip(Length height, Length radius) {
  if (height.si <= 0.0) return Angle();
  return arcTangent(std::sqrt((height * (2.0 * radius + height)).si), radius.si);
}

Length curvatureRadius(Angle latitude, Angle azimuth) {
  double const e2 = kEarthFlattening * (2.0 - kEarthFlattening);
  double const w2 = 1.0 - e2 * sin(latitude) * sin(latitude);
  double const normal = kEarthEquatorialRadius.si / std::sqrt(w2);
  double const meridian = normal * (1.0 - e2) / w2;
  double const c = cos(azimuth), s = sin(azimuth);
  return 1.0 / (c * c / meridian + s * s / normal) * metre;
}

}  // namespace antumbra
