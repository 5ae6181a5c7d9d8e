// The window: SDL and Dear ImGui translate events and show pictures, and do nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/model/result.h"
#include "harness/view/event_file.h"
#include "harness/view/session.h"

namespace fillrule::view {

struct WindowOptions {
  int pane_width = 400;  // room for each picture, pixels
  int pane_height = 400;
  // The keys and mouse of a file instead of the user's; a frame is 1/60 s then.
  std::optional<std::vector<RecordedInput>> events;
  std::string record_file;         // where the user's are written to; empty: nowhere
  std::optional<uint32_t> frames;  // ends after so many
  std::string screenshot_file;     // of the last frame, judged to the end; a .png
  bool benchmark = false;          // the camera turns on with each frame, and nothing waits for the screen
};

struct Shown {
  uint32_t frames = 0;
  double seconds = 0;          // of all frames
  double drawing_seconds = 0;  // of them, until the candidate's picture was there
};

// Until it is closed. The error of a system without a display says so.
Result<Shown> show(Session& session, const WindowOptions& options);

}  // namespace fillrule::view
