// How long a piece of drawing takes, in milliseconds and in fill units.
//
// A software renderer's timer queries report nonsense, and a piece drawn alone after others would
// pay for them: so a piece is timed by the wall clock between two glFinish, repeated alone, and the
// median of at least seven is taken. The fill unit is shaders/bench/fill_unit.frag at the same size
// in the same run: sixteen dependent look-ups and exponentials per pixel.
#pragma once

#include <functional>

#include "gl/context.h"

namespace antumbra {

// Wall: what a viewer waits for. Processor: the time that all threads of this program computed,
// which on a software renderer is the work itself, whatever else the machine does.
enum class DrawClock { Wall, Processor };

// Median seconds of `draw` over `repeats` (at least 7), after one run to warm up.
double medianSeconds(const std::function<void()>& draw, int repeats = 7,
                     DrawClock clock = DrawClock::Wall);

// Seconds of one fill unit at this size.
double fillUnitSeconds(int width, int height, DrawClock clock = DrawClock::Wall);

}  // namespace antumbra
