#include "passes/bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "gl/framebuffer.h"
#include "gl/view_block.h"
#include "medium/medium.h"
#include "passes/air_sky.h"
#include "passes/air_tables.h"
#include "passes/body_shadows.h"
#include "passes/body_tiles.h"
#include "passes/eclipsed_source.h"
#include "passes/refracted_light.h"
#include "photometry/spectral_weights.h"
#include "photometry/standard_spectra.h"
#include "quantity/constants.h"

namespace antumbra {
namespace {

struct BodyBlock {  // std140, interface/body.glsl
  glm::vec4 scaledFromCamera[3];
  glm::vec4 scaledCrossFromCross[3];
  glm::vec4 centre, up, heights, sun, trueSun, shape, albedo, mapFactor, night, shine;
};

// Light of a Lommel-Seeliger sphere at a phase angle over that at full phase.
double lommelSeeligerSphere(Angle phase) {
  double const a = std::min(phase / degree, 170.0);
  if (a < 1e-3) return 1.0;
  double const h = 0.5 * a * degree.si;
  return 1.0 - std::sin(h) * std::tan(h) * std::log(1.0 / std::tan(0.5 * h));
}

std::string keyOf(const gl::Definitions& definitions) {
  std::string key;
  for (auto const& [name, value] : definitions) key += name + "=" + value + ";";
  return key;
}

// Whether no two penumbras meet within `reach` of the body's centre, with a tenth to spare.
bool shadowsStayApart(const std::vector<glsl::ShadowPair>& pairs, double reach) {
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      auto const lineOf = [](const glsl::ShadowPair& p) {
        return std::pair(glsl::fromCasterSpace(p, p.foot),
                         glm::normalize(glsl::fromCasterSpace(p, p.axis)));
      };
      auto const [foot1, axis1] = lineOf(pairs[i]);
      auto const [foot2, axis2] = lineOf(pairs[k]);
      glm::dvec3 const between = foot1 - foot2;
      double const apart = glm::length(between - axis1 * glm::dot(between, axis1)) -
                           2.0 * reach * glm::length(axis1 - axis2);
      double widths = 0.0;
      for (auto const* p : {&pairs[i], &pairs[k]})
        widths += (p->penumbraRadius + 2.0 * reach * p->penumbraTangent) * (1.0 + p->squash);
      if (apart < 1.1 * widths) return false;
    }
  return true;
}

struct SurfaceMaps {
  gl::Texture colour, water, night;
};

bool isCoarse(std::size_t part) { return part >= std::size_t(BodyPart::CoarseSunlit); }

// Rectangles, as corners of two triangles each, larger by so many pixels on every side.
std::vector<glm::vec2> grown(std::vector<glm::vec2> corners, float by) {
  for (std::size_t i = 0; i < corners.size(); i += 6) {
    glm::vec2 const low = corners[i], high = corners[i + 2];
    for (std::size_t k = i; k < i + 6; ++k)
      for (int axis = 0; axis < 2; ++axis)
        corners[k][axis] += corners[k][axis] > 0.5f * (low[axis] + high[axis]) ? by : -by;
  }
  return corners;
}

// One sample of the air's light to several pixels, of the tile of the picture in hand.
struct AirSamples {
  gl::Texture light, transmittance;
  gl::Framebuffer target;
  glm::ivec2 origin{0};  // in samples: of the lower left one
  void cover(glm::ivec2 tileOrigin, glm::ivec2 targetSize, int scale) {
    origin = tileOrigin / scale - 1;
    glm::ivec2 const size = (tileOrigin + targetSize - 1) / scale - origin + 2;
    if (light && light.width() == size.x && light.height() == size.y) return;
    light = gl::Texture::plane(GL_RGBA32F, size.x, size.y);
    transmittance = gl::Texture::plane(GL_RGBA16F, size.x, size.y);
    target = gl::Framebuffer({&light, &transmittance});
  }
};

// What a body has resident, by its name.
struct Resident {
  std::string air;  // key of its tables, or empty
  std::unique_ptr<BodyShadows> shadows;
  std::unique_ptr<EclipsedSource> eclipsed;
  std::unique_ptr<RefractedLight> refracted;
  int pairCount = 0;
  LimbDarkeningLaw law = LimbDarkeningLaw::Hestroffer;
  bool illustrative = false;
  bool apart = true;  // its shadows nowhere meet
  std::unique_ptr<Rings> rings;
  std::unique_ptr<AirSky> sky;
  bool skyShown = false;
  gl::Buffer block;
  std::array<std::string, kBodyParts> programs;  // by BodyPart
  BodyTiles tiles;
  std::array<gl::Buffer, kBodyParts> corners;
  std::array<std::string, kBodyParts> samplers;  // programs of the coarse parts' samples
  std::array<gl::Buffer, kBodyParts> sampleCorners;
  glm::dvec3 up{0.0, 0.0, 1.0}, sun{1.0, 0.0, 0.0};
};

}  // namespace

