// The window itself: the command draws into a display of Xvfb's by recorded events, and its screenshots are looked
// at. The panes are compared to the byte; what is around them is text, whose edges are the OpenGL driver's affair.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "cases/model/temporary_folder.h"
#include "harness/mesh/texture.h"
#include "harness/view/layout.h"

namespace fillrule::view {
namespace {

using ::testing::HasSubstr;

// A display of its own, by whichever number is free; none where Xvfb is absent.
class Display {
 public:
  Display() {
    std::array<int, 2> pipe_ends{};
    if (pipe(pipe_ends.data()) != 0) return;
    process_ = fork();
    if (process_ == 0) {
      close(pipe_ends[0]);
      const std::string number = std::to_string(pipe_ends[1]);
      const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
      dup2(nothing, STDERR_FILENO);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1600x1000x24", "-nolisten", "tcp",
             nullptr);
      _exit(127);
    }
    close(pipe_ends[1]);
    // Its number, once it is there.
    std::array<char, 16> text{};
    ssize_t count = 0;
    for (ssize_t more = 1; more > 0 && count < 15 && (count == 0 || text[static_cast<size_t>(count) - 1] != '\n');) {
      more = read(pipe_ends[0], text.data() + count, 15 - static_cast<size_t>(count));
      count += std::max<ssize_t>(more, 0);
    }
    close(pipe_ends[0]);
    if (count > 1) name_ = fmt::format(":{}", std::string_view(text.data(), static_cast<size_t>(count) - 1));
  }
  ~Display() {
    if (process_ <= 0) return;
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
  }
  Display(const Display&) = delete;
  Display(Display&&) = delete;
  Display& operator=(const Display&) = delete;
  Display& operator=(Display&&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  pid_t process_ = -1;
  std::string name_;
};

struct Outcome {
  int exit_code = -1;
  std::string output;
};

// `environment`: as in "DISPLAY=:5".
Outcome run_command(const std::string& environment, const std::string& arguments) {
  const std::string line = fmt::format("env -u DISPLAY -u WAYLAND_DISPLAY -u SDL_VIDEODRIVER {} {} {} 2>&1",
                                       environment, FILLRULE_COMMAND, arguments);
  Outcome outcome;
  std::FILE* const pipe = popen(line.c_str(), "r");  // NOLINT(cert-env33-c): of words that are our own
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer{};
  for (size_t count = 0; (count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    outcome.output.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

using Pixels = std::vector<std::array<int, 3>>;  // 0 to 255

Pixels pixels_of(const std::string& path, const Rect& part) {
  const Result<Texture> image = mesh::read_texture(path, {});
  if (!image) {
    ADD_FAILURE() << to_string(image.error());
    return {};
  }
  const TextureLevel& level = image->levels.front();
  if (part.x + part.width > static_cast<int>(level.width) || part.y + part.height > static_cast<int>(level.height)) {
    ADD_FAILURE() << path << " is too small";
    return {};
  }
  Pixels pixels;
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) {
      const Texel& texel = level.texels[static_cast<size_t>(y) * level.width + static_cast<size_t>(x)];
      const auto byte = [&texel](size_t channel) { return static_cast<int>(std::lround(texel[channel] * 255)); };
      pixels.push_back({byte(0), byte(1), byte(2)});
    }
  }
  return pixels;
}

constexpr int kSide = 160;

Rect pane(int number) {
  const Rect window = window_of(kSide, kSide, 3);
  return panes_of(window.width, window.height, 3)[static_cast<size_t>(number)];
}

class WindowTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (display_.name().empty()) GTEST_SKIP() << "there is no Xvfb; ci/setup installs it";
  }

  [[nodiscard]] std::string file(const std::string& name) const { return folder_.path(name); }

  // The panes of a screenshot after the events of a file in golden/, beside those of a picture there.
  void expect_golden(const std::string& scene, const std::string& name, const std::string& title) {
    const std::string golden = FILLRULE_SOURCE_DIR "/harness/view/golden/" + name;
    const std::string shot = std::getenv("FILLRULE_RENEW_GOLDEN") != nullptr ? golden + ".png" : file("shot.png");
    const Outcome outcome =
        view(scene + " --events " + golden + ".events --frames 40 --size 160x160 --screenshot " + shot);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(title));
    EXPECT_EQ(pixels_of(shot, pane(0)), pixels_of(golden + ".png", pane(0))) << "candidate";
    EXPECT_EQ(pixels_of(shot, pane(2)), pixels_of(golden + ".png", pane(2))) << "difference";
  }

