// The Sun's visible light at a list of points, as the passes look it up; for the tests.
#include "interface/shadows.glsl"
layout(local_size_x = 32) in;
layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 1) writeonly buffer Light { vec4 light[]; };
void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index < points.length()) light[index] = visibleSunlight(points[index].xyz, 0);
}
