// The bodies a scene can hold, read from catalogs/bodies/*.toml (keys and sources: the README
// there).
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "quantity/quantity.h"
#include "scene/ring_system.h"

namespace antumbra {

// V magnitude at 1 au from Sun and observer as a function of the phase angle, by intervals.
struct MagnitudeLaw {
  enum class Form { Polynomial, LogPolynomial, Ringed };
  struct Interval {
    Angle to;
    Form form = Form::Polynomial;
    std::vector<double> coefficients;
  };
  std::vector<Interval> intervals;

  // Apparent V at distances r (Sun to body) and d (body to observer). `ringTilt` is the geometric
  // mean of the planetocentric latitudes of Sun and observer (only ringed bodies use it). Beyond
  // the last published interval there is no value.
  std::optional<double> apparent(Angle phase, Length r, Length d, Angle ringTilt = Angle()) const;
};

struct Surface {
  enum class Scattering { Lambert, LommelSeeliger };
  Scattering scattering = Scattering::Lambert;
  double geometricAlbedo = 0.0;
  glm::vec3 reflectance{0.3f};       // mean, linear sRGB
  std::string map;                   // relative to catalogs/, or empty
  std::optional<glm::vec3> mapMean;  // linear sRGB mean of the map, if it is relative
  std::string waterMask;
  std::string nightMap;
  double nightLuminance = 0.0;  // cd/m2 of the night map's full scale
};

struct Body {
  std::string key;
  std::string name;
  std::string kind;
  std::string parent;  // key, empty for the Sun
  std::string ephemeris;
  std::string atmosphere;
  double colorIndexBv = 0.653;  // the Sun's own, where nothing is known
  Length equatorialRadius;
  Length polarRadius;
  Surface surface;
  MagnitudeLaw magnitude;
  std::optional<RingSystem> rings;
  std::string file;
};

class BodyCatalogue {
 public:
  // Reads every *.toml of the folder. Throws InputError with file and line on unknown keys, wrong
  // units, non-positive radii, a polar radius above the equatorial one, an unknown parent, a loop.
  static BodyCatalogue load(const std::filesystem::path& folder);
  static const BodyCatalogue& standard();  // catalogs/bodies

  // By key or name, whatever the case. Throws InputError that opens with `where` and lists the
  // bodies.
  const Body& body(const std::string& name, const std::string& where) const;
  const std::map<std::string, Body>& all() const { return bodies_; }
  // Number of steps up to the root: 0 for the Sun.
  int depth(const Body& body) const;

 private:
  std::map<std::string, Body> bodies_;
};

// One body's file; exposed for tests.
Body readBody(const Table& table, const std::string& key);

}  // namespace antumbra
