#include "passes/air_quality.h"

#include <fmt/format.h>

#include "document/paths.h"

namespace antumbra {
namespace {

int within(const Table& table, const char* key, int otherwise, int least, int most) {
  long const found = table.integer(key, otherwise);
  if (found < least || found > most)
    table.fail(key, fmt::format("found {}; allowed: {} to {}", found, least, most));
  return static_cast<int>(found);
}

}  // namespace

AirQuality AirQuality::read(const Table& table) {
  AirQuality q;
  std::string const storage = table.text("storage", "float");
  if (storage != "float" && storage != "half")
    table.fail("storage", fmt::format("found \"{}\"; allowed: float, half", storage));
  q.storage = storage == "half" ? AirStorage::Half : AirStorage::Float;
  q.wavelengths = within(table, "wavelengths", q.wavelengths, 4, 40);
  if (q.wavelengths % 4) table.fail("wavelengths", "allowed: a multiple of 4");
  q.orders = within(table, "orders", q.orders, 0, 100);
  q.degree = within(table, "degree", q.degree, 2, 10);
  q.hazeDegree = within(table, "haze_degree", q.hazeDegree, q.degree, 10);
  q.depthWidth = within(table, "depth_width", q.depthWidth, 16, 2048);
  q.depthHeight = within(table, "depth_height", q.depthHeight, 8, 1024);
  q.sourceWidth = within(table, "source_width", q.sourceWidth, 16, 1024);
  q.sourceHeight = within(table, "source_height", q.sourceHeight, 4, 256);
  q.zenithDirections = within(table, "zenith_directions", q.zenithDirections, 4, 64);
  if (q.zenithDirections % 2) table.fail("zenith_directions", "allowed: an even number");
  q.azimuthDirections = within(table, "azimuth_directions", q.azimuthDirections, 2, 32);
  q.sourceSamples = within(table, "source_samples", q.sourceSamples, 2, 64);
  q.skySamples = within(table, "sky_samples", q.skySamples, 2, 64);
  q.viewSamples = within(table, "view_samples", q.viewSamples, 2, 64);
  q.groundSamples = within(table, "ground_samples", q.groundSamples, 2, 64);
  q.airScale = within(table, "air_scale", q.airScale, 1, 4);
  if (q.airScale == 3) table.fail("air_scale", "found 3; allowed: 1, 2, 4");
  q.skyWidth = within(table, "sky_width", q.skyWidth, 8, 1024);
  q.skyHeight = within(table, "sky_height", q.skyHeight, 16, 2048);
  if (q.skyHeight % 2) table.fail("sky_height", "allowed: an even number");
  q.eclipseDistances = within(table, "eclipse_distances", q.eclipseDistances, 8, 256);
  q.eclipseAzimuths = within(table, "eclipse_azimuths", q.eclipseAzimuths, 3, 32);
  q.eclipseHeights = within(table, "eclipse_heights", q.eclipseHeights, 3, 32);
  q.eclipseZeniths = within(table, "eclipse_zeniths", q.eclipseZeniths, 4, 64);
  if (q.eclipseZeniths % 2) table.fail("eclipse_zeniths", "allowed: an even number");
  q.eclipseTurns = within(table, "eclipse_turns", q.eclipseTurns, 4, 24);
  q.eclipseSamples = within(table, "eclipse_samples", q.eclipseSamples, 2, 64);
  q.eclipseOrders = within(table, "eclipse_orders", q.eclipseOrders, 2, 50);
  q.eclipseSkySamples = within(table, "eclipse_sky_samples", q.eclipseSkySamples, 2, 64);
  return q;
}

AirQuality AirQuality::preset(const std::string& name) {
  Document const document = Document::load(configsFolder() / "quality" / (name + ".toml"));
  auto const section = document.root().tableIfPresent("air");
  AirQuality const q = section ? read(*section) : AirQuality();
  if (section) section->finish();
  return q;
}

}  // namespace antumbra
