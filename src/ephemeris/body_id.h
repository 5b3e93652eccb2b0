// The bodies whose places are known, and their names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antumbra {

// A planet means the planet's own centre; a barycentre that of the planet with its moons.
enum class BodyId {
  SolarSystemBarycentre,
  Sun,
  Mercury,
  Venus,
  EarthMoonBarycentre,
  Earth,
  Moon,
  Mars,
  JupiterBarycentre,
  Jupiter,
  SaturnBarycentre,
  Saturn,
  UranusBarycentre,
  Uranus,
  NeptuneBarycentre,
  Neptune,
  PlutoBarycentre,
  Pluto,
  Phobos,
  Deimos,
  Io,
  Europa,
  Ganymede,
  Callisto,
  Mimas,
  Enceladus,
  Tethys,
  Dione,
  Rhea,
  Titan,
  Hyperion,
  Iapetus,
  Miranda,
  Ariel,
  Umbriel,
  Titania,
  Oberon,
  Triton,
  Proteus,
  Charon,
};

// "Sun", "Moon", "Jupiter", "JupiterBarycentre" ...
std::string nameOf(BodyId body);
std::optional<BodyId> bodyFromName(std::string_view name);
// Throws InputError that lists the names.
BodyId bodyNamed(std::string_view name, const std::string& where);
const std::vector<BodyId>& allBodies();

// The body that the planetary theories place: a planet's barycentre for the planet and its moons
// (Mars for its own), the body itself otherwise.
BodyId systemOf(BodyId body);
// A moon other than the Earth's.
bool isSatellite(BodyId body);

}  // namespace antumbra