struct BodiesPass::State {
  ImageSource images;
  AirQuality quality;
  std::vector<Length> wavelengths;
  gl::Buffer vacuum;  // colours for bodies without air
  QuadratureBlock nodes;
  std::map<std::string, std::unique_ptr<AirTables>> airs;
  std::map<std::string, std::shared_ptr<RefractedShadowTable>> refractedShadows;
  std::map<std::string, gl::Texture> maps;
  std::map<std::string, Resident> bodies;
  std::map<std::string, gl::Program> programs;
  AirSamples samples;
  bool exact = true;
  int tablesBuilt = 0;
  GLuint vertexArrayId = 0;

  ~State() {
    if (vertexArrayId) glDeleteVertexArrays(1, &vertexArrayId);
  }
  GLuint vertexArray() {
    if (!vertexArrayId) {
      glCreateVertexArrays(1, &vertexArrayId);
      glEnableVertexArrayAttrib(vertexArrayId, 0);
      glVertexArrayAttribFormat(vertexArrayId, 0, 2, GL_FLOAT, GL_FALSE, 0);
      glVertexArrayAttribBinding(vertexArrayId, 0, 0);
    }
    return vertexArrayId;
  }

  State(ImageSource source, const AirQuality& q)
      : images(std::move(source)), quality(q), nodes(q.viewSamples, q.groundSamples) {
    wavelengths = defaultWavelengths(q.wavelengths);
    auto const block = airBlockOf(nullptr, wavelengths, 1.0 * metre, -0.5, Angle(0.00465), {}, {});
    vacuum.write(std::span<const glm::vec4>(block));
  }

  gl::Definitions vacuumDefinitions() const {
    return {{"AIR_LAYERS", std::to_string(wavelengths.size() / 4)},
            {"AIR_CONSTITUENTS", "1"},
            {"AIR_SMOOTH", "1"},
            {"AIR_DARK", "1"}};
  }

