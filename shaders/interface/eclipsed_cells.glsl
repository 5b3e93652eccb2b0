// The cells of the grid of eclipsed source light. Their sphere has the axes of a ShadowNode
// (eclipse/shadow_nodes.h): z to the Sun, x from the centre to the shadow's axis.
// With UNECLIPSED, cells for each of the Sun's zenith angles instead, without a shadow.
struct EclipsedCell {
  vec3 position;
  vec3 up;
  vec3 forward;   // horizontal, from which azimuths count
  vec3 side;      // up x forward
  vec3 sun;
  float height;
  float sunCosine;
};

uniform ivec3 cellCount;  // distances (or Sun's zenith angles), azimuths, heights

float cellHeight(int index) {
  float z = float(index) / float(cellCount.z - 1);
#ifdef AIR_HAZY
  z = levelRow(z).y;
#endif
  // The topmost lie a little inside, for rays to have air to cross.
  return airShape.y * min(z * z, 0.9999);
}

#ifdef UNECLIPSED
EclipsedCell eclipsedCell(ivec3 index) {
  EclipsedCell cell;
  cell.height = cellHeight(index.z);
  float x = float(index.x) / float(cellCount.x - 1);
  cell.sunCosine = sourceSunCosine(sunSpan(airShape.z), x);
  cell.sun = vec3(sqrt(max(1.0 - cell.sunCosine * cell.sunCosine, 0.0)), 0.0, cell.sunCosine);
  cell.up = vec3(0.0, 0.0, 1.0);
  cell.forward = vec3(1.0, 0.0, 0.0);
  cell.side = vec3(0.0, 1.0, 0.0);
  cell.position = cell.up * (airShape.x + cell.height);
  return cell;
}
#else
// `index`: distance, azimuth, height.
EclipsedCell eclipsedCell(ivec3 index) {
  EclipsedCell cell;
  cell.height = cellHeight(index.z);
  EclipsedAxis axis = eclipsedAxes[0];
  float distance = eclipsedDistance(axis, float(index.x) / float(cellCount.x - 1));
  float angle = kPi * float(index.y) / float(cellCount.y - 1);
  vec3 from = vec3(shadowPairs[0].foot.x + distance * cos(angle),
                   dot(axis.side.xyz, vec3(0.0, 1.0, 0.0)) * distance * sin(angle), 0.0);
  // The sunlit crossing of the line parallel to the axis with the sphere at that height, or the
  // point nearest to it.
  float radius = airShape.x + cell.height;
  float across = length(from);
  cell.up = normalize(vec3(from.xy, sqrt(max((radius - across) * (radius + across), 0.0))));
  cell.position = cell.up * radius;
  cell.sun = vec3(0.0, 0.0, 1.0);
  cell.sunCosine = cell.up.z;
  vec3 level = axis.forward.xyz - cell.up * dot(cell.up, axis.forward.xyz);
  cell.forward = level * inversesqrt(max(dot(level, level), 1e-12));
  cell.side = cross(cell.up, cell.forward);
  return cell;
}
#endif
