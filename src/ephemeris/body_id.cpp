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

}  // namespace antumbra