  const gl::Texture* map(const std::string& file, const std::string& where, bool colour) {
    if (file.empty()) return nullptr;
    auto const found = maps.find(file);
    if (found != maps.end()) return &found->second;
    DecodedImage image = images(file, where);
    if (colour && image.components == 1) {  // grey, in the colour transfer of sRGB
      std::vector<unsigned char> spread;
      for (unsigned char grey : image.texels) spread.insert(spread.end(), 3, grey);
      image.texels = std::move(spread);
      image.components = 3;
    }
    GLenum const format = image.components == 1 ? GL_R8
                          : colour ? (image.components == 3 ? GL_SRGB8 : GL_SRGB8_ALPHA8)
                                   : GL_RGBA8;
    auto texture = gl::Texture::plane(format, image.width, image.height, gl::Filter::Mipmapped,
                                      gl::Wrap::RepeatHorizontally, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    texture.upload(std::span<const unsigned char>(image.texels), image.components);
    return &(maps[file] = std::move(texture));
  }

  AirTables* air(const PlannedBody& body, std::string& key) {
    key.clear();
    if (body.atmosphere.empty()) return nullptr;
    Angle const sunRadius(kSolarRadiusIau.si / glm::length(body.sun.m));
    key = fmt::format("{} on {:.0f} m, Sun {:.4f} mrad", body.atmosphere, body.equatorialRadius.si,
                      1e3 * AirTables::discOf(sunRadius).si);
    auto& tables = airs[key];
    if (!tables) {
      Medium const medium = readMedium(mediumFile(body.atmosphere));
      tables = std::make_unique<AirTables>(medium, body.equatorialRadius, wavelengths, quality,
                                           sunRadius);
      ++tablesBuilt;
    }
    return tables.get();
  }

  // What the casters' own airs bend into their shadows; null for those without.
  std::vector<std::shared_ptr<RefractedShadowTable>> refractedTables(const PlannedBody& body,
                                                                     LimbDarkeningLaw law) {
    std::vector<std::shared_ptr<RefractedShadowTable>> tables;
    for (auto const& caster : body.casters) {
      if (caster.atmosphere.empty()) {
        tables.emplace_back();
        continue;
      }
      auto& table = refractedShadows[fmt::format("{} on {:.0f} m, Sun {:.0f} m, law {}",
                                                 caster.atmosphere, caster.radii.casterUmbra.si,
                                                 caster.radii.sun.si, static_cast<int>(law))];
      if (!table)
        table = std::make_shared<RefractedShadowTable>(readMedium(mediumFile(caster.atmosphere)),
                                                       caster.radii.casterUmbra, caster.radii.sun,
                                                       wavelengths, law);
      tables.push_back(table);
    }
    return tables;
  }
};

BodiesPass::BodiesPass(ImageSource images, const AirQuality& quality, bool exact)
    : state_(std::make_unique<State>(std::move(images), quality)) {
  state_->exact = exact;
}
BodiesPass::~BodiesPass() = default;

void BodiesPass::prepare(const PlannedBody& body, const Projection& picture, const Look& look) {
  auto& s = *state_;
  auto& resident = s.bodies[body.name];
  double const radius = body.equatorialRadius.si;
  double const flat = body.polarRadius / body.equatorialRadius;
  AirTables* const air = s.air(body, resident.air);

  glm::dvec3 const stretch(1.0, 1.0, 1.0 / flat);
  glm::dmat3 const& turn = body.bodyFromCamera.matrix;
  // Scaled-space position of the camera, and the Sun's direction there.
  glm::dvec3 const camera = stretch * (turn * -body.centre.m);
  double const cameraDistance = glm::length(camera);
  resident.up = camera / cameraDistance;
  resident.sun = glm::normalize(stretch * body.sun.m);

  gl::Definitions shadowFlags;
  resident.pairCount = static_cast<int>(body.casters.size());
  if (!body.casters.empty()) {
    std::vector<glsl::ShadowPair> pairs;
    for (auto const& caster : body.casters)
      pairs.push_back(shadowPair(body.sun, caster.centre, caster.radii, caster.figure));
    double const reach = radius + (air ? air->top().si : 0.0);
    auto const wanted = BodyShadows::definitions(pairs.size(), look.corona != nullptr);
    if (!resident.shadows || resident.shadows->definitions() != wanted ||
        resident.law != look.law || resident.illustrative != look.illustrative) {
      resident.shadows = std::make_unique<BodyShadows>(pairs, flat, look.law, s.wavelengths,
                                                       Length(reach), look.corona);
      resident.sky.reset();
      resident.eclipsed.reset();
    } else {
      resident.shadows->setCorona(look.corona);
      resident.shadows->update(pairs);
    }
    resident.law = look.law;
    resident.illustrative = look.illustrative;
    shadowFlags = wanted;
    bool const apart = shadowsStayApart(pairs, reach);
    if (apart != resident.apart) resident.sky.reset();
    resident.apart = apart;
    if (apart) shadowFlags.emplace_back("SHADOWS_APART", "");
    auto tables = s.refractedTables(body, look.law);
    if (std::any_of(tables.begin(), tables.end(), [](auto const& t) { return t != nullptr; })) {
      if (!resident.refracted || resident.refracted->tables() != tables)
        resident.refracted = std::make_unique<RefractedLight>(
            std::move(tables), static_cast<int>(s.wavelengths.size()), Length(reach));
      resident.refracted->update(pairs);
      auto const more = RefractedLight::definitions();
      shadowFlags.insert(shadowFlags.end(), more.begin(), more.end());
    } else {
      resident.refracted.reset();
    }
    // Flat colours mark the shadows of the illustrative look; its light is that without an eclipse.
    if (look.illustrative) {
      shadowFlags.emplace_back("UNECLIPSED", "");
      resident.eclipsed.reset();
    } else if (air) {
      if (!resident.eclipsed)
        resident.eclipsed = std::make_unique<EclipsedSource>(*air, look.law, pairs.size());
      resident.eclipsed->update(*air, pairs, flat);
      auto const more = resident.eclipsed->definitions();
      shadowFlags.insert(shadowFlags.end(), more.begin(), more.end());
    }
  } else if (resident.shadows) {
    resident.shadows.reset();
    resident.eclipsed.reset();
    resident.refracted.reset();
    resident.sky.reset();
  }

  auto definitions = gl::projectionDefinition(picture.kind);
  if (air) {
    definitions.insert(definitions.end(), air->definitions().begin(), air->definitions().end());
    definitions.emplace_back("AIR_SINGLE", "");
    definitions.emplace_back("AIR_SOURCE", "");
  } else {
    auto const none = s.vacuumDefinitions();
    definitions.insert(definitions.end(), none.begin(), none.end());
  }
  if (body.rings) {
    if (!resident.rings || !resident.rings->belongsTo(look.law))
      resident.rings = std::make_unique<Rings>(body.rings->system, look.law, s.wavelengths,
                                               s.vacuumDefinitions(), s.exact);
    resident.rings->update(body, picture);
    if (body.rings->shadeGlobe) {
      shadowFlags.emplace_back("RING_SHADOW", "");
      ++resident.pairCount;
    }
    if (!body.rings->bounds.empty()) ++resident.pairCount;
  }
  resident.skyShown = air && AirSky::serves(*air, body.cameraHeight);
  if (resident.skyShown) {
    if (!resident.sky) resident.sky = std::make_unique<AirSky>(*air, shadowFlags);
    definitions.emplace_back("AIR_SKY", "");
    repeatSky(body);
  }
  definitions.insert(definitions.end(), shadowFlags.begin(), shadowFlags.end());
  const gl::Texture* const colour = s.map(body.map, body.name + ", map", true);
  if (colour) definitions.emplace_back("SURFACE_MAP", "");
  if (s.map(body.waterMask, body.name + ", water_mask", false))
    definitions.emplace_back("WATER_MASK", "");
  if (s.map(body.nightMap, body.name + ", night_map", true))
    definitions.emplace_back("NIGHT_MAP", "");
  if (body.lommelSeeliger) definitions.emplace_back("SURFACE_LUNAR", "");
  if (look.illustrative) definitions.emplace_back("ILLUSTRATIVE", "");
  BodyBlock block{};
  glm::dmat3 const scaledFromCamera =
      glm::dmat3(stretch.x, 0, 0, 0, stretch.y, 0, 0, 0, stretch.z) * turn;
  glm::dmat3 const crossFromCross = glm::dmat3(stretch.z, 0, 0, 0, stretch.z, 0, 0, 0, 1) * turn;
  for (int i = 0; i < 3; ++i) {
    block.scaledFromCamera[i] = glm::vec4(glm::vec3(scaledFromCamera[i]), 0.0f);
    block.scaledCrossFromCross[i] = glm::vec4(glm::vec3(crossFromCross[i]), 0.0f);
  }
  double const distance = glm::length(body.centre.m);
  Direction<CameraAxes> const toCentre = directionOf(body.centre);
  glm::vec3 const prepared = gl::prepareDirection(picture.kind, toCentre);
  block.centre =
      glm::vec4(prepared, static_cast<float>(distance / glm::length(glm::dvec3(prepared))));
  block.up = glm::vec4(glm::vec3(resident.up), static_cast<float>(cameraDistance));
  double const h = body.cameraHeight.si;
  double const top = air ? air->top().si : 0.0;
  // Below the spheroid the camera is drawn from its surface.
  double const above = std::max(h, 0.01);
  block.heights =
      glm::vec4(above, above * (2.0 * radius + above), (above - top) * (2.0 * radius + above + top),
                h > 0.4 * radius ? 1.0 : 0.0);
  double const sunDistance = glm::length(body.sun.m);
  double const irradiance = std::pow(astronomicalUnit.si / sunDistance, 2.0);
  block.sun = glm::vec4(glm::vec3(resident.sun), static_cast<float>(irradiance));
  block.trueSun = glm::vec4(glm::vec3(body.sun.m / sunDistance),
                            static_cast<float>(kSolarRadiusIau.si / sunDistance));
  block.shape = glm::vec4(radius, flat, picture.pixelAngle().si, 0.0);
  block.albedo = glm::vec4(body.albedo, 0.0f);
  block.mapFactor = glm::vec4(body.mapFactor, colour ? static_cast<float>(colour->width()) : 1.0f);
  Angle const phase = angleBetween(directionOf(body.sun),
                                   Direction<BodyFixed>{glm::normalize(turn * -body.centre.m)});
  block.night =
      glm::vec4(body.nightLuminance, body.phaseLight / lommelSeeligerSphere(phase), 0.0, 0.0);
  // Of what shines from near the camera, the phase is that of full light.
  static double const solarLux = xyzOfRelativeRadiance([](Length) { return 1.0; }).y;
  block.shine = glm::vec4(glm::vec3(glm::normalize(stretch * body.shineDirection.u)),
                          static_cast<float>(body.shineLux / (solarLux * irradiance)));
  resident.block.write(block);

  // The edges of shadows in the air are everywhere.
  CoarseTiles const coarse{body.casters.empty() ? s.quality.airScale : 1, resident.skyShown};
  resident.tiles = bodyTiles(picture, body.bounds, scaledFromCamera, resident.up, resident.sun,
                             radius, above, top, air ? air->lowestSunCosine() : -1.0, coarse);
  constexpr std::array<const char*, kBodyParts> flags{"BODY_SUNLIT", "BODY_DUSK", "BODY_NIGHT",
                                                      "BODY_SKY",    "",          "BODY_SUNLIT",
                                                      "BODY_DUSK",   "BODY_SKY"};
  auto const programOf = [&](const gl::Definitions& own) {
    std::string const key = keyOf(own);
    if (!s.programs.count(key))
      s.programs[key] = gl::Program::render("passes/tiles.vert", "passes/body.frag", own);
    return key;
  };
  for (std::size_t part = 0; part < kBodyParts; ++part) {
    auto const& tiles = resident.tiles[part];
    if (tiles.empty()) continue;
    resident.corners[part].write(std::span<const glm::vec2>(tiles));
    auto own = definitions;
    if (*flags[part]) own.emplace_back(flags[part], "");
    if (isCoarse(part)) {
      auto samples = own;
      samples.emplace_back("AIR_SAMPLES", "");
      resident.samplers[part] = programOf(samples);
      resident.sampleCorners[part].write(
          std::span<const glm::vec2>(grown(tiles, static_cast<float>(s.quality.airScale))));
      own.emplace_back("AIR_SAMPLED", "");
    }
    resident.programs[part] = programOf(own);
  }
}

bool BodiesPass::repeatSky(const PlannedBody& body) {
  auto& s = *state_;
  auto const found = s.bodies.find(body.name);
  if (found == s.bodies.end() || !found->second.sky || !found->second.skyShown) return false;
  auto& resident = found->second;
  if (resident.shadows) resident.shadows->bind();
  if (resident.eclipsed) resident.eclipsed->bind();
  if (resident.refracted) resident.refracted->bind();
  resident.sky->update(*s.airs.at(resident.air), body.cameraHeight, resident.up, resident.sun);
  return true;
}

void BodiesPass::useAirScale(int pixels) { state_->quality.airScale = pixels; }

// Rectangles of the picture into the bound target, whose lower left corner is `origin`.
void BodiesPass::drawRectangles(State& s, const gl::Program& program, const gl::Buffer& corners,
                                std::size_t count, glm::ivec2 origin, glm::ivec2 size) {
  glBindVertexArray(s.vertexArray());
  glVertexArrayVertexBuffer(s.vertexArray(), 0, corners.id(), 0, sizeof(glm::vec2));
  program.set("tileOrigin", glm::vec2(origin)).set("targetSize", glm::vec2(size)).use();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(count));
  glBindVertexArray(0);
}

