// What eclipses the Sun at a point of the body in hand. Compiled out unless SHADOW_PAIRS, the number
// of casters with a live shadow, is defined. With CORONA_LIGHT the corona that the casters leave shines
// too.
#ifndef INTERFACE_SHADOWS_GLSL
#define INTERFACE_SHADOWS_GLSL
#ifdef SHADOW_PAIRS
#include "shared/several_casters.glsl"
#ifdef CORONA_LIGHT
#include "shared/corona.glsl"
#endif
// Software renderers compute every branch: casters whose penumbras nowhere meet do without the union.
#if SHADOW_PAIRS > 1 && !defined(SHADOWS_APART)
#define SHADOWS_UNITED
#endif
#define SHADOW_INNER 64

layout(std140, binding = 7) uniform Shadows {
  ShadowPair shadowPairs[SHADOW_PAIRS];
  vec4 shadowScale;  // x: polar over equatorial radius; y: greatest distance from the centre, m
#ifdef CORONA_LIGHT
  CoronaFit shadowCorona[SHADOW_PAIRS];
#endif
};
// Visible light of the limb-darkened disc over shadowLightScale, caster times AIR_LAYERS layers; y:
// shareAlongAxis. The first SHADOW_INNER texels of a row lie in the antumbra, over the distance from the
// axis; the others between the edge of umbra or antumbra and the penumbra's, over the square root of the
// share of the way. So the kinks at these edges lie between texels and stay sharp.
layout(binding = 8) uniform sampler2DArray shadowLight;
layout(std140, binding = 8) uniform ShadowLaws {
  LimbDarkening shadowLaws[AIR_LAYERS];
};

struct ShadowTablePlace {
  float inner;  // share of the antumbra's radius, 1 outside and where there is none
  float outer;  // square root of the share of the way from that edge to the penumbra's
  float along;  // from the foot of the axis, m
  float umbra;  // radius there, m; negative beyond the apex
};

ShadowTablePlace shadowTablePlace(ShadowPair pair, ShadowPlace place) {
  ShadowTablePlace found;
  found.along = place.along;
  found.umbra = umbraRadiusAt(pair, place);
  float edge = abs(found.umbra);
  float penumbra = penumbraRadiusAt(pair, place);
  found.inner = found.umbra < 0.0 ? min(place.distance / edge, 1.0) : 1.0;
  found.outer = sqrt(max((place.distance - edge) / (penumbra - edge), 0.0));
  return found;
}

// What the light varies like: in the antumbra the ring that is left on the axis, whose width is
// 1 - ratio of the angular radii, and beyond the edges the 3/2 power of the way from them.
float shadowLightScale(ShadowPair pair, ShadowTablePlace place, float exponent) {
  float scale = 2.5 * place.outer * place.outer * place.outer;
  float width = -place.umbra * pair.umbraCosine * (pair.sunBehind - pair.casterBehind) /
                ((pair.casterBehind + place.along) * pair.sunRadius);
  if (width > 0.0) {
    width = min(width, 1.0);
    scale += exp2((1.0 + 0.5 * exponent) * log2(width * (2.0 - width)));
  }
  return scale;
}

#include "interface/refracted_light.glsl"

// Sunlight past one caster at a place within its penumbra, from the table.
vec4 sunlightPast(int caster, ShadowTablePlace place, int layer) {
  vec2 size = vec2(textureSize(shadowLight, 0).xy);
  float column = place.inner < 1.0
                     ? place.inner * float(SHADOW_INNER - 1)
                     : float(SHADOW_INNER) + place.outer * (size.x - float(SHADOW_INNER + 1));
  float row = shareAlongAxis(place.along, shadowScale.y) * (size.y - 1.0);
  return shadowLightScale(shadowPairs[caster], place, shadowLaws[layer].exponent.y) *
         textureLod(shadowLight, vec3((vec2(column, row) + 0.5) / size,
                                      float(caster * AIR_LAYERS + layer)), 0.0);
}

#ifdef CORONA_LIGHT
// Binary logarithm of the corona's light past a caster, over the Sun's.
float coronaPast(int caster, ShadowPlace where) {
  float umbra = umbraRadiusAt(shadowPairs[caster], where);
  float across = where.distance < umbra ? where.distance / umbra : 1.0;
  float along = shareAlongAxis(where.along, shadowScale.y);
  return coronaPastCaster(shadowCorona[caster], along, across * across);
}
#endif

// Visible share of sunlight at a point (scaled space, metres from the centre): the union of the
// casters' discs where more than one covers a part of the Sun, and the corona past the one whose umbra
// leaves least of it (what others hide of it in partial phases, up to 0.4 of it, is left out).
vec4 visibleSunlight(vec3 scaled, int layer) {
  vec4 light = vec4(1.0);
#ifdef SHADOWS_UNITED
  vec4 least = vec4(1.0);
  SunCover cover = noCover();
  vec3 first = vec3(0.0);
#endif
#ifdef CORONA_LIGHT
  float corona = 0.0;
#endif
  for (int caster = 0; caster < SHADOW_PAIRS; ++caster) {
    ShadowPair pair = shadowPairs[caster];
    ShadowPlace where = placeInShadow(pair, scaled * vec3(1.0, 1.0, shadowScale.x));
#ifdef CORONA_LIGHT
    corona = min(corona, coronaPast(caster, where));
#endif
#ifdef REFRACTED_LIGHT
    if (refractedReach[caster].x > 0.0) {
      light *= refractedSunlight(caster, where, shadowScale.y, layer);
      continue;
    }
#endif
    ShadowTablePlace place = shadowTablePlace(pair, where);
    if (place.outer >= 1.0) continue;
#ifdef SHADOWS_UNITED
    // No shadow before the caster.
    if (pair.casterBehind + place.along < -pair.casterRadius) continue;
#endif
    vec4 past = sunlightPast(caster, place, layer);
#ifdef SHADOWS_UNITED
    if (place.umbra > 0.0 && place.outer <= 0.0) {
      least = vec4(0.0);
      continue;
    }
    vec3 toward = limbDirection(pair, where);
    if (cover.count == 0) first = toward;
    if (cover.count == kMostDiscs) {
      light *= past;
    } else {
      least = min(least, past);
      cover = withDisc(cover, discsAt(pair, where), turnBetween(pair, first, toward));
    }
#else
    light *= past;
#endif
  }
#ifdef SHADOWS_UNITED
  if (cover.count > 1) least = min(least, visibleFractionOfUnion(cover, shadowLaws[layer]));
  light *= least;
#endif
#ifdef CORONA_LIGHT
  light += vec4(exp2(corona));
#endif
  return light;
}
#endif
#endif
