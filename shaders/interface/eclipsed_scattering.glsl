// Light of the quadrature's directions averaged with the phase functions of precompute/eclipsed_phases.comp.
// The including program has the textures `light` and `phases`.
struct LightOfRing {
  vec4 of[ECLIPSED_TURNS_IN];  // by azimuth
};
struct PhaseOfRings {
  vec4 of[ECLIPSED_TURNS_IN + 1];  // by difference of azimuths, half steps from 0 to pi
};

LightOfRing lightOfRing(ivec2 cell, int ring, int layer) {
  LightOfRing found;
  int first = (layer * directionCount.x + ring) * ECLIPSED_TURNS_IN;
  for (int k = 0; k < ECLIPSED_TURNS_IN; ++k)
    found.of[k] = texelFetch(light, ivec3(cell, first + k), 0);
  return found;
}

PhaseOfRings phaseOfRings(int from, int toward, int height, int layer) {
  PhaseOfRings found;
  int first = (layer * cellCount.z + height) * (ECLIPSED_TURNS_IN + 1);
  for (int k = 0; k <= ECLIPSED_TURNS_IN; ++k)
    found.of[k] = texelFetch(phases, ivec3(from, toward, first + k), 0);
  return found;
}

// Of a difference of azimuths in half steps, between minus and plus a turn and a half.
int turnStep(int halfSteps) {
  int away = abs(halfSteps) % (2 * ECLIPSED_TURNS_IN);
  return min(away, 2 * ECLIPSED_TURNS_IN - away);
}
