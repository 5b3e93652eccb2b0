// Light without the eclipse at the cells' heights, over the Sun's zenith angle: what the shares of an
// eclipse are of. The including program has the table, `uneclipsed`: by layer mean radiance and
// irradiance, binary logarithms.
vec2 uneclipsedPlace(float sunCosine, float heightIndex) {
  vec2 size = vec2(textureSize(uneclipsed, 0).xy);
  float x = sourceColumn(sunSpan(airShape.z), sunCosine);
  return vec2((x * (size.x - 1.0) + 0.5) / size.x, (heightIndex + 0.5) / size.y);
}
vec4 uneclipsedLight(vec2 place, int layer, int quantity) {
  return textureLod(uneclipsed, vec3(place, float(layer * 2 + quantity)), 0.0);
}
