// The cells of the grid of eclipsed source light: their places about the shadow's axis.
struct EclipsedCell {
  vec3 position;  // scaled space
  vec3 up;
  vec3 sunward;   // horizontal
  vec3 side;      // up x sunward
  float height;
  float sunCosine;
};

uniform ivec3 cellCount;  // distances, azimuths, heights

// `index`: distance, azimuth, height.
EclipsedCell eclipsedCell(ivec3 index) {
  AirShell shell = airShell();
  vec3 place = vec3(index) / vec3(cellCount - 1);
  EclipsedCell cell;
  cell.height = shell.top * min(place.z * place.z, 0.9999);
  float distance = eclipsedAcross.w *
                   sinh(place.x * inverseSinh(eclipsedSide.w / eclipsedAcross.w));
  float angle = place.y * kPi;
  ShadowPair pair = shadowPairs[0];
  vec3 across = eclipsedAcross.xyz * cos(angle) + eclipsedSide.xyz * sin(angle);
  vec3 toScaled = vec3(1.0, 1.0, 1.0 / shadowScale.x);
  vec3 from = fromCasterSpace(pair, pair.foot + across * distance) * toScaled;
  vec3 along = fromCasterSpace(pair, pair.axis) * toScaled;
  // The sunlit crossing of the line parallel to the axis with the sphere at that height, or the
  // point nearest to it.
  float a = dot(along, along);
  float b = dot(from, along);
  float radius = shell.radius + cell.height;
  float lengthFrom = length(from);
  float c = (lengthFrom - radius) * (lengthFrom + radius);
  float root = b * b - a * c;
  cell.position = from + along * ((-b - sqrt(max(root, 0.0))) / a);
  cell.up = normalize(cell.position);
  cell.position = cell.up * radius;
  cell.sunCosine = dot(cell.up, eclipsedSun.xyz);
  vec3 level = eclipsedSun.xyz - cell.up * cell.sunCosine;
  if (dot(level, level) < 1e-10) level = cross(cell.up, eclipsedSide.xyz);
  cell.sunward = normalize(level);
  cell.side = cross(cell.up, cell.sunward);
  return cell;
}
