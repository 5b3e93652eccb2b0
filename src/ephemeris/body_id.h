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
};

// "Sun", "Moon", "Jupiter", "JupiterBarycentre" ...
std::string nameOf(BodyId body);
std::optional<BodyId> bodyFromName(std::string_view name);
// Throws InputError that lists the names.
BodyId bodyNamed(std::string_view name, const std::string& where);
const std::vector<BodyId>& allBodies();

}  // namespace antumbra
