#include "harness/view/event_file.h"

#include <gmock/gmock.h>

#include "harness/view/actions.h"

namespace fillrule::view {
namespace {

using ::testing::HasSubstr;

TEST(EventFile, IsReadLineByLine) {
  const auto events = parse_events(
      "# a drag\n\nmove 10.5 -3   # from outside\npress middle\nframe 7\nrelease middle\nwheel -2\n"
      "key shift+up\ndown w\nup w\nwait\r\n",
      "e.txt");
  ASSERT_TRUE(events) << to_string(events.error());
  using Kind = Input::Kind;
  const auto key = [](Kind kind, const char* name, bool shift) {
    return RecordedInput{7, {.kind = kind, .key = name, .place = name, .shift = shift}};
  };
  const std::vector<RecordedInput> expected{{0, {.kind = Kind::kMove, .x = 10.5, .y = -3}},
                                            {0, {.kind = Kind::kPress, .button = MouseButton::kMiddle}},
                                            {7, {.kind = Kind::kRelease, .button = MouseButton::kMiddle}},
                                            {7, {.kind = Kind::kWheel, .y = -2}},
                                            key(Kind::kKeyDown, "up", true),
                                            key(Kind::kKeyUp, "up", true),
                                            key(Kind::kKeyDown, "w", false),
                                            key(Kind::kKeyUp, "w", false),
                                            {7, {.kind = Kind::kWait}}};
  EXPECT_EQ(*events, expected);
}

TEST(EventFile, IsWrittenAsItIsRead) {
  const std::string text =
      "frame 0\nmove 10.5 -3\npress left\nframe 7\nrelease left\nwheel -2\ndown shift+up\nup shift+up\n"
      "down ctrl+s\nwait\n";
  const auto events = parse_events(text, "e.txt");
  ASSERT_TRUE(events) << to_string(events.error());
  EXPECT_EQ(write_events(*events), text);
}

TEST(EventFile, TellsLineAndColumnOfWhatIsWrong) {
  const auto error_of = [](const std::string& text) {
    const auto events = parse_events("wait\n" + text, "e.txt");
    return events ? std::string("none") : to_string(events.error());
  };
  EXPECT_THAT(error_of("  mvoe 1 2"), HasSubstr("e.txt:2:3: \"mvoe\" is no event"));
  EXPECT_THAT(error_of("mvoe 1 2"), HasSubstr("did you mean \"move\"?"));
  EXPECT_THAT(error_of("move 1"), HasSubstr("e.txt:2:1: \"move\" needs 2 values"));
  EXPECT_THAT(error_of("move 1 2 3"), HasSubstr("e.txt:2:10: \"3\" is too much"));
  EXPECT_THAT(error_of("move 1 x2"), HasSubstr("e.txt:2:8: \"x2\" is no number"));
  EXPECT_THAT(error_of("move nan 2"), HasSubstr("e.txt:2:6: \"nan\" is no number"));
  EXPECT_THAT(error_of("wheel inf"), HasSubstr("\"inf\" is no number"));
  EXPECT_THAT(error_of("press lfet"), HasSubstr("e.txt:2:7: \"lfet\" is no mouse button"));
  EXPECT_THAT(error_of("key space"), HasSubstr("e.txt:2:5: no action has a key \"space\""));
  EXPECT_THAT(error_of("frame 5\nframe 4"), HasSubstr("e.txt:3:7: \"4\" is no frame from 5"));
  EXPECT_THAT(error_of("frame -1"), HasSubstr("is no frame"));
  EXPECT_THAT(error_of("frame 1.5"), HasSubstr("is no frame"));
  EXPECT_THAT(error_of("wait 3"), HasSubstr("is too much"));
  EXPECT_THAT(to_string(read_events("/no/such/file").error()), HasSubstr("/no/such/file: cannot be read"));
}

TEST(Actions, MeanOtherThingsAtOtherTimes) {
  const auto found = [](const Input& input, During during) {
    const ActionRow* const row = find_action(input, during);
    return row == nullptr ? std::string_view("nothing") : row->help;
  };
  const Input s{.kind = Input::Kind::kKeyDown, .key = "s", .place = "s"};
  EXPECT_THAT(found(s, During::kAnything), HasSubstr("scale"));
  EXPECT_THAT(found(s, During::kFlight), HasSubstr("backward"));
  // The key at the place of an American W, on a French keyboard.
  const Input z{.kind = Input::Kind::kKeyDown, .key = "z", .place = "w"};
  EXPECT_THAT(found(z, During::kFlight), HasSubstr("forward"));
  EXPECT_THAT(found(z, During::kTransform), HasSubstr("z alone"));
  EXPECT_THAT(found(z, During::kAnything), HasSubstr("nothing"));
  const Input left{.kind = Input::Kind::kPress, .button = MouseButton::kLeft};
  EXPECT_THAT(found(left, During::kAnything), HasSubstr("orbit"));
  EXPECT_THAT(found(left, During::kTransform), HasSubstr("leave the model"));
}

TEST(Actions, HaveOneMeaningForEachKeyAtATime) {
  const auto rows = actions();
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_FALSE(rows[i].help.empty());
    for (size_t j = 0; j < i; ++j) {
      const bool clash =
          rows[i].trigger == rows[j].trigger && rows[i].key == rows[j].key && rows[i].during == rows[j].during;
      EXPECT_FALSE(clash) << rows[i].key << ": " << rows[i].help << " and " << rows[j].help;
    }
  }
  EXPECT_EQ(help_lines().size(), rows.size());
}

}  // namespace
}  // namespace fillrule::view
