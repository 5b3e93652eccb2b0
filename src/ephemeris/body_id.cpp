#include "ephemeris/body_id.h"

#include <fmt/format.h>
#include <array>
#include <utility>

#include "document/input_error.h"

namespace antumbra {
namespace {

constexpr std::array kNames{
    std::pair{BodyId::SolarSystemBarycentre, "SolarSystemBarycentre"},
    std::pair{BodyId::Sun, "Sun"},
    std::pair{BodyId::Mercury, "Mercury"},
    std::pair{BodyId::Venus, "Venus"},
    std::pair{BodyId::EarthMoonBarycentre, "EarthMoonBarycentre"},
    std::pair{BodyId::Earth, "Earth"},
    std::pair{BodyId::Moon, "Moon"},
    std::pair{BodyId::Mars, "Mars"},
    std::pair{BodyId::JupiterBarycentre, "JupiterBarycentre"},
    std::pair{BodyId::Jupiter, "Jupiter"},
    std::pair{BodyId::SaturnBarycentre, "SaturnBarycentre"},
    std::pair{BodyId::Saturn, "Saturn"},
    std::pair{BodyId::UranusBarycentre, "UranusBarycentre"},
    std::pair{BodyId::Uranus, "Uranus"},
    std::pair{BodyId::NeptuneBarycentre, "NeptuneBarycentre"},
    std::pair{BodyId::Neptune, "Neptune"},
    std::pair{BodyId::PlutoBarycentre, "PlutoBarycentre"},
    std::pair{BodyId::Pluto, "Pluto"},
    std::pair{BodyId::Phobos, "Phobos"},
    std::pair{BodyId::Deimos, "Deimos"},
    std::pair{BodyId::Io, "Io"},
    std::pair{BodyId::Europa, "Europa"},
    std::pair{BodyId::Ganymede, "Ganymede"},
    std::pair{BodyId::Callisto, "Callisto"},
    std::pair{BodyId::Mimas, "Mimas"},
    std::pair{BodyId::Enceladus, "Enceladus"},
    std::pair{BodyId::Tethys, "Tethys"},
    std::pair{BodyId::Dione, "Dione"},
    std::pair{BodyId::Rhea, "Rhea"},
    std::pair{BodyId::Titan, "Titan"},
    std::pair{BodyId::Hyperion, "Hyperion"},
    std::pair{BodyId::Iapetus, "Iapetus"},
    std::pair{BodyId::Miranda, "Miranda"},
    std::pair{BodyId::Ariel, "Ariel"},
    std::pair{BodyId::Umbriel, "Umbriel"},
    std::pair{BodyId::Titania, "Titania"},
    std::pair{BodyId::Oberon, "Oberon"},
    std::pair{BodyId::Triton, "Triton"},
    std::pair{BodyId::Proteus, "Proteus"},
    std::pair{BodyId::Charon, "Charon"},
};

}  // namespace

std::string nameOf(BodyId body) { return kNames[static_cast<std::size_t>(body)].second; }

std::optional<BodyId> bodyFromName(std::string_view name) {
  for (const auto& [body, text] : kNames)
    if (name == text) return body;
  return std::nullopt;
}

BodyId bodyNamed(std::string_view name, const std::string& where) {
  if (auto const body = bodyFromName(name)) return *body;
  std::vector<std::string> names;
  for (const auto& [body, text] : kNames) names.emplace_back(text);
  throw InputError(fmt::format("{}: found unknown body \"{}\"; allowed: {}", where, name,
                               fmt::join(names, ", ")));
}

const std::vector<BodyId>& allBodies() {
  static const std::vector<BodyId> bodies = [] {
    std::vector<BodyId> b;
    for (const auto& [body, text] : kNames) b.push_back(body);
    return b;
  }();
  return bodies;
}

bool isSatellite(BodyId body) { return body >= BodyId::Phobos; }

BodyId systemOf(BodyId body) {
  switch (body) {
    case BodyId::Jupiter:
      return BodyId::JupiterBarycentre;
    case BodyId::Saturn:
      return BodyId::SaturnBarycentre;
    case BodyId::Uranus:
      return BodyId::UranusBarycentre;
    case BodyId::Neptune:
      return BodyId::NeptuneBarycentre;
    case BodyId::Pluto:
      return BodyId::PlutoBarycentre;
    default:
      break;
  }
  if (!isSatellite(body)) return body;
  if (body <= BodyId::Deimos) return BodyId::Mars;
  if (body <= BodyId::Callisto) return BodyId::JupiterBarycentre;
  if (body <= BodyId::Iapetus) return BodyId::SaturnBarycentre;
  if (body <= BodyId::Oberon) return BodyId::UranusBarycentre;
  if (body <= BodyId::Proteus) return BodyId::NeptuneBarycentre;
  return BodyId::PlutoBarycentre;
}

}  // namespace antumbra
