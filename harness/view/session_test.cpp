#include "harness/view/session.h"

#include <gmock/gmock.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "cases/model/temporary_folder.h"
#include "harness/scene/model_scene.h"
#include "harness/scene/test_scenes.h"
#include "harness/view/bake.h"
#include "harness/view/latest_worker.h"

namespace fillrule::view {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Case case_named(const std::string& name) {
  format::Suite suite = format::load_suite(scene::kCases, std::vector{name});
  for (const Error& error : suite.errors) ADD_FAILURE() << to_string(error);
  if (suite.cases.empty()) ADD_FAILURE() << "no case " << name;
  return suite.cases.empty() ? Case{} : suite.cases.front();
}

Session session_of(const Case& one, const SessionOptions& options, int pane_width = 64, int pane_height = 64) {
  Result<Session> session = Session::create(one, options);
  if (!session) ADD_FAILURE() << to_string(session.error());
  const Rect window = window_of(pane_width, pane_height, session->pane_count());
  session->resize(window.width, window.height);
  session->settle();
  return std::move(*session);
}

SessionOptions alone() {
  return {.is_judged = false};
}

SessionOptions by_oracle() {
  SessionOptions options;
  options.run.reference = run::kNoReference;
  return options;
}

void press_key(Session& session, const std::string& key) {
  session.handle({.kind = Input::Kind::kKeyDown, .key = key, .place = key});
  session.handle({.kind = Input::Kind::kKeyUp, .key = key, .place = key});
  session.settle();
}

// In pixels of the first pane.
void move_mouse(Session& session, double x, double y) {
  const Rect room = session.panes().front().room;
  session.handle({.kind = Input::Kind::kMove, .x = room.x + x, .y = room.y + y});
}

std::vector<uint32_t> candidate_of(const Session& session) {
  const Image* const image = session.panes().front().image;
  if (image == nullptr) ADD_FAILURE() << session.status();
  return image == nullptr ? std::vector<uint32_t>() : image->rgba;
}

TEST(Session, ShowsTheColoursThatAreJudged) {
  scene::Assets assets;
  const scene::Painter painter = scene::renderer_painter({});
  size_t compared = 0;
  for (const Case& built : scene::suite_scenes("scenes/*", assets)) {
    const Target& target = built.target;
    const Session session =
        session_of(built, alone(), static_cast<int>(target.width), static_cast<int>(target.height));
    const Image expected =
        image_of(scene::picture_of(scene::painted(built, assets, painter), built.scene->background));
    ASSERT_EQ(candidate_of(session), expected.rgba) << built.name;
    ++compared;
  }
  EXPECT_GT(compared, 40U);
}

TEST(Session, DrawsAndJudgesWhatTheMouseHasTurned) {
  Session session = session_of(case_named("scenes/textured_cube"), {}, 80, 60);
  ASSERT_EQ(session.panes().size(), 3U);
  const std::vector<uint32_t> before = candidate_of(session);
  move_mouse(session, 40, 30);
  session.handle({.kind = Input::Kind::kPress});
  move_mouse(session, 52, 21);
  session.advance(1.0 / 60);
  const std::vector<uint32_t> after = candidate_of(session);
  EXPECT_NE(after, before);
  EXPECT_THAT(session.window_title(), EndsWith("judging"));
  EXPECT_THAT(session.panes()[2].title, HasSubstr("of an earlier view"));
  session.handle({.kind = Input::Kind::kRelease});
  session.handle({.kind = Input::Kind::kWait});
  EXPECT_THAT(session.window_title(),
              EndsWith("scenes/textured_cube: 0 mismatches of the candidate, 0 of the reference"));
  const Image& reference = *session.panes()[1].image;
  size_t apart = 0;
  for (size_t i = 0; i < after.size(); ++i) {
    for (uint32_t shift = 0; shift < 24; shift += 8) {
      const auto channel = [shift](uint32_t rgba) { return static_cast<int>(rgba >> shift & 0xFFU); };
      if (std::abs(channel(after[i]) - channel(reference.rgba[i])) > 2) ++apart;
    }
  }
  EXPECT_LE(apart, after.size() / 1000);
  EXPECT_EQ(session.panes()[2].title, "difference");
  press_key(session, "enter");
  EXPECT_EQ(candidate_of(session), before) << "reset";
}

TEST(Session, JumpsToTheFaultsOfTheReference) {
  Session session = session_of(case_named("interpolation/noperspective_clipped[planes=3,w=4]"), {});
  EXPECT_THAT(session.window_title(), EndsWith("0 mismatches of the candidate, 1439 of the reference"));
  EXPECT_EQ(session.mismatch(), nullptr);
  press_key(session, "n");
  ASSERT_NE(session.mismatch(), nullptr);
  EXPECT_EQ(session.mismatch()->y, 15U);
  EXPECT_THAT(session.status(), StartsWith("mismatch 1 of "));
  EXPECT_THAT(session.status(), HasSubstr("straight.x: reference fault, candidate 0.332228541, reference nan"));
  press_key(session, "n");
  EXPECT_THAT(session.status(), StartsWith("mismatch 2 of "));
}

TEST(Session, TellsTheFaultsOfACandidate) {
  SessionOptions options = by_oracle();
  options.run.candidate = "faults:edges_inclusive";
  Session session = session_of(case_named("coverage/shared_diagonal"), options);
  EXPECT_THAT(session.window_title(), ::testing::Not(HasSubstr(" 0 mismatches")));
  press_key(session, "n");
  EXPECT_THAT(session.status(), HasSubstr("candidate fault"));
}

TEST(Session, SaysThatACandidateHasNoColours) {
  SessionOptions options = alone();
  options.run.candidate = "faults:none";
  Session session = session_of(case_named("scenes/cube[turn=15]"), options);
  EXPECT_EQ(session.panes().front().image, nullptr);
  EXPECT_EQ(session.status(), "faults:none cannot draw in colour");
}

TEST(Session, AsksForASceneWhereACaseHasNone) {
  Session session = session_of(case_named("coverage/shared_diagonal"), by_oracle());
  ASSERT_EQ(session.panes().size(), 2U);
  const std::vector<uint32_t> before = candidate_of(session);
  for (const char* const key : {"f", "7", "g", "t"}) {
    press_key(session, key);
    EXPECT_THAT(session.status(), HasSubstr("needs a scene")) << key;
  }
  move_mouse(session, 10, 10);
  session.handle({.kind = Input::Kind::kPress});
  EXPECT_THAT(session.status(), HasSubstr("needs a scene"));
  session.handle({.kind = Input::Kind::kRelease});
  EXPECT_EQ(candidate_of(session), before);
  for (int i = 0; i < 300; ++i) session.handle({.kind = Input::Kind::kKeyDown, .key = "right", .place = "right"});
  session.settle();
  EXPECT_NE(candidate_of(session), before) << "nudged by more than a pixel";
  EXPECT_THAT(session.window_title(), HasSubstr("0 mismatches of the candidate"));
}

TEST(Session, SwitchesAndSwitchesBack) {
  Session session = session_of(case_named("scenes/textured_cube"), alone());
  const std::vector<uint32_t> before = candidate_of(session);
  for (const char* const key : {"w", "t", "l"}) {
    press_key(session, key);
    EXPECT_NE(candidate_of(session), before) << key;
    press_key(session, key);
    EXPECT_EQ(candidate_of(session), before) << key;
  }
  press_key(session, "c");
  EXPECT_THAT(session.status(), HasSubstr("culling"));
  EXPECT_EQ(session.window_title(), "fillrule view: scenes/textured_cube");
  press_key(session, "?");
  EXPECT_TRUE(session.shows_help());
  press_key(session, "ctrl+q");
  EXPECT_TRUE(session.is_over());
}

TEST(Session, MovesAModelByKeysAlone) {
  Session session = session_of(case_named("scenes/cube[turn=15]"), alone());
  const std::vector<uint32_t> before = candidate_of(session);
  press_key(session, "r");
  press_key(session, "y");
  for (int i = 0; i < 15; ++i) session.handle({.kind = Input::Kind::kKeyDown, .key = "right", .place = "right"});
  session.settle();
  EXPECT_EQ(session.status(), "rotate y");
  const std::vector<uint32_t> turned = candidate_of(session);
  EXPECT_NE(turned, before);
  press_key(session, "enter");
  EXPECT_EQ(candidate_of(session), turned) << "confirmed, not reset";
  EXPECT_EQ(session.status(), "");
  press_key(session, "s");
  move_mouse(session, 60, 60);
  session.settle();
  EXPECT_NE(candidate_of(session), turned);
  press_key(session, "escape");
  EXPECT_EQ(candidate_of(session), turned);
}

TEST(Session, FillsThePaneOrKeepsTheShapeOrTheFilesSize) {
  Session wide = session_of(case_named("scenes/textured_cube"), alone(), 90, 60);
  EXPECT_EQ(wide.panes().front().image->width, 90U);
  press_key(wide, "0");
  EXPECT_EQ(wide.panes().front().image->width, case_named("scenes/textured_cube").target.width);
  const Case box = case_named("scenes/source_a_orthographic");
  Session shaped = session_of(box, alone(), 300, 100);
  const Image& image = *shaped.panes().front().image;
  EXPECT_EQ(image.height, 100U);
  EXPECT_EQ(image.width, 100 * box.target.width / box.target.height) << "not stretched";
}

TEST(Session, BakesTheViewIntoACaseFile) {
  const TemporaryFolder folder;
  SessionOptions options = by_oracle();
  options.folder = folder.path();
  Session session = session_of(case_named("scenes/textured_cube"), options, 48, 48);
  move_mouse(session, 20, 20);
  session.handle({.kind = Input::Kind::kPress});
  move_mouse(session, 31, 23);
  session.handle({.kind = Input::Kind::kRelease});
  press_key(session, "ctrl+s");
  const std::string first = folder.path("textured_cube_view_1.toml");
  EXPECT_THAT(session.status(), StartsWith("baked: " + first));
  const format::Suite suite = format::load_suite(scene::kCases, std::vector{first});
  ASSERT_TRUE(suite.errors.empty()) << to_string(suite.errors.front());
  ASSERT_EQ(suite.cases.size(), 1U);
  const Case& baked = suite.cases.front();
  EXPECT_EQ(baked.scene, nullptr);
  EXPECT_EQ(baked.target.width, 48U);
  EXPECT_EQ(baked.title, "A view of scenes/textured_cube");
  ASSERT_EQ(baked.draws.size(), 1U);

  // Never over a file that is there.
  std::ofstream(folder.path("textured_cube_view_2.toml")) << "mine";
  press_key(session, "ctrl+s");
  EXPECT_THAT(session.status(), HasSubstr("textured_cube_view_3.toml"));
  EXPECT_EQ(std::filesystem::file_size(folder.path("textured_cube_view_2.toml")), 4U);
  // The same bits again.
  const format::Suite third =
      format::load_suite(scene::kCases, std::vector{folder.path("textured_cube_view_3.toml")});
  EXPECT_EQ(third.cases.at(0).draws[0].positions, baked.draws[0].positions);

  const Result<std::string> nowhere = bake(baked, "/no/such/folder");
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(to_string(nowhere.error()), HasSubstr("cannot be written"));
}

TEST(Session, CannotBeMadeOfWhatIsNotThere) {
  Case broken = case_named("scenes/cube[turn=15]");
  Scene scene = *broken.scene;
  scene.objects[0].mesh.text = "no_such_mesh";
  broken.scene = std::make_shared<const Scene>(scene);
  const auto session = Session::create(broken, alone());
  ASSERT_FALSE(session);
  EXPECT_THAT(to_string(session.error()), HasSubstr("no_such_mesh"));
  SessionOptions options;
  options.run.reference = "voodoo";
  EXPECT_FALSE(Session::create(case_named("scenes/cube[turn=15]"), options));
}

TEST(LatestWorker, DoesTheNewestAndDropsWhatLiesBetween) {
  std::atomic<bool> may_go = false;
  std::vector<int> done;
  LatestWorker<int, int> worker([&](const int& job) {
    while (!may_go) std::this_thread::yield();
    done.push_back(job);
    return job * 10;
  });
  EXPECT_FALSE(worker.take());
  for (int job = 1; job <= 100; ++job) worker.submit(job);
  may_go = true;
  worker.wait();
  EXPECT_EQ(worker.take(), 1000);
  EXPECT_FALSE(worker.take()) << "once";
  EXPECT_LE(done.size(), 2U);
}

TEST(Layout, LeavesRoomForEachPane) {
  const Rect window = window_of(300, 200, 3);
  const std::vector<Rect> panes = panes_of(window.width, window.height, 3);
  for (const Rect& pane : panes) {
    EXPECT_EQ(pane.width, 300);
    EXPECT_EQ(pane.height, 200);
  }
  EXPECT_EQ(panes[1].x, 300 + kGap);
  const Placement small = place(panes[1], 64, 64);
  EXPECT_EQ(small.scale, 3);
  EXPECT_EQ(small.rect, (Rect{.x = 304 + 54, .y = kBarHeight + 4, .width = 192, .height = 192}));
  EXPECT_EQ(small.picture_point({304 + 54 + 5, kBarHeight + 4}).x, 5.0 / 3);
  EXPECT_EQ(place(panes[0], 1000, 1000).scale, 1);
}

}  // namespace
}  // namespace fillrule::view
