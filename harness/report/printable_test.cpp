#include "harness/report/printable.h"

#include <gtest/gtest.h>

namespace fillrule::report {
namespace {

TEST(Printable, PlainAndForeignTextStays) {
  EXPECT_EQ(printable("coverage/tie[x=1]"), "coverage/tie[x=1]");
  EXPECT_EQ(printable("Dreieck \xc3\xa4\xc3\xb6 \xe4\xb8\x89\xe8\xa7\x92"), "Dreieck äö 三角");
}

TEST(Printable, EscapeSequencesAndControlCharactersAreShown) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a\\x1b[2Jb");
  EXPECT_EQ(printable("a\nb\r\tc"), "a\\x0ab\\x0d\\x09c");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\u{9b}31m");  // CSI as one character
  EXPECT_EQ(printable("\x7f"), "\\x7f");
}

TEST(Printable, MarksThatTurnTheTextOrHideAreShown) {
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b"),
            "a\\u{202e}b");  // right-to-left override
  EXPECT_EQ(printable("a\xe2\x80\x8b"
                      "b"),
            "a\\u{200b}b");  // zero width space
  EXPECT_EQ(printable("a\xe2\x80\xa8"
                      "b"),
            "a\\u{2028}b");                           // line separator
  EXPECT_EQ(printable("\xef\xbf\xbf"), "\\u{ffff}");  // no XML may hold it
}

TEST(Printable, BytesThatAreNoUtf8AreShown) {
  EXPECT_EQ(printable("a\xff"
                      "b"),
            "a\\xffb");
  EXPECT_EQ(printable("\xe4\xb8"), "\\xe4\\xb8");           // cut off
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
}

TEST(Printable, TheEndsOfLinesStayWhereThereAreSeveral) {
  EXPECT_EQ(printable_lines("a\x1b\nb\n"), "a\\x1b\nb\n");
}

TEST(ColumnsOf, WideCharactersTakeTwoAndMarksNone) {
  EXPECT_EQ(columns_of("abc"), 3U);
  EXPECT_EQ(columns_of("三角"), 4U);
  EXPECT_EQ(columns_of("a\xcc\x88"), 1U);  // a, diaeresis
}

TEST(Shortened, TheMiddleGoes) {
  EXPECT_EQ(shortened("coverage/tie", 12), "coverage/tie");
  EXPECT_EQ(shortened("coverage/tie", 0), "coverage/tie");
  EXPECT_EQ(shortened("coverage/tie", 11), "cove.../tie");
  EXPECT_EQ(shortened("三角三角三角", 9), "三...角");
  EXPECT_EQ(shortened("coverage", 2), "co");
}

TEST(Wrapped, AtSpacesWithIndentation) {
  EXPECT_EQ(wrapped("  one two three four", 10, 4), "  one two\n    three\n    four");
  EXPECT_EQ(wrapped("one two", 0, 4), "one two");
  EXPECT_EQ(wrapped("one incomprehensible two", 8, 2), "one\n  incomprehensible\n  two");
  EXPECT_EQ(wrapped("", 8, 2), "");
}

}  // namespace
}  // namespace fillrule::report
