// The OpenGL 4.5 functions, from GLVND's libOpenGL. Included by this room and the passes alone.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
