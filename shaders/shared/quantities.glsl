// Names of physical quantities for shared functions. In GLSL each is a float or a vec3 in the stated
// SI unit; in C++ the includer (as_cpp.h) says what they are: doubles, or dimension-checked scalars.
#ifndef SHARED_QUANTITIES_GLSL
#define SHARED_QUANTITIES_GLSL
#ifndef GLSL_AS_CPP
#define Number float        // dimensionless
#define Angle float         // rad
#define Length float        // m
#define Area float          // m^2
#define InverseLength float // 1/m
#define Position vec3       // m, in the frame that the parameter names
#define Direction vec3      // unit vector
#define Spectrum vec4       // one number for each of four wavelengths
#define Coefficients vec4   // of a polynomial of the third degree, the constant first
#define Colour vec3         // linear sRGB, cd/m^2 per channel or dimensionless
#define TableCoordinates vec2 // texture coordinates in [0, 1]
#define Index int
#endif
const Number kPi = 3.14159265358979323846;
#endif
