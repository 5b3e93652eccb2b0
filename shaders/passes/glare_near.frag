// Fills the table of glare_near.glsl.
#include "passes/glare_near.glsl"

uniform int sourceCount;
uniform float nearSide;  // texels
uniform float sourceSize;  // tangent: over which each part is blurred
uniform vec4 sources[64];  // place about the centroid in units of nearScale, share of the light

out float ratio;

void main() {
  vec2 u = 2.0 * gl_FragCoord.xy / nearSide - 1.0;
  vec2 q = u / (1.0 - min(abs(u), vec2(0.999)));
  float sum = 0.0;
  for (int i = 0; i < sourceCount; ++i) {
    vec2 d = q - sources[i].xy;
    float squared = dot(d, d) * nearScale * nearScale + sourceSize * sourceSize;
    sum += sources[i].z * pointHalo(squared);
  }
  ratio = sum / softHalo(dot(q, q) * nearScale * nearScale);
}