  [[nodiscard]] Outcome view(const std::string& arguments) const {
    return run_command("DISPLAY=" + display_.name(), "view --bake-to " + folder_.path() + " " + arguments);
  }

  Display display_;
  TemporaryFolder folder_;
};

TEST_F(WindowTest, ShowsWhatRenderWrites) {
  const std::string scene = "scenes/textured_cube";
  ASSERT_EQ(view(scene + " --frames 2 --size 160x160 --screenshot " + file("shot.png")).exit_code, 0);
  constexpr std::array<const char*, 2> kParties{"renderer", "lavapipe"};
  for (size_t i = 0; i < kParties.size(); ++i) {
    const std::string picture = file("picture.png");
    const Outcome rendered =
        run_command("", "render " + scene + " --size 160x160 --by " + std::string(kParties[i]) + " -o " + picture);
    ASSERT_EQ(rendered.exit_code, 0) << rendered.output;
    EXPECT_EQ(pixels_of(file("shot.png"), pane(static_cast<int>(i))), pixels_of(picture, {0, 0, kSide, kSide}))
        << kParties[i];
  }
}

TEST_F(WindowTest, MovesTheCameraAsRecorded) {
  expect_golden("scenes/textured_cube", "camera",
                "scenes/textured_cube: 0 mismatches of the candidate, 0 of the reference");
}

TEST_F(WindowTest, MovesTheModelAsRecordedAndBakesIt) {
  expect_golden("'scenes/cube[turn=15]'", "model",
                "scenes/cube[turn=15]: 0 mismatches of the candidate, 0 of the reference");
  const std::string baked = file("cube_view_1.toml");
  ASSERT_TRUE(std::filesystem::exists(baked));
  const Outcome run = run_command("", "run " + baked);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("1 case: 1 passed"));
}

TEST_F(WindowTest, MarksAMismatchOfACase) {
  expect_golden("'interpolation/noperspective_clipped[planes=3,w=4]'", "mismatch",
                "0 mismatches of the candidate, 1439 of the reference\nmismatch 2 of ");
}

TEST_F(WindowTest, WritesDownWhatIsDone) {
  const std::string golden = FILLRULE_SOURCE_DIR "/harness/view/golden/model.events";
  const Outcome outcome = view("'scenes/cube[turn=15]' --reference none --frames 40 --events " + golden +
                               " --record " + file("again.events"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const Outcome again = view("'scenes/cube[turn=15]' --reference none --frames 2 --events " + file("again.events"));
  EXPECT_EQ(again.exit_code, 0) << again.output;
}

TEST_F(WindowTest, TellsHowManyFramesThereAreInASecond) {
  const Outcome outcome = view("'scenes/cube[turn=15]' --reference none --frames 20 --benchmark");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.output, HasSubstr("20 frames in "));
}

TEST_F(WindowTest, RefusesWhatIsWrongBeforeAWindowOpens) {
  EXPECT_EQ(view("'scenes/cube[turn=15]' --benchmark").exit_code, 2);
  EXPECT_EQ(view("'scenes/source_a_*'").exit_code, 2);
  EXPECT_EQ(view("no_such.obj").exit_code, 2);
  EXPECT_EQ(view("'scenes/cube[turn=15]' --reference voodoo").exit_code, 3);
  EXPECT_THAT(view("'scenes/cube[turn=15]' --size 12").output, HasSubstr("--size takes WIDTHxHEIGHT"));
  const std::string events = file("bad.events");
  std::FILE* const written = std::fopen(events.c_str(), "w");
  ASSERT_NE(written, nullptr);
  ASSERT_GE(std::fputs("frame 1\npress lfet\n", written), 0);
  ASSERT_EQ(std::fclose(written), 0);
  const Outcome bad = view("'scenes/cube[turn=15]' --events " + events);
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.output, HasSubstr("bad.events:2:7: \"lfet\" is no mouse button"));
}

TEST(WindowWithoutDisplay, SaysSoAndPointsToRender) {
  for (const char* const environment : {"", "DISPLAY=:987"}) {
    const Outcome outcome = run_command(environment, "view 'scenes/cube[turn=15]' --reference none --frames 1");
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.output, HasSubstr("there is no display to open a window on"));
    EXPECT_THAT(outcome.output, HasSubstr("fillrule render SCENE -o out.png"));
  }
}

}  // namespace
}  // namespace fillrule::view
