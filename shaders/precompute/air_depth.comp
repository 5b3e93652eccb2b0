// Optical depth from each height and zenith angle to the top of the air: by spectral layer that of the
// rest, without forward peaks, then the true one.
#include "interface/air.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) writeonly uniform image2DArray depths;

// Pieces of a leg, each with all nodes. Where densities have edges, nodes over the whole leg miss 0.1
// of Titan's depth of 12, and light that has come so deep shows each hundredth.
#ifdef AIR_THICK
const int kPieces = 8;
#else
const int kPieces = 1;
#endif
vec4 depthOfLeg(AirLeg leg, int layer, bool withPeaks) {
  AirShell shell = airShell();
  // Even in haze by the cube: steps by level lose a fifth of the depth at tangent points.
  float whole = leg.highHeight - leg.lowHeight;
  vec2 texels = densityTexels();
  vec4 sum = vec4(0.0);
  for (int n = 0; n < kPieces * nodeCount.x; ++n) {
    int piece = n / nodeCount.x, i = n - piece * nodeCount.x;
    float u = (float(piece) + nodes[i].x) / float(kPieces);
    AirPoint p = pointOnLeg(shell, leg, 0.0, leg.lowHeight + whole * u * u * u);
    AirDensities d = densitiesAt(rootHeight(shell, p.height) * texels.x + texels.y);
    vec4 extinction = vec4(0.0);
    for (int c = 0; c < AIR_CONSTITUENTS; ++c) {
      int k = layer * AIR_CONSTITUENTS + c;
      extinction += (withPeaks ? airExtinction[k] : restExtinction(k)) * d.of[c];
    }
    sum += extinction * (nodes[i].y / float(kPieces) * 3.0 * whole * u * u / max(p.cosine, 1e-9));
  }
  return sum;
}

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  ivec3 size = imageSize(depths);
  if (texel.x >= size.x || texel.y >= size.y) return;
  bool withPeaks = texel.z >= AIR_LAYERS;
  int layer = withPeaks ? texel.z - AIR_LAYERS : texel.z;
  AirShell shell = airShell();
  HeightAndCosine at = heightAndCosineAt(shell, vec2(texel.xy) / vec2(size.xy - 1));
  float rise = (shell.radius + at.height) * at.cosine;
  AirLeg leg;
  leg.lowSunRise = 0.0;
  leg.lowDistance = 0.0;
  leg.sense = 1.0;
  leg.lowHeight = at.height;
  leg.lowRise = max(rise, 0.0);
  leg.highHeight = shell.top;
  vec4 sum;
  if (rise >= 0.0) {
    sum = depthOfLeg(leg, layer, withPeaks);
  } else {
    float square = squareAboveGround(shell, at.height) - rise * rise;
    leg.lowHeight = max(square, 0.0) / (shell.radius + sqrt(shell.radius * shell.radius + max(square, 0.0)));
    leg.lowRise = 0.0;
    sum = depthOfLeg(leg, layer, withPeaks);
    leg.highHeight = at.height;
    sum += depthOfLeg(leg, layer, withPeaks);
  }
  imageStore(depths, texel, sum);
}
