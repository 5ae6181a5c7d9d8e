// SDL's events as Inputs.
#pragma once

#include <SDL_events.h>

#include <optional>

#include "harness/view/input.h"

namespace fillrule::view {

// None of an event that is no input, nor of a key that repeats, unless it is an arrow.
std::optional<Input> input_of(const SDL_Event& event);

}  // namespace fillrule::view