void BodiesPass::draw(const PlannedBody& body, const Projection& picture, glm::ivec2 tileOrigin,
                      glm::ivec2 targetSize) {
  auto& s = *state_;
  auto const& resident = s.bodies.at(body.name);
  PixelBounds const& b = body.bounds;
  glm::ivec2 const low = glm::max(glm::ivec2(b.x0, b.y0) - tileOrigin, glm::ivec2(0));
  glm::ivec2 const high = glm::min(glm::ivec2(b.x1, b.y1) - tileOrigin, targetSize);
  if (high.x <= low.x || high.y <= low.y) return;
  (void)picture;
  if (!resident.air.empty())
    s.airs.at(resident.air)->bind();
  else
    s.vacuum.bindUniform(1);
  if (resident.skyShown) resident.sky->bind();
  if (resident.shadows) resident.shadows->bind();
  if (resident.eclipsed) resident.eclipsed->bind();
  if (resident.refracted) resident.refracted->bind();
  if (body.rings && body.rings->shadeGlobe) resident.rings->bindShadow();
  resident.block.bindUniform(2);
  if (!body.map.empty()) s.maps.at(body.map).bind(0);
  if (!body.waterMask.empty()) s.maps.at(body.waterMask).bind(1);
  if (!body.nightMap.empty()) s.maps.at(body.nightMap).bind(9);
  s.nodes.bind();
  int const scale = s.quality.airScale;
  glm::vec3 grid(0.0f);
  bool sampled = false;
  for (std::size_t part = 0; part < kBodyParts; ++part)
    sampled = sampled || (isCoarse(part) && !resident.tiles[part].empty());
  if (sampled) {
    GLint before = 0;
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    s.samples.cover(tileOrigin, targetSize, scale);
    grid = glm::vec3(static_cast<float>(scale), glm::vec2(s.samples.origin));
    glm::ivec2 const size{s.samples.light.width(), s.samples.light.height()};
    s.samples.target.bind();
    for (std::size_t part = 0; part < kBodyParts; ++part)
      if (isCoarse(part) && !resident.tiles[part].empty())
        drawRectangles(s, s.programs.at(resident.samplers[part]).set("sampleGrid", grid),
                       resident.sampleCorners[part], resident.tiles[part].size(),
                       s.samples.origin * scale, size * scale);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    s.samples.light.bind(14);
    s.samples.transmittance.bind(15);
  }
  glEnable(GL_SCISSOR_TEST);
  glScissor(low.x, low.y, high.x - low.x, high.y - low.y);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_SRC1_COLOR);
  for (std::size_t part = 0; part < kBodyParts; ++part) {
    if (resident.tiles[part].empty()) continue;
    auto& program = s.programs.at(resident.programs[part]);
    if (isCoarse(part)) program.set("sampleGrid", grid);
    drawRectangles(s, program, resident.corners[part], resident.tiles[part].size(), tileOrigin,
                   targetSize);
  }
  glDisable(GL_BLEND);
  // Left at two sources, even disabled, drawing into two targets would be refused.
  glBlendFunc(GL_ONE, GL_ZERO);
  glDisable(GL_SCISSOR_TEST);
}

