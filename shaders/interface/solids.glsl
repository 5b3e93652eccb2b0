// Where a line of sight first meets a body: spheroids without their air. Mirrors `SolidsBlock` in
// src/passes/cone_pass.cpp.
#ifndef INTERFACE_SOLIDS_GLSL
#define INTERFACE_SOLIDS_GLSL
#define MOST_SOLIDS 16

struct Solid {
  vec4 scaledFromCamera[3];  // columns: axes in which the spheroid is a sphere
  vec4 up;                   // there: unit vector from the centre to the camera; w: its distance, m
  vec4 heights;              // camera above the ground; its r^2 - R^2; R; 1 where far
};
layout(std140, binding = 11) uniform Solids {
  Solid solids[MOST_SOLIDS];
  int solidCount;
};

struct SolidMeeting {
  float distance;  // along the ray, m; 1e30 where it meets none
  float cover;     // share of the pixel that the body fills
};

// `ray`: unit vector of camera axes.
SolidMeeting meetSolid(int index, vec3 ray, float pixel) {
  SolidMeeting meeting;
  meeting.distance = 1e30;
  meeting.cover = 0.0;
  vec3 d = solids[index].scaledFromCamera[0].xyz * ray.x +
           solids[index].scaledFromCamera[1].xyz * ray.y +
           solids[index].scaledFromCamera[2].xyz * ray.z;
  float scale = 1.0 / length(d);
  d *= scale;
  vec3 up = solids[index].up.xyz;
  float away = solids[index].up.w;
  float radius = solids[index].heights.z;
  float rise = away * dot(up, d);
  if (rise >= 0.0) return meeting;
  float root;
  if (solids[index].heights.w > 0.5) {
    float b = away * length(cross(up, d));
    root = (radius - b) * (radius + b);
  } else {
    root = rise * rise - solids[index].heights.y;
  }
  meeting.cover = clamp(0.5 + root / (2.0 * radius * pixel * max(-rise, 1.0)), 0.0, 1.0);
  if (meeting.cover > 0.0) {
    float depth = sqrt(max(root, 0.0));
    meeting.distance = solids[index].heights.w > 0.5
                           ? (-rise - depth) * scale
                           : solids[index].heights.y / (depth - rise) * scale;
  }
  return meeting;
}
#endif