void BodiesPass::drawRings(const PlannedBody& body, RingsHalf half, glm::ivec2 tileOrigin,
                           glm::ivec2 targetSize) {
  auto& s = *state_;
  auto const& resident = s.bodies.at(body.name);
  s.vacuum.bindUniform(1);
  resident.block.bindUniform(2);
  resident.rings->draw(body.rings->bounds, half, tileOrigin, targetSize);
}

const AirTables* BodiesPass::airOf(const PlannedBody& body) const {
  auto const resident = state_->bodies.find(body.name);
  if (resident == state_->bodies.end()) return nullptr;
  auto const air = state_->airs.find(resident->second.air);
  return air == state_->airs.end() ? nullptr : air->second.get();
}

int BodiesPass::tablesBuilt() const { return state_->tablesBuilt; }

int BodiesPass::shadowPairs() const {
  int count = 0;
  for (auto const& [name, resident] : state_->bodies) count += resident.pairCount;
  return count;
}

std::vector<std::pair<std::string, std::size_t>> BodiesPass::residentBytes() const {
  std::vector<std::pair<std::string, std::size_t>> list;
  for (auto const& [name, tables] : state_->airs)
    list.emplace_back("air of " + name, tables->bytes());
  if (state_->samples.light)
    list.emplace_back("air of several pixels",
                      state_->samples.light.bytes() + state_->samples.transmittance.bytes());
  for (auto const& [name, map] : state_->maps) list.emplace_back("map " + name, map.bytes());
  for (auto const& [name, resident] : state_->bodies) {
    if (resident.shadows) list.emplace_back("shadows on " + name, resident.shadows->bytes());
    if (resident.eclipsed) list.emplace_back("eclipsed air of " + name, resident.eclipsed->bytes());
    if (resident.refracted)
      list.emplace_back("light refracted toward " + name, resident.refracted->bytes());
    if (resident.rings) list.emplace_back("rings of " + name, resident.rings->bytes());
    if (resident.sky) list.emplace_back("sky of " + name, resident.sky->bytes());
  }
  return list;
}

std::vector<std::pair<std::string, double>> BodiesPass::precomputeSeconds() const {
  std::vector<std::pair<std::string, double>> list;
  for (auto const& [name, tables] : state_->airs)
    list.emplace_back(name, tables->precomputeSeconds());
  for (auto const& [name, resident] : state_->bodies)
    if (resident.eclipsed) list.emplace_back("eclipse on " + name, resident.eclipsed->seconds());
  return list;
}

}  // namespace antumbra
